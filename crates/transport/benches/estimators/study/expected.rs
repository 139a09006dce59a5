//! Expected values: every flight scores the probability that it leaves, e^{-s}, through the top and through each bottom below.

use super::history::{Photon, Words};
use super::{Job, scores::Scores};
use std::ops::Range;
use stratiform_stats::photon_stream;

/// Depths per |μ| from which a flight is taken not to leave: e^-40 is 4e-18.
const OPAQUE: f64 = 40.0;

/// One history for all slabs, scored before each flight.
pub fn expected(job: &Job<'_>, photons: Range<u64>) -> Scores {
    expected_with(job, photons, |depth, mu| libm::exp(-depth / mu))
}

/// The same with the probability to pass `depth` with cosine `mu` given, so that a wrong one can be planted.
pub fn expected_with(job: &Job<'_>, photons: Range<u64>, passes: impl Fn(f64, f64) -> f64) -> Scores {
    let mut scores = Scores::new(job.bottoms.len());
    for index in photons {
        let mut words = Words::new(photon_stream(job.key, index), &[]);
        let mut photon = Photon::new(job.mu0);
        let mut slab = 0;
        loop {
            score(job, (&photon, slab), &passes, &mut scores);
            photon.fly(&mut words);
            slab += job.bottoms[slab..].iter().take_while(|&&bottom| photon.depth >= bottom).count();
            if photon.depth < 0.0 || slab == job.bottoms.len() {
                break;
            }
            photon.scatter(job.table, &mut words);
        }
        scores.flights += 1 + photon.order as u64;
    }
    scores.nested()
}

/// The next flight's probabilities to leave the slabs from `slab` on.
#[inline(always)]
fn score(
    job: &Job<'_>,
    (photon, slab): (&Photon, usize),
    passes: &impl Fn(f64, f64) -> f64,
    scores: &mut Scores,
) {
    if photon.mu < 0.0 {
        return scores.reflect(slab, photon.order, passes(photon.depth, -photon.mu));
    }
    for (k, &bottom) in job.bottoms.iter().enumerate().skip(slab) {
        let depth = bottom - photon.depth;
        if depth > OPAQUE * photon.mu {
            return;
        }
        scores.transmit(k, photon.order, passes(depth, photon.mu));
    }
}
