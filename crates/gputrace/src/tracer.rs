//! The compiled tracer, and a request from beginning to end.

use crate::{GpuJob, GpuTraceError, shader};
use stratiform_gpu::{Gpu, Kernel};
use stratiform_transport::{Control, Share, TraceMedium, TraceRequest, Traced};

/// The tracer on a device.
#[derive(Debug)]
pub struct GpuTracer {
    pub(crate) gpu: Gpu,
    pub(crate) kernel: Kernel,
}

impl GpuTracer {
    /// Compiles the tracer for the device.
    ///
    /// # Errors
    /// [`GpuTraceError::Gpu`] if the device fails.
    pub fn new(gpu: &Gpu) -> Result<Self, GpuTraceError> {
        Self::of_text(gpu, &shader::text())
    }

    pub(crate) fn of_text(gpu: &Gpu, text: &str) -> Result<Self, GpuTraceError> {
        Ok(Self { gpu: gpu.clone(), kernel: shader::kernel(gpu, text)? })
    }

    /// The device: name, backend and driver of the adapter.
    pub fn adapter(&self) -> &str {
        self.gpu.adapter()
    }

    /// Traces `request` through `medium`.
    ///
    /// # Errors
    /// [`GpuTraceError`] for input out of domain, on cancellation, if the device fails, or if photons are not all accounted for.
    pub fn trace(
        &self,
        medium: &TraceMedium,
        request: &TraceRequest,
        control: Control<'_>,
    ) -> Result<Traced, GpuTraceError> {
        let job = GpuJob::new(self, medium, request)?;
        let mut part = job.part();
        job.trace(&mut part, Share::WHOLE, control, |_| ())?;
        Ok(part.finish()?)
    }
}
