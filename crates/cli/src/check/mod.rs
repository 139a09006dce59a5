//! `stratiform check`: what others rely on, held against the truth.
//!
//! * [`model`]: the accepted table against the deterministic solver, and against a fresh fit;
//! * [`tracer`]: fresh photons against stored counts;
//! * [`values`]: somebody else's numbers against the solver.
//!
//! Each yields [`Comparison`]s; a [`Verdict`] sums them up and is printed by [`report`].

mod comparison;
pub mod config;
pub mod counts;
pub mod model;
pub mod report;
pub mod tracer;
pub mod truth;
pub mod values;

pub use comparison::{Comparison, Part, Place, Summary, Verdict};
