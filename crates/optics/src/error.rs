//! What can go wrong between droplets and phase functions.

use stratiform_artifact::{ArtifactError, ReachedError};
use stratiform_quantities::DomainError;

/// An optical property that cannot be computed or read.
#[derive(Debug, thiserror::Error)]
pub enum OpticsError {
    /// A number outside its domain.
    #[error(transparent)]
    Domain(#[from] DomainError),
    /// A file that cannot be read, written or understood.
    #[error(transparent)]
    Artifact(#[from] ArtifactError),
    /// Keys that contradict each other or are missing.
    #[error("{0}")]
    Config(String),
    /// A table of P that is no phase function.
    #[error("phase function: {0}")]
    Table(String),
    /// A table of P whose norm is too far from 1.
    #[error(
        "the phase function's norm is {norm}, outside [0.999, 1.001]: the table is too coarse or not normalised"
    )]
    NotNormalised {
        /// ½∫P sinΘ dΘ as tabulated.
        norm: f64,
    },
    /// Moments whose sum is negative somewhere.
    #[error(
        "the moments' sum is {value} at {theta_deg} degrees, below -0.001: they describe no phase function"
    )]
    NegativeSum {
        /// The sum there.
        value: f64,
        /// Where, degrees.
        theta_deg: f64,
    },
    /// The radius quadrature did not reach the error asked for.
    #[error(
        "the radius quadrature at {wavelength_um} um stopped at {} radii with errors g {:.1e}, P_f {:.1e}, moments {:.1e}, P {:.1e} (below 60 degrees) and {:.1e} (beyond): ask for a larger error or allow more radii",
        reached.radii, reached.asymmetry, reached.forward_fraction, reached.moments,
        reached.phase_below_60_deg, reached.phase_beyond_60_deg
    )]
    NotConverged {
        /// Wavelength, µm.
        wavelength_um: f64,
        /// The error reached.
        reached: Box<ReachedError>,
    },
}
