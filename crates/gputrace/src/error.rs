//! What can go wrong.

use crate::Books;
use stratiform_gpu::GpuError;
use stratiform_quantities::DomainError;
use stratiform_transport::TransportError;

/// Why a trace on the device gave no result.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum GpuTraceError {
    /// The device is missing, or refused work.
    #[error(transparent)]
    Gpu(#[from] GpuError),
    /// The request is out of domain, or the caller asked to stop.
    #[error(transparent)]
    Transport(#[from] TransportError),
    /// Photons were lost or counted twice: a defect of the driver or of the tracer.
    #[error("the device's books do not balance: {0}")]
    Books(Books),
    /// Photons wait, none is in flight, and the device takes none: a defect of the driver.
    #[error("the device takes no photon: {0}")]
    Stalled(Books),
}

impl From<DomainError> for GpuTraceError {
    fn from(error: DomainError) -> Self {
        Self::Transport(error.into())
    }
}
