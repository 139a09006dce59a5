//! The half-space tracer on a graphics device.
//!
//! The same photons as [`trace_half_space`](stratiform_transport::trace_half_space) traces: each has the random stream that the hash of
//! key and index gives it, word for word, and takes its numbers in the same order. The arithmetic is in single precision, so a photon in
//! some thousands decides otherwise at a boundary than in double precision. All counters are integers: no result depends on
//! the order in which the device works.
//!
//! An invocation carries one photon. A dispatch is a few thousand flights long at most, photons stay on the device in between, and after
//! each the [`Books`] must balance.

mod books;
mod error;
mod flock;
mod job;
mod lanes;
mod pace;
mod shader;
mod tallies;
#[cfg(test)]
mod tests;
mod tracer;

pub use books::Books;
pub use error::GpuTraceError;
pub use job::GpuJob;
pub use tracer::GpuTracer;
