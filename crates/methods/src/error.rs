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
    /// No method of that name.
    #[error("no method is called {name}: the methods are {known}")]
    Unknown {
        /// The name.
        name: String,
        /// The names there are.
        known: String,
    },
}
