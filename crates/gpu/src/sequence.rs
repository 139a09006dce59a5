//! Several compute passes over buffers that stay on the device.

use crate::{Gpu, GpuError};
use pollster::block_on;
use wgpu::util::{BufferInitDescriptor, DeviceExt};
use wgpu::{BufferUsages, ErrorFilter};

/// Bytes on the device.
#[derive(Debug)]
pub struct Buffer {
    pub(crate) inner: wgpu::Buffer,
}

/// What a kernel does with one of its bindings.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Access {
    /// `var<uniform>`.
    Uniform,
    /// `var<storage, read>`.
    Read,
    /// `var<storage, read_write>`.
    Write,
}

/// A compiled entry point with the bindings of group 0 in order.
#[derive(Debug)]
pub struct Kernel {
    pipeline: wgpu::ComputePipeline,
    layout: wgpu::BindGroupLayout,
}

/// One dispatch of a sequence.
#[derive(Clone, Copy, Debug)]
pub struct Pass<'a> {
    /// What it is called in time tables.
    pub name: &'a str,
    /// What runs.
    pub kernel: &'a Kernel,
    /// Binding 0, 1, … of group 0.
    pub buffers: &'a [&'a Buffer],
    /// Workgroups.
    pub groups: [u32; 3],
}

impl Gpu {
    /// A buffer with these contents. Kernels may read and write it, and it can be read back.
    ///
    /// # Errors
    /// [`GpuError::BufferSize`] for no positive multiple of 4, [`GpuError::OutOfMemory`].
    pub fn upload(&self, contents: &[u8]) -> Result<Buffer, GpuError> {
        self.sized(contents.len(), || {
            let descriptor = BufferInitDescriptor { label: None, contents, usage: usages() };
            self.device.create_buffer_init(&descriptor)
        })
    }

    /// A buffer of zeros.
    ///
    /// # Errors
    /// Those of [`upload`](Self::upload).
    pub fn zeroed(&self, bytes: usize) -> Result<Buffer, GpuError> {
        self.sized(bytes, || {
            let size = bytes as wgpu::BufferAddress;
            let descriptor =
                wgpu::BufferDescriptor { label: None, size, usage: usages(), mapped_at_creation: false };
            self.device.create_buffer(&descriptor)
        })
    }

    /// Puts new contents at the start of a buffer.
    ///
    /// # Errors
    /// [`GpuError::BufferSize`] for no positive multiple of 4, or more than the buffer holds.
    pub fn replace(&self, buffer: &Buffer, contents: &[u8]) -> Result<(), GpuError> {
        let bytes = contents.len();
        if bytes == 0 || !bytes.is_multiple_of(4) || bytes as wgpu::BufferAddress > buffer.inner.size() {
            return Err(GpuError::BufferSize { binding: 0, bytes });
        }
        self.fault.check()?;
        self.queue.write_buffer(&buffer.inner, 0, contents);
        self.fault.check()
    }

    /// What a buffer holds.
    ///
    /// # Errors
    /// [`GpuError::Failed`] if the device does.
    pub fn download(&self, buffer: &Buffer) -> Result<Vec<u8>, GpuError> {
        self.fault.check()?;
        let size = buffer.inner.size();
        let usage = BufferUsages::MAP_READ | BufferUsages::COPY_DST;
        let descriptor = wgpu::BufferDescriptor { label: None, size, usage, mapped_at_creation: false };
        let readback = self.device.create_buffer(&descriptor);
        let mut encoder = self.device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        encoder.copy_buffer_to_buffer(&buffer.inner, 0, &readback, 0, size);
        self.queue.submit([encoder.finish()]);
        self.read(&readback)
    }

