//! Why there is no chart.

use stratiform_methods::MethodError;
use stratiform_optics::OpticsError;
use stratiform_quantities::DomainError;
use stratiform_transport::TransportError;

/// What stops a chart. A method that refuses points is counted, and stops nothing.
#[derive(Debug, thiserror::Error)]
pub enum ChartError {
    /// A number out of its domain.
    #[error(transparent)]
    Domain(#[from] DomainError),
    /// The droplets' optics.
    #[error(transparent)]
    Optics(#[from] OpticsError),
    /// The truth.
    #[error(transparent)]
    Transport(#[from] TransportError),
    /// A cloud that no method can be prepared for.
    #[error(transparent)]
    Method(#[from] MethodError),
    /// The caller asked to stop.
    #[error("interrupted")]
    Cancelled,
}
