//! Photons about to enter the lanes, prepared a row at a time: stream, direction and first flight.

use crate::lanes::{LANES, Row, Streams};
use crate::real::Real;
use std::ops::Range;
use stratiform_quantities::Incidence;
use stratiform_stats::photon_seed;

/// A row of photons after their first flight, of which those from `next` on are still to enter.
#[repr(C)]
pub(crate) struct Launches<'a, R> {
    pub streams: Streams,
    pub mu: Row<R>,
    pub depth: Row<R>,
    /// The row of the ledger in which the first flight ends.
    pub row: Row<u32>,
    index: Row<u64>,
    next: usize,
    ready: usize,
    ranges: &'a [Range<u64>],
    /// Bottoms of the slabs, then infinity: a row of the ledger each, for every range.
    slabs: Vec<R>,
    /// The present range, and how many of its photons have been prepared.
    range: usize,
    prepared: u64,
}

impl<'a, R: Real> Launches<'a, R> {
    pub fn new(ranges: &'a [Range<u64>], slabs: Vec<R>) -> Self {
        Self {
            streams: Streams::default(),
            mu: Row([R::ZERO; LANES]),
            depth: Row([R::ZERO; LANES]),
            row: Row([0; LANES]),
            index: Row([0; LANES]),
            next: 0,
            ready: 0,
            ranges,
            slabs,
            range: 0,
            prepared: 0,
        }
    }

    /// The place of the next photon in this row, or `None` after the last one.
    #[inline(always)]
    pub fn next(&mut self, key: u64, incidence: Incidence) -> Option<usize> {
        if self.next == self.ready {
            self.fill();
            if self.ready == 0 {
                return None;
            }
            self.prepare(key, incidence);
        }
        self.next += 1;
        Some((self.next - 1) % LANES)
    }

    /// Lists the photons of a new row.
    #[inline(always)]
    fn fill(&mut self) {
        (self.next, self.ready) = (0, 0);
        while let Some(range) = self.ranges.get(self.range) {
            let (from, free) = (range.start + self.prepared, LANES - self.ready);
            let count = (range.end - from).min(free as u64) as usize;
            let row = (self.range * self.slabs.len()) as u32;
            self.index.0[self.ready..].iter_mut().zip(from..).for_each(|(index, photon)| *index = photon);
            self.row.0[self.ready..].fill(row);
            self.ready += count;
            self.prepared += count as u64;
            if self.ready == LANES {
                return;
            }
            (self.range, self.prepared) = (self.range + 1, 0);
        }
    }

    /// Streams, directions and first flights of a row.
    #[inline(always)]
    fn prepare(&mut self, key: u64, incidence: Incidence) {
        launch(&mut self.streams, &mut self.mu, &mut self.depth, &self.index, key, incidence);
        for &bottom in &self.slabs {
            for k in 0..LANES {
                self.row.0[k] += u32::from(self.depth.0[k] >= bottom);
            }
        }
    }
}

/// Streams, directions and depths after the first flight of the photons of these indices.
#[inline(always)]
pub(crate) fn launch<R: Real>(
    streams: &mut Streams,
    mu: &mut Row<R>,
    depth: &mut Row<R>,
    index: &Row<u64>,
    key: u64,
    incidence: Incidence,
) {
    for k in 0..LANES {
        let (state, stream) = photon_seed(key, index.0[k]);
        let increment = (stream << 1) | 1;
        streams.state.0[k] = state.wrapping_add(increment);
        streams.increment.0[k] = increment;
    }
    streams.advance();
    match incidence {
        Incidence::Beam(mu0) => *mu = Row([R::rounded(mu0.get()); LANES]),
        Incidence::Diffuse => {
            let words = streams.draw();
            for k in 0..LANES {
                mu.0[k] = R::diffuse_cosine(words.0[k]);
            }
        }
    }
    let paths = streams.draw();
    for k in 0..LANES {
        depth.0[k] = first_depth(mu.0[k], paths.0[k]);
    }
}

/// Depth after the first flight: never -0, which the shortest path would give.
#[inline(always)]
fn first_depth<R: Real>(mu: R, bits: u32) -> R {
    mu * R::optical_path(bits) + R::ZERO
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_shortest_first_flight_stays_in_the_slab() {
        for bits in [u32::MAX, u32::MAX - 100, u32::MAX - 200, 0] {
            assert!(
                first_depth(1.0_f32, bits).is_sign_positive() && !first_depth(1.0_f32, bits).is_out(23.0)
            );
            assert!(
                first_depth(1.0_f64, bits).is_sign_positive() && !first_depth(1.0_f64, bits).is_out(23.0)
            );
        }
    }
}
