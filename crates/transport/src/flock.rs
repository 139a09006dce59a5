//! Photons on their way through the lanes: they enter, are counted, and leave.
//!
//! A photon that ends is replaced by the next one at once; when none is left to enter, its lane is parked. Two blocks
//! in turns were measured to be no faster than one.

use crate::Control;
use crate::half_space::HalfSpace;
use crate::lanes::{Block, Events, LANES, Photon};
use crate::launches::Launches;
use crate::real::Real;
use crate::tally::Tally;
use std::ops::Range;

/// Steps between two looks at whether to stop.
const PATIENCE: u32 = 256;

/// See the module's first lines.
pub(crate) struct Flock<'a, R: Real> {
    half_space: &'a HalfSpace<'a>,
    table: &'a R::Table,
    /// Ascending, then infinity.
    bottoms: Vec<R>,
    launches: Launches<'a, R>,
    tallies: &'a mut [Tally],
    lanes: Block<R>,
    /// Photons in flight.
    alive: usize,
}

impl<'a, R: Real> Flock<'a, R> {
    #[inline(always)]
    pub fn new(half_space: &'a HalfSpace<'a>, photons: &'a [Range<u64>], tallies: &'a mut [Tally]) -> Self {
        for (photons, tally) in photons.iter().zip(tallies.iter_mut()) {
            tally.launch(photons.end - photons.start);
        }
        Self {
            half_space,
            table: R::table(half_space.medium),
            bottoms: half_space.bottoms.iter().copied().chain([f64::INFINITY]).map(R::rounded).collect(),
            launches: Launches::new(photons),
            tallies,
            lanes: Block::parked(),
            alive: LANES,
        }
    }

    /// Traces all of them, or as far as they came when cancelled.
    #[inline(always)]
    pub fn trace(mut self, control: Control<'_>) {
        (0..LANES).for_each(|lane| self.launch(lane));
        for step in 0_u32.. {
            if self.alive == 0 || step % PATIENCE == PATIENCE - 1 && control.is_cancelled() {
                return;
            }
            let events = self.lanes.collide_and_fly(self.table, self.half_space.absorbs_from);
            self.settle_all(events);
        }
    }

    #[inline(always)]
    fn settle_all(&mut self, events: Events) {
        for half in [0, 64] {
            let mut any = (events.any >> half) as u64;
            while any != 0 {
                let lane = half + any.trailing_zeros() as usize;
                any &= any - 1;
                self.settle(lane, (events.absorbed >> lane) & 1 == 1);
            }
        }
    }

    /// Counts what happened to a photon, and replaces it if it has ended.
    #[inline(always)]
    fn settle(&mut self, lane: usize, absorbed: bool) {
        let lanes = &self.lanes;
        let (depth, order) = (lanes.depth.0[lane], lanes.order(lane));
        let (batch, slab) = (lanes.batch.0[lane], lanes.slab.0[lane] as usize);
        if !absorbed {
            let up = depth < R::ZERO;
            self.tallies[batch as usize].leave(up, slab, order);
            if !up {
                let next = self.pass(batch, slab + 1, depth, order);
                if next + 1 < self.bottoms.len() {
                    let lanes = &mut self.lanes;
                    (lanes.slab.0[lane], lanes.bottom.0[lane]) = (next as u32, self.bottoms[next]);
                    return;
                }
            }
        } else if !lanes.is_parked(lane) {
            self.tallies[batch as usize].absorb(slab, order - 1);
        } else {
            return;
        }
        self.launch(lane);
    }

    /// Counts the slabs from `slab` on whose bottoms are above `depth`; returns the first that is not.
    #[inline(always)]
    fn pass(&mut self, batch: u32, mut slab: usize, depth: R, order: u32) -> usize {
        while depth >= self.bottoms[slab] {
            self.tallies[batch as usize].leave(false, slab, order);
            slab += 1;
        }
        slab
    }

    /// Starts the next photon that does not pass all slabs in its first flight; parks the lane if none is left.
    #[inline(always)]
    fn launch(&mut self, lane: usize) {
        while let Some(from) = self.launches.next(self.half_space.key, self.half_space.incidence) {
            let (depth, batch) = (self.launches.depth.0[from], self.launches.batch.0[from]);
            let slab = self.pass(batch, 0, depth, 0);
            if slab + 1 < self.bottoms.len() {
                let photon = Photon {
                    state: self.launches.streams.state.0[from],
                    increment: self.launches.streams.increment.0[from],
                    mu: self.launches.mu.0[from],
                    depth,
                    bottom: self.bottoms[slab],
                    batch,
                    slab: slab as u32,
                };
                return self.lanes.place(lane, photon);
            }
        }
        self.lanes.park(lane);
        self.alive -= 1;
    }
}
