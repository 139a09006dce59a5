//! Light through one plane-parallel slab: photon tracers that count fluxes per scattering order, and [`solve`], the
//! deterministic solver that needs no photons.
//!
//! Two tracers share request, run control and result, and must agree:
//! [`trace_half_space`] follows depth and direction cosine only, one history for every thickness;
//! [`trace_plain`] is the three-dimensional reference, one slab at a time. The same walk scores [`radiance`].
//!
//! A trace can be done in parts ([`TraceJob`], [`Part`]): by several processes, or by one that is stopped and started
//! again, with the same result bit for bit.
//!
//! Absorption is analog, so every tally is a whole number and the books close exactly:
//! launched = reflected + transmitted + absorbed, for each thickness. τ is always the optical thickness of
//! the full medium; see the conventions in `stratiform_quantities`.

mod cells;
mod control;
mod counted;
mod dispatch;
mod error;
mod fingerprint;
mod flock;
mod flux_flock;
mod fluxes;
mod generations;
mod half_space;
mod kernels;
mod lanes;
mod launches;
mod ledger;
mod medium;
mod part;
mod photon_set;
mod plain;
pub mod radiance;
mod real;
mod request;
mod run;
mod share;
pub mod single;
pub mod solve;
mod stretch;
mod tally;
mod trace_job;
mod traced;
mod walk;

pub use cells::Cell;
pub use control::{Control, Progress};
pub use dispatch::{Instructions, Kernel, Precision};
pub use error::TransportError;
pub use fluxes::{Extent, Fluxes};
pub use half_space::{trace_fluxes, trace_half_space, trace_half_space_with};
pub use medium::TraceMedium;
pub use part::{Identity, Part};
pub use plain::trace_plain;
pub use request::{MAX_ROWS, PHOTONS, Stop, TraceRequest};
pub use share::Share;
pub use stretch::Stretch;
pub use tally::{Quantity, Tally};
pub use trace_job::{TraceJob, Tracer};
pub use traced::Traced;
