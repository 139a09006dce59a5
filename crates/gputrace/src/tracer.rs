//! A request from beginning to end.

use crate::flock::Flock;
use crate::{BatchCounts, GpuTraceError, shader};
use stratiform_gpu::{Gpu, Kernel};
use stratiform_transport::{Control, Stop, TraceMedium, TraceRequest};

/// The tracer on a device, compiled.
#[derive(Debug)]
pub struct GpuTracer {
    gpu: Gpu,
    kernel: Kernel,
}

impl GpuTracer {
    /// Compiles the tracer for the device.
    ///
    /// # Errors
    /// [`GpuTraceError::Gpu`] if the device fails.
    pub fn new(gpu: &Gpu) -> Result<Self, GpuTraceError> {
        Ok(Self { gpu: gpu.clone(), kernel: shader::kernel(gpu)? })
    }

    /// Traces `request` through `medium`: counts per batch, slabs in ascending order.
    ///
    /// # Errors
    /// [`GpuTraceError`] for input out of domain, on cancellation, if the device fails, or if photons are not all accounted for.
    pub fn trace(
        &self,
        medium: &TraceMedium,
        request: &TraceRequest,
        control: Control<'_>,
    ) -> Result<Vec<BatchCounts>, GpuTraceError> {
        request.check()?;
        let mut tau = request.tau.clone();
        tau.sort_by(f64::total_cmp);
        let Stop::Photons(photons) = request.stop else { todo!() };
        let mut flock = Flock::new(&self.gpu, &self.kernel, medium, request, &tau, photons)?;
        flock.trace(0..photons, control)?;
        Ok(flock.batches())
    }
}
