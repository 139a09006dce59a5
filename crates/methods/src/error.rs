//! What a method refuses.

use stratiform_quantities::DomainError;

/// Why a method gives no answer.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum MethodError {
    /// A number outside the declared domain.
    #[error(transparent)]
    Domain(#[from] DomainError),
    /// A quantity that the method does not give.
    #[error("{method} gives no {quantity}")]
    NotGiven {
        /// The method's name.
        method: String,
        /// `radiance` or `flux`.
        quantity: &'static str,
    },
    /// The solver or tracer inside could not answer.
    #[error("{method}: {reason}")]
    Failed {
        /// The method's name.
        method: String,
        /// What it said.
        reason: String,
    },
    /// A phase function or its texels cannot be made.
    #[error("phase function: {0}")]
    Phase(String),
    /// What stands after the colon of a name.
    #[error("{name}: {reason}")]
    Knob {
        /// The name.
        name: String,
        /// What is wrong.
        reason: String,
    },
    /// No method of that name.
    #[error("no method is called {name}: the methods are {known}")]
    Unknown {
        /// The name.
        name: String,
        /// The names there are.
        known: String,
    },
}

impl From<stratiform_optics::OpticsError> for MethodError {
    fn from(error: stratiform_optics::OpticsError) -> Self {
        Self::Phase(error.to_string())
    }
}

impl From<stratiform_tables::TablesError> for MethodError {
    fn from(error: stratiform_tables::TablesError) -> Self {
        Self::Phase(error.to_string())
    }
}
