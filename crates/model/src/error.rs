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
}
