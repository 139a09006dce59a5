//! Photons counted where they leave: slab by slab, or in a half space for all slabs at once.

use super::history::{Photon, Words};
use super::{Job, scores::Scores};
use std::ops::Range;
use stratiform_stats::photon_stream;

/// Each slab with photons of its own.
pub fn analog(job: &Job<'_>, photons: Range<u64>) -> Scores {
    let mut scores = Scores::new(job.bottoms.len());
    for index in photons {
        for (slab, &bottom) in job.bottoms.iter().enumerate() {
            let mut words = Words::new(photon_stream(job.key, index | (slab as u64 + 1) << 48), &[]);
            scores.flights += 1 + through_one(job, (slab, bottom), &mut words, &mut scores);
        }
    }
    scores
}

/// Counts one photon; returns its scatterings.
fn through_one(
    job: &Job<'_>,
    (slab, bottom): (usize, f64),
    words: &mut Words<'_>,
    scores: &mut Scores,
) -> u64 {
    let mut photon = Photon::new(job.mu0);
    loop {
        photon.fly(words);
        if photon.depth < 0.0 {
            scores.reflect(slab, photon.order, 1.0);
            return photon.order as u64;
        }
        if photon.depth >= bottom {
            scores.transmit(slab, photon.order, 1.0);
            return photon.order as u64;
        }
        photon.scatter(job.table, words);
    }
}

/// One history for all slabs.
pub fn half_space(job: &Job<'_>, photons: Range<u64>) -> Scores {
    started_with(job, photons, |_, _: &mut [u32; 0]| ())
}

/// One history for all slabs; `fill` gives the photon of an index its first `K` words.
pub fn started_with<const K: usize>(
    job: &Job<'_>,
    photons: Range<u64>,
    fill: impl Fn(u64, &mut [u32; K]),
) -> Scores {
    let mut scores = Scores::new(job.bottoms.len());
    let mut first = [0; K];
    for index in photons {
        fill(index, &mut first);
        let mut words = Words::new(photon_stream(job.key, index), &first);
        scores.flights += 1 + through_all(job, &mut words, &mut scores);
    }
    scores.nested()
}

/// Counts one photon in every slab; returns its scatterings.
fn through_all(job: &Job<'_>, words: &mut Words<'_>, scores: &mut Scores) -> u64 {
    let mut photon = Photon::new(job.mu0);
    let mut slab = 0;
    loop {
        photon.fly(words);
        if photon.depth < 0.0 {
            scores.reflect(slab, photon.order, 1.0);
            return photon.order as u64;
        }
        while job.bottoms.get(slab).is_some_and(|&bottom| photon.depth >= bottom) {
            scores.transmit(slab, photon.order, 1.0);
            slab += 1;
        }
        if slab == job.bottoms.len() {
            return photon.order as u64;
        }
        photon.scatter(job.table, words);
    }
}
