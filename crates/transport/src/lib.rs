//! Light through one plane-parallel slab: photon tracers that count fluxes per scattering order, and [`solve`], the
//! deterministic solver that needs no photons.
//!
//! Two tracers share request, run control and result, and must agree:
//! [`trace_half_space`] follows depth and direction cosine only, one history for every thickness;
//! [`trace_plain`] is the three-dimensional reference, one slab at a time. The same walk scores [`radiance`].
//!
//! Absorption is analog, so every tally is a whole number and the books close exactly:
//! launched = reflected + transmitted + absorbed, for each thickness. τ is always the optical thickness of
//! the full medium; see the conventions in `stratiform_quantities`.

mod control;
mod error;
mod half_space;
mod kernels;
mod lanes;
mod medium;
mod plain;
pub mod radiance;
mod request;
mod run;
pub mod single;
pub mod solve;
mod tally;
mod traced;
mod walk;

pub use control::{Control, Progress};
pub use error::TransportError;
pub use half_space::trace_half_space;
pub use medium::TraceMedium;
pub use plain::trace_plain;
pub use request::{MAX_ROWS, PHOTONS, Stop, TraceRequest};
pub use tally::Quantity;
pub use traced::Traced;
