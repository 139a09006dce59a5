//! Photons on their way through the lanes: they enter, are counted, and leave.
//!
//! A photon that ends is replaced by the next one at once; when none is left to enter, its lane is parked. Two blocks
//! in turns were measured to be no faster than one.

use crate::Control;
use crate::half_space::HalfSpace;
use crate::lanes::{Block, Events, LANES, LanesOf, Photon};
use crate::launches::Launches;
use crate::ledger::Ledger;
use crate::real::Real;
use crate::tally::Tally;
use std::ops::Range;

/// Steps between two looks at whether to stop.
const PATIENCE: u32 = 256;

/// See the module's first lines.
pub(crate) struct Flock<'a, R: Real> {
    half_space: &'a HalfSpace<'a>,
    table: &'a R::Table,
    /// Of every row of the ledger: for each tally ascending, then infinity.
    bottoms: Vec<R>,
    /// The same with 0 for infinity: nothing flies on there.
    limits: Vec<R>,
    launches: Launches<'a, R>,
    ledger: Ledger,
    lanes: Block<R>,
    /// Photons in flight.
    alive: usize,
}

impl<'a, R: Real> Flock<'a, R> {
    /// Traces `photons`, each range into its tally, or as far as they came when cancelled.
    #[inline(always)]
    pub fn trace(
        half_space: &'a HalfSpace<'a>,
        photons: &'a [Range<u64>],
        tallies: &mut [Tally],
        control: Control<'_>,
    ) {
        let Some(first) = tallies.first() else { return };
        let slabs: Vec<R> =
            half_space.bottoms.iter().copied().chain([f64::INFINITY]).map(R::rounded).collect();
        let bottoms = slabs.repeat(photons.len());
        let mut flock = Self {
            half_space,
            table: R::table(half_space.medium),
            ledger: Ledger::new(first, bottoms.len()),
            limits: bottoms
                .iter()
                .map(|&bottom| if bottom < R::INFINITY { bottom } else { R::ZERO })
                .collect(),
            bottoms,
            launches: Launches::new(photons, slabs),
            lanes: Block::parked(),
            alive: LANES,
        };
        flock.run(control);
        for (photons, tally) in photons.iter().zip(tallies.iter_mut()) {
            tally.launch(photons.end - photons.start);
        }
        flock.ledger.close(tallies);
    }

    #[inline(always)]
    fn run(&mut self, control: Control<'_>) {
        (0..LANES).for_each(|lane| self.launch(lane));
        let mut step = 0_u32;
        loop {
            step = step.wrapping_add(1);
            if self.alive == 0 || step.is_multiple_of(PATIENCE) && control.is_cancelled() {
                return;
            }
            let events = self.lanes.collide_and_fly(self.table, self.half_space.absorbs_from);
            self.settle_all(events);
        }
    }

    #[inline(always)]
    fn settle_all(&mut self, events: Events) {
        for lane in LanesOf(events.absorbed) {
            self.absorb(lane);
        }
        for lane in LanesOf(events.left) {
            self.settle(lane);
        }
    }

    /// Counts an absorbed photon, which flew on for nothing, and replaces it.
    #[inline(always)]
    fn absorb(&mut self, lane: usize) {
        if !self.lanes.is_parked(lane) {
            self.ledger.absorb(self.lanes.row.0[lane] as usize, self.lanes.order(lane) - 1);
            self.launch(lane);
        }
    }

    /// Counts what passed its bottom or the top, and replaces it if it has ended.
    #[inline(always)]
    fn settle(&mut self, lane: usize) {
        let lanes = &self.lanes;
        let (depth, order, row) = (lanes.depth.0[lane], lanes.order(lane), lanes.row.0[lane] as usize);
        let up = depth < R::ZERO;
        self.ledger.leave(up, row, order);
        // What is above the top is above all bottoms: nobody could predict a branch on `up`.
        let mut next = row + 1;
        if depth >= self.bottoms[next] {
            next = self.pass(next, depth, order);
        }
        let limit = self.limits[next];
        if depth.is_out(limit) {
            self.launch(lane);
        } else {
            (self.lanes.row.0[lane], self.lanes.bottom.0[lane]) = (next as u32, limit);
        }
    }

    /// Counts the rows from `row` on whose bottoms are above `depth`; returns the first that is not.
    #[inline(never)]
    fn pass(&mut self, mut row: usize, depth: R, order: u64) -> usize {
        while depth >= self.bottoms[row] {
            self.ledger.leave(false, row, order);
            row += 1;
        }
        row
    }

    /// Starts the next photon that does not pass all slabs in its first flight; parks the lane if none is left.
    #[inline(always)]
    fn launch(&mut self, lane: usize) {
        while let Some(from) = self.launches.next(self.half_space.key, self.half_space.incidence) {
            let (depth, row) = (self.launches.depth.0[from], self.launches.row.0[from] as usize);
            self.ledger.enter(row);
            let limit = self.limits[row];
            if !depth.is_out(limit) {
                let photon = Photon {
                    state: self.launches.streams.state.0[from],
                    increment: self.launches.streams.increment.0[from],
                    mu: self.launches.mu.0[from],
                    depth,
                    bottom: limit,
                    row: row as u32,
                };
                return self.lanes.place(lane, photon);
            }
        }
        self.lanes.park(lane);
        self.alive -= 1;
    }
}
