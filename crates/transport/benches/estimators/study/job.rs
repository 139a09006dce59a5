//! What an estimator is asked for.

use super::scores::Scores;
use std::ops::Range;
use stratiform_optics::sampling::SamplingTable;

/// One incidence on slabs of one conservative medium.
#[derive(Clone, Copy)]
pub struct Job<'a> {
    pub table: &'a SamplingTable,
    /// Optical thicknesses, ascending.
    pub bottoms: &'a [f64],
    pub mu0: f64,
    /// Of the photons' streams.
    pub key: u64,
}

/// Sums over the photons of a range. A range is a replicate: whatever photons share, they share inside it.
pub type Estimator = fn(&Job<'_>, Range<u64>) -> Scores;
