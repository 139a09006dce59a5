//! Photons on their way through the lanes: they enter, are counted, and leave.
//!
//! Lanes in use are always the first ones: a photon that ends is replaced by the next one or, when none is
//! left, by the photon of the last lane in use. A lane is looked at again only after all blocks have had their turn,
//! so that what was written into it by itself has long reached the cache when it is read as part of a vector.

use crate::Control;
use crate::half_space::HalfSpace;
use crate::lanes::{Block, Events, LANES, Photon};
use crate::launches::Launches;
use crate::real::Real;
use crate::tally::Tally;
use std::ops::Range;

/// Blocks of one flock.
const BLOCKS: usize = 2;

/// See the module's first lines.
pub(crate) struct Flock<'a, R: Real> {
    half_space: &'a HalfSpace<'a>,
    table: &'a R::Table,
    /// Ascending, then infinity.
    bottoms: Vec<R>,
    launches: Launches<'a, R>,
    tallies: &'a mut [Tally],
    blocks: [Block<R>; BLOCKS],
    /// Lanes in use.
    used: usize,
    step: u32,
}

impl<'a, R: Real> Flock<'a, R> {
    pub fn new(half_space: &'a HalfSpace<'a>, photons: &'a [Range<u64>], tallies: &'a mut [Tally]) -> Self {
        for (photons, tally) in photons.iter().zip(tallies.iter_mut()) {
            tally.launch(photons.end - photons.start);
        }
        let bottoms = half_space.bottoms.iter().copied().chain([f64::INFINITY]).map(R::rounded).collect();
        let (launches, blocks) = (Launches::new(photons), std::array::from_fn(|_| Block::parked()));
        let table = R::table(half_space.medium);
        Self { half_space, table, bottoms, launches, tallies, blocks, used: 0, step: 0 }
    }

    /// Traces all of them, or as far as they came when cancelled.
    #[inline(always)]
    pub fn trace(mut self, control: Control<'_>) {
        while self.used < BLOCKS * LANES && self.launch(self.used) {
            self.used += 1;
        }
        let absorbs_from = self.half_space.absorbs_from;
        while self.used > 0 {
            self.step = self.step.wrapping_add(1);
            let mut events = [Events::default(); BLOCKS];
            for (block, events) in self.blocks.iter_mut().zip(&mut events).take(self.used.div_ceil(LANES)) {
                *events = block.collide_and_fly(self.table, absorbs_from);
            }
            for block in (0..self.used.div_ceil(LANES)).rev() {
                self.settle_block(block, events[block]);
            }
            if self.step % 256 == 0 && control.is_cancelled() {
                return;
            }
        }
    }

    /// Last lane first, so that the photon of the last lane in use, which may replace another, has been counted.
    #[inline(always)]
    fn settle_block(&mut self, block: usize, events: Events) {
        let mut any = events.any;
        while any != 0 {
            let lane = 63 - any.leading_zeros() as usize;
            any ^= 1 << lane;
            if block * LANES + lane < self.used {
                self.settle(block * LANES + lane, (events.absorbed >> lane) & 1 == 1);
            }
        }
    }

    /// Counts what happened to a photon, and replaces it if it has ended.
    #[inline(always)]
    fn settle(&mut self, lane: usize, absorbed: bool) {
        let (block, k) = (&self.blocks[lane / LANES], lane % LANES);
        let (slab, depth, batch) = (block.slab[k], block.depth[k], block.batch[k]);
        let order = self.step.wrapping_sub(block.born[k]);
        if absorbed {
            self.tallies[batch as usize].absorb(slab as usize, order - 1);
        } else {
            let up = depth < R::ZERO;
            self.tallies[batch as usize].leave(up, slab as usize, order);
            if !up {
                let next = self.pass(batch, slab as usize + 1, depth, order);
                if next + 1 < self.bottoms.len() {
                    let block = &mut self.blocks[lane / LANES];
                    (block.slab[k], block.bottom[k]) = (next as u32, self.bottoms[next]);
                    return;
                }
            }
        }
        if !self.launch(lane) {
            self.close_gap(lane);
        }
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

    /// Starts the next photon that does not pass all slabs in its first flight; false if none is left.
    #[inline(always)]
    fn launch(&mut self, lane: usize) -> bool {
        while let Some(from) = self.launches.next(self.half_space.key, self.half_space.incidence) {
            let (depth, batch) = (self.launches.depth[from], self.launches.batch[from]);
            let slab = self.pass(batch, 0, depth, 0);
            if slab + 1 < self.bottoms.len() {
                let photon = Photon {
                    state: self.launches.streams.state[from],
                    increment: self.launches.streams.increment[from],
                    mu: self.launches.mu[from],
                    depth,
                    bottom: self.bottoms[slab],
                    batch,
                    slab: slab as u32,
                    born: self.step,
                };
                self.blocks[lane / LANES].place(lane % LANES, photon);
                return true;
            }
        }
        false
    }

    /// Moves the photon of the last lane in use to `lane`.
    fn close_gap(&mut self, lane: usize) {
        self.used -= 1;
        let last = self.blocks[self.used / LANES].photon(self.used % LANES);
        self.blocks[lane / LANES].place(lane % LANES, last);
        self.blocks[self.used / LANES].park(self.used % LANES);
    }
}
