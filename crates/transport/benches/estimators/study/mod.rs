//! Estimators of a slab's reflectance and transmittance, all on the same walk, and what each is worth.
//!
//! The figure of merit of an estimator is 1/(σ² t): σ² its variance per photon, t seconds per photon. Those that score a
//! history by itself have variances that fall as 1/n; a sequence's may fall faster, so its merit belongs to the number of
//! photons at which it was measured. Truth is the deterministic solver's.

pub mod convergence;
mod counted;
pub mod expected;
mod history;
mod job;
pub mod measure;
pub mod media;
pub mod merits;
pub mod scores;
mod sequence;
pub mod sorted;
pub mod truth;

pub use counted::{analog, half_space};
pub use job::{Estimator, Job};
pub use sequence::sequence;

/// By name, analog first: the others are compared with it.
pub const ALL: [(&str, Estimator); 6] = [
    ("analog", analog),
    ("half-space", half_space),
    ("expected values", expected::expected),
    ("sequence, 1 word", sequence::<1>),
    ("sequence, 4 words", sequence::<4>),
    ("sequence, 8 words", sequence::<8>),
];
