//! From reference fluxes to the parameters of the one-dimensional model: bounded least squares, error propagation,
//! identifiability.

mod error;
pub mod least_squares;
mod matrix;
mod qr;

pub use error::FitError;
pub use matrix::Matrix;
