//! The first words of the photons of a replicate from an additive sequence, moved by a random shift.
//!
//! Word d of photon i is shift_d + i·x^{-d} mod 1, with x^{K+1} = x + 1 (Roberts 2018, "The unreasonable effectiveness of
//! quasirandom sequences", R_K). Each photon by itself has uniform words, so means are unbiased; the photons of a replicate
//! depend on each other, so errors are known from replicates only. Photon i's first flight is word 1, its first
//! scattering words 2 and 3, its second flight word 4: four words decide R_1.

use super::counted::started_with;
use super::history::Words;
use super::{Job, scores::Scores};
use std::ops::Range;
use stratiform_stats::photon_stream;

/// Of the shift's stream: no photon has this index.
const SHIFT: u64 = 1 << 63;

/// One history for all slabs, its first `K` words from the sequence.
pub fn sequence<const K: usize>(job: &Job<'_>, photons: Range<u64>) -> Scores {
    let step: [u32; K] = steps();
    let mut words = Words::new(photon_stream(job.key, photons.start | SHIFT), &[]);
    let shift: [u32; K] = std::array::from_fn(|_| words.next());
    let start = photons.start;
    started_with(job, photons, |index, first: &mut [u32; K]| {
        let place = (index - start) as u32;
        *first = std::array::from_fn(|d| shift[d].wrapping_add(step[d].wrapping_mul(place)));
    })
}

/// x^{-1} … x^{-K} as words.
fn steps<const K: usize>() -> [u32; K] {
    let root = (0..60).fold(1.5_f64, |x, _| libm::pow(1.0 + x, 1.0 / (K as f64 + 1.0)));
    std::array::from_fn(|d| (libm::pow(root, -(d as f64 + 1.0)) * 4_294_967_296.0) as u32)
}
