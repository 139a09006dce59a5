//! Photons on their way through the lanes: they enter, are counted, and leave.
//!
//! What a step of one block brought about is settled after the next block's step. So what is written into a lane by
//! itself has long reached the cache when it is read as part of a vector, and mispredicted branches cost
//! little, for there is arithmetic to do meanwhile. When no photon is left to enter, lanes are parked, and
//! the photons of the last block move into the parked lanes of the others as soon as they fit.

use crate::Control;
use crate::half_space::HalfSpace;
use crate::lanes::{Block, Events, LANES, Photon};
use crate::launches::Launches;
use crate::real::Real;
use crate::tally::Tally;
use std::ops::Range;

/// Blocks of one flock.
const BLOCKS: usize = 2;
/// Rounds between two looks at whether to stop.
const PATIENCE: u32 = 256;

/// See the module's first lines.
pub(crate) struct Flock<'a, R: Real> {
    half_space: &'a HalfSpace<'a>,
    table: &'a R::Table,
    /// Ascending, then infinity.
    bottoms: Vec<R>,
    launches: Launches<'a, R>,
    tallies: &'a mut [Tally],
    blocks: [Block<R>; BLOCKS],
    /// Blocks in use.
    used: usize,
    /// Photons in flight.
    alive: usize,
    /// The block whose last step is not settled, and what it brought about.
    pending: (usize, Events),
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
            blocks: std::array::from_fn(|_| Block::parked()),
            used: BLOCKS,
            alive: 0,
            pending: (0, Events::default()),
        }
    }

    /// Traces all of them, or as far as they came when cancelled.
    #[inline(always)]
    pub fn trace(mut self, control: Control<'_>) {
        self.alive = BLOCKS * LANES;
        (0..BLOCKS).for_each(|block| (0..LANES).for_each(|lane| self.launch(block, lane)));
        for round in 0_u32.. {
            if self.alive == 0 || round % PATIENCE == PATIENCE - 1 && control.is_cancelled() {
                return;
            }
            self.round();
            if self.alive <= (self.used - 1) * LANES {
                self.settle_pending();
                self.close_ranks();
            }
        }
    }

    /// One step of every block in use, each settled after the next one's.
    #[inline(always)]
    fn round(&mut self) {
        for block in 0..self.used {
            let events = self.blocks[block].collide_and_fly(self.table, self.half_space.absorbs_from);
            self.settle_pending();
            self.pending = (block, events);
        }
        if self.used == 1 {
            self.settle_pending();
        }
    }

    #[inline(always)]
    fn settle_pending(&mut self) {
        let (block, events) = std::mem::take(&mut self.pending);
        for half in [0, 64] {
            let mut any = (events.any >> half) as u64;
            while any != 0 {
                let lane = half + any.trailing_zeros() as usize;
                any &= any - 1;
                self.settle(block, lane, (events.absorbed >> lane) & 1 == 1);
            }
        }
    }

    /// Counts what happened to a photon, and replaces it if it has ended.
    #[inline(always)]
    fn settle(&mut self, block: usize, lane: usize, absorbed: bool) {
        let lanes = &self.blocks[block];
        let (depth, order) = (lanes.depth.0[lane], lanes.order(lane));
        let (batch, slab) = (lanes.batch.0[lane], lanes.slab.0[lane] as usize);
        if !absorbed {
            let up = depth < R::ZERO;
            self.tallies[batch as usize].leave(up, slab, order);
            if !up {
                let next = self.pass(batch, slab + 1, depth, order);
                if next + 1 < self.bottoms.len() {
                    let lanes = &mut self.blocks[block];
                    (lanes.slab.0[lane], lanes.bottom.0[lane]) = (next as u32, self.bottoms[next]);
                    return;
                }
            }
        } else if !lanes.is_parked(lane) {
            self.tallies[batch as usize].absorb(slab, order - 1);
        } else {
            return;
        }
        self.launch(block, lane);
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
    fn launch(&mut self, block: usize, lane: usize) {
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
                    order: 0,
                };
                return self.blocks[block].place(lane, photon);
            }
        }
        self.blocks[block].park(lane);
        self.alive -= 1;
    }

    /// Moves the photons of the last block into parked lanes of the others, which are enough.
    #[cold]
    #[inline(never)]
    fn close_ranks(&mut self) {
        self.used -= 1;
        let mut free = (0..self.used).flat_map(|block| (0..LANES).map(move |lane| (block, lane)));
        for lane in 0..LANES {
            if !self.blocks[self.used].is_parked(lane) {
                let photon = self.blocks[self.used].photon(lane);
                if let Some((block, lane)) = free.find(|&(block, lane)| self.blocks[block].is_parked(lane)) {
                    self.blocks[block].place(lane, photon);
                }
            }
        }
    }
}
