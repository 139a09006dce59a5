//! `stratiform check`: what others rely on, held against the truth.
//!
//! * [`model`]: the accepted table against the deterministic solver, and against a fresh fit;
//! * [`tracer`]: fresh photons against stored counts;
//! * [`values`]: somebody else's numbers against the solver.
//!
//! Each yields [`Comparison`]s, which [`report`] prints. A part that compares nothing has failed.

pub mod config;
pub mod counts;
