//! What generation refuses.

use crate::SubsetError;
use stratiform_artifact::ArtifactError;
use stratiform_model::ModelError;
use stratiform_quantities::DomainError;

/// Inputs that cannot be turned into code, or a folder that cannot be read or written.
#[derive(Debug, thiserror::Error)]
pub enum CodegenError {
    /// A number outside its domain.
    #[error(transparent)]
    Domain(#[from] DomainError),
    /// Parameters that the model refuses.
    #[error(transparent)]
    Model(#[from] ModelError),
    /// A file.
    #[error(transparent)]
    Artifact(#[from] ArtifactError),
    /// Library text that the printer cannot translate.
    #[error(transparent)]
    Subset(#[from] SubsetError),
    /// WGSL that is not valid.
    #[error("the emitted WGSL is not valid: {message}")]
    Shader {
        /// What naga says.
        message: String,
    },
    /// A family's phase function of the wrong length.
    #[error(
        "the phase functions of effective radius {effective_radius_um} um have {got} values, not {expected}"
    )]
    FamilyTexels {
        /// The radius.
        effective_radius_um: f64,
        /// How many there are.
        got: usize,
        /// How many there must be.
        expected: usize,
    },
    /// A family's table whose angles are not those of the fluxes' table.
    #[error(
        "the table of effective radius {effective_radius_um} um has other angles than the table of fluxes"
    )]
    FamilyAngles {
        /// The radius.
        effective_radius_um: f64,
    },
    /// Coefficients of the radiance model whose terms or numbers of them are not this program's.
    #[error("the radiance parameters have other terms than this program's model")]
    RadianceTerms,
    /// Coefficients of the radiance model for another medium than the fluxes' parameters.
    #[error("the radiance parameters belong to another medium than the parameters of fluxes")]
    RadianceMedium,
    /// No row for diffuse light.
    #[error("the parameter table has no row `diffuse`")]
    NoDiffuseRow,
    /// A row that is neither an angle nor diffuse.
    #[error("theta_l_deg = `{word}` is neither a number nor `diffuse`")]
    UnknownRow {
        /// The word that stands there.
        word: String,
    },
    /// Angles that do not reach from the zenith to the horizon.
    #[error("the parameter table covers {first} to {last} degrees: it must cover 0 to 90")]
    Uncovered {
        /// Smallest angle, degrees.
        first: f64,
        /// Largest angle, degrees.
        last: f64,
    },
    /// A phase table that cannot be used.
    #[error("phase table `{table}`: {message}")]
    Phase {
        /// `full`, `modified`, `squared` or `halo`.
        table: &'static str,
        /// What is wrong.
        message: String,
    },
    /// A quantity that the model does not have.
    #[error(
        "reference quantity `{quantity}` is none of t_ms, r_ms, t_0, t_1, t_2, t_3_plus, r_1, r_2, r_3_plus"
    )]
    UnknownQuantity {
        /// The name given.
        quantity: String,
    },
}
