//! Tracing fluxes in one process or many: what is traced, what some of its photons have counted, and the file that
//! keeps it between processes and across kills.
//!
//! A process traces its share of every incidence into [`RunParts`]; those of all shares merge into what one process
//! would have, and print the same bytes.

mod checkpoint;
mod device;
mod engine;
mod parts;
mod run;
mod seal;
mod share;

pub use crate::medium::Medium;
pub use checkpoint::Checkpoint;
pub use device::Device;
pub use engine::Engine;
pub use parts::{RunParts, Snapshot};
pub use run::TraceRun;
pub use share::trace_share;
