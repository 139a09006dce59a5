//! Where photons are traced: on the processor, or on a graphics device. Without the cargo feature `gpu` the second says how to get it.

use super::Engine;
use crate::CliError;
use crate::args::{Device as Wanted, Estimator, TraceArgs};
#[cfg(feature = "gpu")]
use crate::pipeline;
#[cfg(feature = "gpu")]
use stratiform_gputrace::{GpuJob, GpuTraceError, GpuTracer};
#[cfg(feature = "gpu")]
use stratiform_transport::{Control, Part, Share};
use stratiform_transport::{TraceMedium, TraceRequest};

/// A device, open.
pub enum Device {
    /// The processor.
    Cpu,
    /// A graphics device.
    #[cfg(feature = "gpu")]
    Gpu(GpuTracer),
}

impl Device {
    /// Opens the device that `args` name.
    ///
    /// # Errors
    /// [`CliError::Input`] if it is missing or fails, if this program was built without it, or if it cannot trace what is asked for.
    pub fn open(args: &TraceArgs) -> Result<Self, CliError> {
        match args.device {
            Wanted::Cpu => Ok(Self::Cpu),
            Wanted::Gpu if args.estimator == Some(Estimator::Plain) => Err(CliError::Input(
                "--device gpu with --estimator plain: it has the half-space tracer only".to_owned(),
            )),
            Wanted::Gpu => open_gpu(),
        }
    }

    /// The adapter of a graphics device.
    pub fn adapter(&self) -> Option<String> {
        match self {
            Self::Cpu => None,
            #[cfg(feature = "gpu")]
            Self::Gpu(tracer) => Some(tracer.adapter().to_owned()),
        }
    }

    /// The device set up for one request; `None` for the processor.
    ///
    /// # Errors
    /// [`CliError::Input`] naming what is out of domain.
    #[cfg_attr(not(feature = "gpu"), allow(unused_variables, reason = "only the processor is there"))]
    pub fn engine<'a>(
        &'a self,
        medium: &'a TraceMedium,
        request: &TraceRequest,
    ) -> Result<Option<Box<dyn Engine + 'a>>, CliError> {
        match self {
            Self::Cpu => Ok(None),
            #[cfg(feature = "gpu")]
            Self::Gpu(tracer) => {
                let job = GpuJob::new(tracer, medium, request).map_err(error)?;
                Ok(Some(Box::new(job)))
            }
        }
    }
}

#[cfg(feature = "gpu")]
fn open_gpu() -> Result<Device, CliError> {
    let gpu = stratiform_gpu::Gpu::new().map_err(pipeline::input_error)?;
    Ok(Device::Gpu(GpuTracer::new(&gpu).map_err(error)?))
}

#[cfg(not(feature = "gpu"))]
fn open_gpu() -> Result<Device, CliError> {
    Err(crate::commands::picture::unavailable("trace with", "--device gpu", "gpu"))
}

#[cfg(feature = "gpu")]
fn error(error: GpuTraceError) -> CliError {
    match error {
        GpuTraceError::Transport(error) => pipeline::trace_error(error),
        GpuTraceError::Books(_) | GpuTraceError::Stalled(_) => CliError::Failed(error.to_string()),
        GpuTraceError::Gpu(error) => pipeline::input_error(error),
    }
}

#[cfg(feature = "gpu")]
impl Engine for GpuJob<'_> {
    fn part(&self) -> Part {
        self.part()
    }

    fn trace(
        &self,
        part: &mut Part,
        share: Share,
        control: Control<'_>,
        keep: &mut (dyn FnMut(&Part) + Send),
    ) -> Result<(), CliError> {
        self.trace(part, share, control, keep).map_err(error)
    }
}
