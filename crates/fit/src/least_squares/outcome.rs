//! Tolerances, and what can end a fit.

use std::fmt;

/// Tolerances and limits. The defaults ask for all that double precision gives.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Options {
    /// Largest predicted relative decrease of the sum of squares at convergence.
    pub ftol: f64,
    /// Largest full step at convergence, relative to the parameters, in the norm scaled by the Jacobian's
    /// columns.
    pub xtol: f64,
    /// Largest cosine between the residuals and a column of the Jacobian at convergence.
    pub gtol: f64,
    /// Most steps tried.
    pub max_iterations: u64,
    /// First trust radius relative to the scaled length of the start.
    pub first_radius: f64,
}

impl Default for Options {
    fn default() -> Self {
        Self { ftol: 1e-22, xtol: 1e-13, gtol: 1e-14, max_iterations: 2000, first_radius: 10.0 }
    }
}

/// Which convergence criterion was met.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Criterion {
    /// The linear model promises no further decrease.
    Ftol,
    /// The full step is negligible.
    Xtol,
    /// The residuals are orthogonal to the Jacobian, or zero.
    Gtol,
}

/// What stopped a fit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Outcome {
    /// A minimum within the tolerances.
    Converged(Criterion),
    /// The trust radius shrank to nothing while the linear model still promised a decrease: rounding errors
    /// dominate, or the derivatives are wrong.
    Stalled,
    /// More steps than allowed.
    IterationLimit,
    /// Residuals or derivatives at the start are not finite.
    NotFinite,
}

impl Outcome {
    /// Whether a minimum was reached.
    pub fn has_converged(self) -> bool {
        matches!(self, Self::Converged(_))
    }
}

impl fmt::Display for Outcome {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Converged(Criterion::Ftol) => "converged (ftol)",
            Self::Converged(Criterion::Xtol) => "converged (xtol)",
            Self::Converged(Criterion::Gtol) => "converged (gtol)",
            Self::Stalled => "stalled",
            Self::IterationLimit => "iteration limit",
            Self::NotFinite => "not finite",
        })
    }
}
