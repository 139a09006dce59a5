//! What a fit can refuse.

use stratiform_model::ModelError;
use stratiform_quantities::DomainError;

/// An input that cannot be fitted.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum FitError {
    /// A number outside its range.
    #[error(transparent)]
    Domain(#[from] DomainError),
    /// Lists that must be equally long are not.
    #[error("{what} has {got} entries, expected {expected}")]
    Length {
        /// The list.
        what: String,
        /// Its length.
        got: usize,
        /// The length it must have.
        expected: usize,
    },
    /// Numbers that do not fit together.
    #[error("{0}")]
    Inconsistent(String),
    /// The optimiser itself failed.
    #[error("the optimiser failed: {0}")]
    Optimiser(String),
}

impl From<ModelError> for FitError {
    fn from(error: ModelError) -> Self {
        match error {
            ModelError::Domain(domain) => Self::Domain(domain),
            other => Self::Inconsistent(other.to_string()),
        }
    }
}

impl FitError {
    /// Refuses a list of the wrong length.
    pub(crate) fn check_length(what: impl Into<String>, got: usize, expected: usize) -> Result<(), Self> {
        if got == expected { Ok(()) } else { Err(Self::Length { what: what.into(), got, expected }) }
    }
}
