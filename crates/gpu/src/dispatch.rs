//! One dispatch: upload, run, read back.

use crate::{Gpu, GpuError};
use pollster::block_on;
use std::sync::mpsc;
use wgpu::util::{BufferInitDescriptor, DeviceExt};
use wgpu::{BufferUsages, PollType};

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
        let sizes = bindings.iter().map(|bytes| bytes.len()).chain([output_bytes]);
        if let Some((binding, bytes)) = sizes.enumerate().find(|(_, bytes)| bytes % 4 != 0 || *bytes == 0) {
            return Err(GpuError::BufferSize { binding, bytes });
        }
        let scope = self.device.push_error_scope(wgpu::ErrorFilter::Validation);
        let pipeline = self.pipeline(wgsl, entry);
        let output = self.empty_buffer(output_bytes, BufferUsages::STORAGE | BufferUsages::COPY_SRC);
        let readback = self.empty_buffer(output_bytes, BufferUsages::MAP_READ | BufferUsages::COPY_DST);
        let group = self.bind(&pipeline, bindings, &output);
        self.submit(&pipeline, &group, &output, &readback, groups);
        if let Some(error) = block_on(scope.pop()) {
            return Err(GpuError::Refused { reason: error.to_string() });
        }
        self.read(&readback)
    }

    fn pipeline(&self, wgsl: &str, entry: &str) -> wgpu::ComputePipeline {
        let source = wgpu::ShaderSource::Wgsl(wgsl.into());
        let module =
            self.device.create_shader_module(wgpu::ShaderModuleDescriptor { label: Some(entry), source });
        self.device.create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
            label: Some(entry),
            layout: None,
            module: &module,
            entry_point: Some(entry),
            compilation_options: wgpu::PipelineCompilationOptions::default(),
            cache: None,
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

    fn read(&self, buffer: &wgpu::Buffer) -> Result<Vec<u8>, GpuError> {
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
