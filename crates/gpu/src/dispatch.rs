//! One dispatch: upload, run, read back.

use crate::{Gpu, GpuError};
use pollster::block_on;
use std::sync::mpsc;
use wgpu::util::{BufferInitDescriptor, DeviceExt};
use wgpu::{BufferUsages, PollType};

/// Buffers of these sizes can be made.
fn sizes(bindings: &[&[u8]], output_bytes: usize) -> Result<(), GpuError> {
    let sizes = bindings.iter().map(|bytes| bytes.len()).chain([output_bytes]);
    match sizes.enumerate().find(|(_, bytes)| bytes % 4 != 0 || *bytes == 0) {
        Some((binding, bytes)) => Err(GpuError::BufferSize { binding, bytes }),
        None => Ok(()),
    }
}

impl Gpu {
    /// Runs `entry` of the module `wgsl` on `groups` workgroups. In group 0, `bindings` are read-only storage
    /// buffers 0, 1, …, and the next number is the output, a zeroed writable storage buffer of `output_bytes`.
    ///
    /// # Errors
    /// [`GpuError`] if a size is no positive multiple of 4, the shader is not valid, or the device fails.
    pub fn run(
        &self,
        wgsl: &str,
        entry: &str,
        bindings: &[&[u8]],
        output_bytes: usize,
        groups: [u32; 3],
    ) -> Result<Vec<u8>, GpuError> {
        sizes(bindings, output_bytes)?;
        let pipeline = || {
            let source = wgpu::ShaderSource::Wgsl(wgsl.into());
            let module = wgpu::ShaderModuleDescriptor { label: Some(entry), source };
            self.pipeline(&self.device.create_shader_module(module), entry, None)
        };
        self.dispatch(pipeline, bindings, output_bytes, groups)
    }

    /// As [`run`](Self::run), with the module in SPIR-V, which the driver gets as it is.
    ///
    /// # Safety
    /// Nothing checks the module. It must be valid for Vulkan 1.1, use no more than these bindings, and stay within them.
    ///
    /// # Errors
    /// [`GpuError`] if a size is no positive multiple of 4, the driver takes no SPIR-V, or the device fails.
    #[allow(unsafe_code, reason = "a binary module is what the driver makes of it")]
    pub unsafe fn run_spirv(
        &self,
        spirv: &[u32],
        entry: &str,
        bindings: &[&[u8]],
        output_bytes: usize,
        groups: [u32; 3],
    ) -> Result<Vec<u8>, GpuError> {
        sizes(bindings, output_bytes)?;
        if !self.device.features().contains(wgpu::Features::PASSTHROUGH_SHADERS) {
            return Err(GpuError::NoSpirv { adapter: self.adapter.clone() });
        }
        let pipeline = || {
            // The workgroup's size stands in the module; drivers that would need it here take no SPIR-V.
            let start = wgpu::PassthroughShaderEntryPoint { name: entry.into(), workgroup_size: (0, 0, 0) };
            let descriptor = wgpu::ShaderModuleDescriptorPassthrough {
                label: Some(entry),
                entry_points: vec![start].into(),
                spirv: Some(spirv.into()),
                ..Default::default()
            };
            // SAFETY: the caller vouches for the module.
            let module = unsafe { self.device.create_shader_module_passthrough(descriptor) };
            self.pipeline(&module, entry, Some(&self.storage_layout(bindings.len())))
        };
        self.dispatch(pipeline, bindings, output_bytes, groups)
    }

    fn dispatch(
        &self,
        pipeline: impl FnOnce() -> wgpu::ComputePipeline,
        bindings: &[&[u8]],
        output_bytes: usize,
        groups: [u32; 3],
    ) -> Result<Vec<u8>, GpuError> {
        self.fault.check()?;
        let scope = self.device.push_error_scope(wgpu::ErrorFilter::Validation);
        let pipeline = pipeline();
        let output = self.empty_buffer(output_bytes, BufferUsages::STORAGE | BufferUsages::COPY_SRC);
        let readback = self.empty_buffer(output_bytes, BufferUsages::MAP_READ | BufferUsages::COPY_DST);
        let group = self.bind(&pipeline, bindings, &output);
        self.submit(&pipeline, &group, &output, &readback, groups);
        if let Some(error) = block_on(scope.pop()) {
            return Err(GpuError::Refused { reason: error.to_string() });
        }
        self.read(&readback)
    }

