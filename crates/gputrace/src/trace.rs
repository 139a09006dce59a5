//! A request from beginning to end.

use crate::tracer::Tracer;
use crate::{BatchCounts, GpuTraceError};
use stratiform_gpu::Gpu;
use stratiform_transport::{Control, Stop, TraceMedium, TraceRequest};

/// Traces `request` through `medium` on the device: counts per batch, slabs in ascending order.
///
/// # Errors
/// [`GpuTraceError`] for input out of domain, on cancellation, if the device fails, or if photons are not all accounted for.
pub fn trace_on_gpu(
    gpu: &Gpu,
    medium: &TraceMedium,
    request: &TraceRequest,
    control: Control<'_>,
) -> Result<Vec<BatchCounts>, GpuTraceError> {
    request.check()?;
    let mut tau = request.tau.clone();
    tau.sort_by(f64::total_cmp);
    let Stop::Photons(photons) = request.stop else { todo!() };
    let mut tracer = Tracer::new(gpu, medium, request, &tau, photons)?;
    tracer.trace(0..photons, control)?;
    Ok(tracer.batches())
}
