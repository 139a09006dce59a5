//! The cheapest listed method within a budget, from error data on disk.
//!
//! [`Data`] holds signed errors of every listed method on lattices over r_e, thickness, sun and view
//! (`stratiform_artifact::ErrorData`; [`Data::committed`] is built in). [`advise`] lays points of a Halton sequence over a scene's
//! ranges (`cover`), interpolates the size of each method's error there (`lattice`), and takes the 95th percentile of its size, times
//! [`MARGIN`] plus [`FLOOR`], as what it [promises](Prediction). Every visible effect has points of its own, and its percentile must
//! meet the budget too. Nothing is measured. Errors: [`AdviseError`].

mod advice;
mod budget;
mod choose;
mod contributions;
mod cover;
mod data;
mod emitted;
mod error;
mod extent;
mod lattice;
mod predict;
mod text;

pub use advice::{Advice, Bounce, Channels, Rejected};
pub use budget::Budget;
pub use choose::{Candidate, advise, candidates};
pub use contributions::{Unneeded, unneeded};
pub use cover::{Ask, Population, WINDOWS, window};
pub use data::Data;
pub use emitted::Emitted;
pub use error::AdviseError;
pub use predict::{FLOOR, MARGIN, Prediction, percentile};
