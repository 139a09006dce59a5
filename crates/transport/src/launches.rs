//! Photons about to enter the lanes, prepared sixty-four at a time: stream, direction and first flight.

use crate::lanes::{LANES, Streams};
use crate::real::Real;
use std::ops::Range;
use stratiform_quantities::Incidence;
use stratiform_stats::photon_seed;

/// A row of photons after their first flight, of which those from `next` on are still to enter.
#[repr(C, align(64))]
pub(crate) struct Launches<R> {
    pub streams: Streams,
    pub mu: [R; LANES],
    pub depth: [R; LANES],
    next: usize,
    ready: usize,
    waiting: Range<u64>,
}

impl<R: Real> Launches<R> {
    pub fn new(waiting: Range<u64>) -> Self {
        let (mu, depth) = ([R::ZERO; LANES], [R::ZERO; LANES]);
        Self { streams: Streams::default(), mu, depth, next: 0, ready: 0, waiting }
    }

    /// The place of the next photon in this row, or `None` after the last one.
    #[inline(always)]
    pub fn next(&mut self, key: u64, incidence: Incidence) -> Option<usize> {
        if self.next == self.ready {
            self.ready = (self.waiting.end - self.waiting.start).min(LANES as u64) as usize;
            self.next = 0;
            if self.ready == 0 {
                return None;
            }
            self.prepare(key, incidence);
            self.waiting.start += self.ready as u64;
        }
        self.next += 1;
        Some(self.next - 1)
    }

    /// The photons from `waiting.start` on.
    #[inline(always)]
    fn prepare(&mut self, key: u64, incidence: Incidence) {
        for k in 0..LANES {
            let (state, stream) = photon_seed(key, self.waiting.start + k as u64);
            let increment = (stream << 1) | 1;
            self.streams.state[k] = state.wrapping_add(increment);
            self.streams.increment[k] = increment;
        }
        self.streams.advance();
        match incidence {
            Incidence::Beam(mu0) => self.mu = [R::rounded(mu0.get()); LANES],
            Incidence::Diffuse => {
                let words = self.streams.draw();
                for k in 0..LANES {
                    self.mu[k] = R::diffuse_cosine(words[k]);
                }
            }
        }
        let paths = self.streams.draw();
        for k in 0..LANES {
            self.depth[k] = self.mu[k] * R::optical_path(paths[k]);
        }
    }
}