    pub(crate) fn pipeline(
        &self,
        module: &wgpu::ShaderModule,
        entry: &str,
        layout: Option<&wgpu::PipelineLayout>,
    ) -> wgpu::ComputePipeline {
        self.device.create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
            label: Some(entry),
            layout,
            module,
            entry_point: Some(entry),
            compilation_options: wgpu::PipelineCompilationOptions::default(),
            cache: None,
        })
    }

    /// Read-only storage buffers 0 to `inputs` - 1, and a writable one after them.
    fn storage_layout(&self, inputs: usize) -> wgpu::PipelineLayout {
        let entry = |binding: usize| wgpu::BindGroupLayoutEntry {
            #[allow(clippy::cast_possible_truncation, reason = "a handful of buffers")]
            binding: binding as u32,
            visibility: wgpu::ShaderStages::COMPUTE,
            ty: wgpu::BindingType::Buffer {
                ty: wgpu::BufferBindingType::Storage { read_only: binding < inputs },
                has_dynamic_offset: false,
                min_binding_size: None,
            },
            count: None,
        };
        let entries: Vec<_> = (0..=inputs).map(entry).collect();
        let group = wgpu::BindGroupLayoutDescriptor { label: None, entries: &entries };
        let group = self.device.create_bind_group_layout(&group);
        self.device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
            label: None,
            bind_group_layouts: &[Some(&group)],
            immediate_size: 0,
        })
    }

    fn empty_buffer(&self, bytes: usize, usage: BufferUsages) -> wgpu::Buffer {
        let size = bytes as wgpu::BufferAddress;
        self.device.create_buffer(&wgpu::BufferDescriptor {
            label: None,
            size,
            usage,
            mapped_at_creation: false,
        })
    }

    fn bind(
        &self,
        pipeline: &wgpu::ComputePipeline,
        bindings: &[&[u8]],
        output: &wgpu::Buffer,
    ) -> wgpu::BindGroup {
        let upload = |contents: &&[u8]| {
            let usage = BufferUsages::STORAGE;
            self.device.create_buffer_init(&BufferInitDescriptor { label: None, contents, usage })
        };
        let inputs: Vec<_> = bindings.iter().map(upload).collect();
        let buffers = inputs.iter().chain([output]);
        let entries: Vec<_> = (0..)
            .zip(buffers)
            .map(|(binding, buffer)| wgpu::BindGroupEntry { binding, resource: buffer.as_entire_binding() })
            .collect();
        self.device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: None,
            layout: &pipeline.get_bind_group_layout(0),
            entries: &entries,
        })
    }

    fn submit(
        &self,
        pipeline: &wgpu::ComputePipeline,
        group: &wgpu::BindGroup,
        output: &wgpu::Buffer,
        readback: &wgpu::Buffer,
        [x, y, z]: [u32; 3],
    ) {
        let mut encoder = self.device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        {
            let mut pass = encoder.begin_compute_pass(&wgpu::ComputePassDescriptor::default());
            pass.set_pipeline(pipeline);
            pass.set_bind_group(0, group, &[]);
            pass.dispatch_workgroups(x, y, z);
        }
        encoder.copy_buffer_to_buffer(output, 0, readback, 0, output.size());
        self.queue.submit([encoder.finish()]);
    }

    pub(crate) fn read(&self, buffer: &wgpu::Buffer) -> Result<Vec<u8>, GpuError> {
        self.fault.explain(self.mapped(buffer))
    }

    fn mapped(&self, buffer: &wgpu::Buffer) -> Result<Vec<u8>, GpuError> {
        let (sender, receiver) = mpsc::channel();
        buffer.map_async(wgpu::MapMode::Read, .., move |result| {
            // The receiver lives until the result has come.
            let _ = sender.send(result);
        });
        self.device.poll(PollType::wait_indefinitely()).map_err(GpuError::failed)?;
        receiver.recv().map_err(GpuError::failed)?.map_err(GpuError::failed)?;
        let view = buffer.get_mapped_range(..).map_err(GpuError::failed)?;
        Ok(view.to_vec())
    }
}
