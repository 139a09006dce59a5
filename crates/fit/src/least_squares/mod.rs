//! Bounded nonlinear least squares: minimise ½Σrᵢ(p)² subject to lower ≤ p ≤ upper.
//!
//! Levenberg–Marquardt in the trust-region form of Moré (1978, Lecture Notes in Mathematics 630, 105), run as
//! an [`argmin`] solver. Every linear problem is solved by QR of the column-scaled Jacobian, never through
//! its normal equations. Bounds are kept by an active set inside each step: a variable that meets its bound
//! stops exactly on it, and is freed once the gradient points inward.
//!
//! Three criteria mean convergence, all judged on the *full* step, the one the linear model would take
//! without a trust radius, so that a radius shrunk by wrong derivatives is not mistaken for convergence: the
//! gradient (`gtol`), the predicted decrease (`ftol`, squared relative offset of Bates & Watts 1981), the
//! step (`xtol`).
//!
//! Held to all 27 nonlinear sets of NIST StRD from both starts (`tests/nist_strd.rs`): at least 7.5 matching digits of
//! every parameter and 5.3 of every standard deviation. The one exception is the standard deviations of Lanczos1: its
//! data carry no error but their rounding, so that the sum of squares from which they follow, 1.4e-25, is noise.

mod bounds;
mod differences;
mod linear_model;
mod outcome;
mod problem;
mod solver;
mod trust_region;

pub use bounds::Bounds;
pub use differences::numerical_jacobian;
pub use outcome::{Criterion, Options, Outcome};
pub use problem::{LeastSquares, Solution, solve};
