//! Photons from their launch to their N-th scattering, a row of them side by side and all of the same order.
//!
//! With d a photon's greatest depth so far, those that pass slab j at order n are those with d ≥ H_j after that order less
//! those before: numbers of a row, without a look at any single photon.

use crate::half_space::HalfSpace;
use crate::lanes::{Block, LANES, LanesOf, Mask, Row, gathered};
use crate::launches::launch;
use crate::real::Real;
use crate::tally::Tally;
use std::ops::Range;

/// Rows of photons, one after the other.
#[repr(C)]
pub(crate) struct Generations<'a, R: Real> {
    pub block: Block<R>,
    /// Greatest depths; negative where there was no photon.
    pub deepest: Row<R>,
    index: Row<u64>,
    half_space: &'a HalfSpace<'a>,
    table: &'a R::Table,
    /// Ascending.
    bottoms: &'a [R],
    ranges: &'a [Range<u64>],
    /// The present range, and how many of its photons have been launched.
    range: usize,
    launched: u64,
    /// Photons of the row whose greatest depth is not above each bottom.
    reached: Vec<u32>,
}

impl<'a, R: Real> Generations<'a, R> {
    pub fn new(
        half_space: &'a HalfSpace<'a>,
        table: &'a R::Table,
        bottoms: &'a [R],
        ranges: &'a [Range<u64>],
    ) -> Self {
        Self {
            block: Block::parked(),
            deepest: Row([R::ZERO; LANES]),
            index: Row([0; LANES]),
            half_space,
            table,
            bottoms,
            ranges,
            range: 0,
            launched: 0,
            reached: vec![0; bottoms.len()],
        }
    }

    /// Follows the next row of photons to the order `max_order` and counts them in the tally of their range, which is returned:
    /// `None` after the last row. Whoever is inside the thickest slab then is left in `block`.
    #[inline(always)]
    pub fn next_row(&mut self, max_order: u32, tallies: &mut [Tally]) -> Option<usize> {
        let (range, photons) = self.take()?;
        let tally = &mut tallies[range];
        self.enter(photons);
        self.count(0, tally);
        for order in 1..=u64::from(max_order) {
            let events = self.block.collide_and_fly(self.table, self.half_space.absorbs_from);
            for lane in LanesOf(events.absorbed) {
                self.absorb(lane, order - 1, tally);
            }
            self.deepen();
            for lane in LanesOf(events.left) {
                self.leave(lane, order, tally);
            }
            self.count(order, tally);
        }
        Some(range)
    }

    /// The next photons: as many as a row has lanes, or what is left of a range.
    #[inline(always)]
    fn take(&mut self) -> Option<(usize, Range<u64>)> {
        while let Some(range) = self.ranges.get(self.range) {
            let from = range.start + self.launched;
            let to = range.end.min(from + LANES as u64);
            if from < to {
                self.launched += to - from;
                return Some((self.range, from..to));
            }
            (self.range, self.launched) = (self.range + 1, 0);
        }
        None
    }

    /// Launches photons, the first of the row's lanes, for their first flight.
    #[inline(always)]
    fn enter(&mut self, photons: Range<u64>) {
        let count = (photons.end - photons.start) as usize;
        for k in 0..LANES {
            self.index.0[k] = photons.start + k as u64;
        }
        let Block { streams, mu, depth, .. } = &mut self.block;
        launch(streams, mu, depth, &self.index, self.half_space.key, self.half_space.incidence);
        let limit = self.bottoms.last().copied().unwrap_or(R::ZERO);
        self.block.bottom.0.fill(limit);
        self.deepest.0.copy_from_slice(&self.block.depth.0);
        for lane in count..LANES {
            self.block.park(lane);
            self.deepest.0[lane] = R::rounded(-1.0);
        }
        self.reached.fill(0);
        let left = self.block.left();
        for lane in LanesOf(left) {
            self.block.park(lane);
        }
    }

    /// The lanes whose photon is inside the thickest slab.
    #[inline(always)]
    pub fn inside(&self) -> Mask {
        gathered(|k| self.block.bottom.0[k] < R::INFINITY)
    }

    /// Photons inside the thickest slab that have been below the bottom of `slab`.
    #[inline(always)]
    pub fn inside_past(&self, slab: usize) -> u32 {
        let bottom = self.bottoms[slab];
        count_where(|k| (self.deepest.0[k] >= bottom) & (self.block.bottom.0[k] < R::INFINITY))
    }

    #[inline(always)]
    fn deepen(&mut self) {
        for k in 0..LANES {
            let (depth, deepest) = (self.block.depth.0[k], self.deepest.0[k]);
            let deeper = (depth > deepest) & (self.block.bottom.0[k] < R::INFINITY);
            self.deepest.0[k] = if deeper { depth } else { deepest };
        }
    }

    /// An absorbed photon flew on for nothing.
    #[inline(always)]
    fn absorb(&mut self, lane: usize, order: u64, tally: &mut Tally) {
        if !self.block.is_parked(lane) {
            tally.absorb(first_below(self.bottoms, self.deepest.0[lane]), order);
            self.block.park(lane);
        }
    }

    #[inline(always)]
    fn leave(&mut self, lane: usize, order: u64, tally: &mut Tally) {
        if self.block.depth.0[lane] < R::ZERO {
            tally.reflect(first_below(self.bottoms, self.deepest.0[lane]), order);
        }
        self.block.park(lane);
    }

    /// Counts the slabs that were passed for the first time.
    #[inline(always)]
    fn count(&mut self, order: u64, tally: &mut Tally) {
        for (slab, &bottom) in self.bottoms.iter().enumerate() {
            let reached = count_where(|k| self.deepest.0[k] >= bottom);
            tally.pass(slab, order, u64::from(reached - self.reached[slab]));
            self.reached[slab] = reached;
        }
    }
}

/// The first of the ascending `bottoms` that is below `depth`; their number if none is. No branch depends on the depth.
#[inline(always)]
pub(crate) fn first_below<R: Real>(bottoms: &[R], depth: R) -> usize {
    bottoms.partition_point(|&bottom| bottom <= depth)
}

#[inline(always)]
fn count_where(holds: impl Fn(usize) -> bool) -> u32 {
    let mut count = 0;
    for k in 0..LANES {
        count += u32::from(holds(k));
    }
    count
}
