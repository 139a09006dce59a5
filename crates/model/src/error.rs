//! What the model refuses.

use stratiform_quantities::DomainError;

/// Input that the model cannot use.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ModelError {
    /// A number outside its domain.
    #[error(transparent)]
    Domain(#[from] DomainError),
    /// Table angles that do not rise.
    #[error("theta_l_deg = {next} follows {previous}: the table's angles must rise")]
    Unsorted {
        /// Angle of the earlier row, degrees.
        previous: f64,
        /// Angle of the later row, degrees.
        next: f64,
    },
    /// A table that is too short to interpolate.
    #[error("the table has {rows} angles: at least 2 are needed, from 0 to 90 degrees")]
    TooFewRows {
        /// How many it has.
        rows: usize,
    },
    /// Radii of a family that do not rise.
    #[error("effective_radius_um = {next} follows {previous}: a family's radii must rise")]
    UnsortedRadii {
        /// The earlier radius, µm.
        previous: f64,
        /// The later one, µm.
        next: f64,
    },
    /// A family that is too small to interpolate.
    #[error("the family has {radii} effective radii: at least 2 are needed")]
    TooFewRadii {
        /// How many it has.
        radii: usize,
    },
}