    /// Compiles `entry` of the module `wgsl`, whose group 0 has exactly these bindings.
    ///
    /// # Errors
    /// [`GpuError::Refused`] with the compiler's message.
    pub fn kernel(&self, wgsl: &str, entry: &str, bindings: &[Access]) -> Result<Kernel, GpuError> {
        self.fault.check()?;
        let scope = self.device.push_error_scope(ErrorFilter::Validation);
        let layout = self.group_layout(bindings);
        let pipeline = self.device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
            label: Some(entry),
            bind_group_layouts: &[Some(&layout)],
            immediate_size: 0,
        });
        let source = wgpu::ShaderSource::Wgsl(wgsl.into());
        let module = wgpu::ShaderModuleDescriptor { label: Some(entry), source };
        let module = self.device.create_shader_module(module);
        let pipeline = self.pipeline(&module, entry, Some(&pipeline));
        self.fault.explain(match block_on(scope.pop()) {
            Some(error) => Err(GpuError::Refused { reason: error.to_string() }),
            None => Ok(Kernel { pipeline, layout }),
        })
    }

    /// Runs passes one after the other in one submission, each seeing what those before it wrote. Does not wait.
    ///
    /// # Errors
    /// [`GpuError::Refused`] if a pass does not fit its kernel.
    pub fn submit_passes(&self, passes: &[Pass]) -> Result<(), GpuError> {
        self.encode(passes, None)
    }

    /// Runs passes and measures the device's time for each, in seconds; `None` where the adapter has no time stamps. Waits.
    ///
    /// # Errors
    /// [`GpuError::Refused`] if a pass does not fit its kernel, [`GpuError::Failed`] if the device fails.
    pub fn time_passes(&self, passes: &[Pass]) -> Result<Option<Vec<f64>>, GpuError> {
        if !self.device.features().contains(wgpu::Features::TIMESTAMP_QUERY) {
            self.submit_passes(passes)?;
            self.wait()?;
            return Ok(None);
        }
        let marks = 2 * passes.len();
        #[allow(clippy::cast_possible_truncation, reason = "a handful of passes")]
        let count = marks as u32;
        let ty = wgpu::QueryType::Timestamp;
        let queries = self.device.create_query_set(&wgpu::QuerySetDescriptor { label: None, ty, count });
        self.encode(passes, Some(&queries))?;
        let bytes = self.resolve(&queries, count)?;
        let ticks: Vec<u64> = bytes
            .chunks_exact(8)
            .map(|chunk| chunk.iter().rev().fold(0_u64, |sum, byte| (sum << 8) | u64::from(*byte)))
            .collect();
        let period = f64::from(self.queue.get_timestamp_period()) * 1e-9;
        Ok(Some(ticks.chunks_exact(2).map(|pair| pair[1].saturating_sub(pair[0]) as f64 * period).collect()))
    }

    /// Until all that was submitted is done.
    ///
    /// # Errors
    /// [`GpuError::Failed`] if the device does.
    pub fn wait(&self) -> Result<(), GpuError> {
        let waited = self.device.poll(wgpu::PollType::wait_indefinitely());
        self.fault.explain(waited.map(|_| ()).map_err(GpuError::failed))
    }

    fn sized(&self, bytes: usize, make: impl FnOnce() -> wgpu::Buffer) -> Result<Buffer, GpuError> {
        if bytes == 0 || !bytes.is_multiple_of(4) {
            return Err(GpuError::BufferSize { binding: 0, bytes });
        }
        let limit = self.device.limits().max_storage_buffer_binding_size;
        if bytes as u64 > limit {
            return Err(GpuError::OutOfMemory {
                bytes,
                reason: format!("the device binds {limit} bytes at most"),
            });
        }
        self.fault.check()?;
        let scope = self.device.push_error_scope(ErrorFilter::OutOfMemory);
        let inner = make();
        self.fault.explain(match block_on(scope.pop()) {
            Some(error) => Err(GpuError::OutOfMemory { bytes, reason: error.to_string() }),
            None => Ok(Buffer { inner }),
        })
    }

    fn group_layout(&self, bindings: &[Access]) -> wgpu::BindGroupLayout {
        let entry = |(binding, access): (u32, &Access)| wgpu::BindGroupLayoutEntry {
            binding,
            visibility: wgpu::ShaderStages::COMPUTE,
            ty: wgpu::BindingType::Buffer {
                ty: match access {
                    Access::Uniform => wgpu::BufferBindingType::Uniform,
                    Access::Read => wgpu::BufferBindingType::Storage { read_only: true },
                    Access::Write => wgpu::BufferBindingType::Storage { read_only: false },
                },
                has_dynamic_offset: false,
                min_binding_size: None,
            },
            count: None,
        };
        let entries: Vec<_> = (0..).zip(bindings).map(entry).collect();
        let descriptor = wgpu::BindGroupLayoutDescriptor { label: None, entries: &entries };
        self.device.create_bind_group_layout(&descriptor)
    }

    fn encode(&self, passes: &[Pass], queries: Option<&wgpu::QuerySet>) -> Result<(), GpuError> {
        self.fault.check()?;
        let scope = self.device.push_error_scope(ErrorFilter::Validation);
        let mut encoder = self.device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        for (index, pass) in (0_u32..).zip(passes) {
            let group = self.group(pass);
            let timestamp_writes = queries.map(|query_set| wgpu::ComputePassTimestampWrites {
                query_set,
                beginning_of_pass_write_index: Some(2 * index),
                end_of_pass_write_index: Some(2 * index + 1),
            });
            let descriptor = wgpu::ComputePassDescriptor { label: Some(pass.name), timestamp_writes };
            let mut compute = encoder.begin_compute_pass(&descriptor);
            compute.set_pipeline(&pass.kernel.pipeline);
            compute.set_bind_group(0, &group, &[]);
            let [x, y, z] = pass.groups;
            compute.dispatch_workgroups(x, y, z);
        }
        self.queue.submit([encoder.finish()]);
        self.fault.explain(match block_on(scope.pop()) {
            Some(error) => Err(GpuError::Refused { reason: error.to_string() }),
            None => Ok(()),
        })
    }

    fn group(&self, pass: &Pass) -> wgpu::BindGroup {
        let entries: Vec<_> = (0..)
            .zip(pass.buffers)
            .map(|(binding, buffer)| wgpu::BindGroupEntry {
                binding,
                resource: buffer.inner.as_entire_binding(),
            })
            .collect();
        let layout = &pass.kernel.layout;
        self.device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some(pass.name),
            layout,
            entries: &entries,
        })
    }

    fn resolve(&self, queries: &wgpu::QuerySet, count: u32) -> Result<Vec<u8>, GpuError> {
        let size = 8 * wgpu::BufferAddress::from(count);
        let buffer = |usage| {
            let descriptor = wgpu::BufferDescriptor { label: None, size, usage, mapped_at_creation: false };
            self.device.create_buffer(&descriptor)
        };
        let resolved = buffer(BufferUsages::QUERY_RESOLVE | BufferUsages::COPY_SRC);
        let readback = buffer(BufferUsages::MAP_READ | BufferUsages::COPY_DST);
        let mut encoder = self.device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        encoder.resolve_query_set(queries, 0..count, &resolved, 0);
        encoder.copy_buffer_to_buffer(&resolved, 0, &readback, 0, size);
        self.queue.submit([encoder.finish()]);
        self.read(&readback)
    }
}

fn usages() -> BufferUsages {
    BufferUsages::STORAGE | BufferUsages::UNIFORM | BufferUsages::COPY_SRC | BufferUsages::COPY_DST
}
