//! Photons counted for their fluxes alone, all slabs at once.
//!
//! Orders that are listed by themselves are counted by [`Generations`]. A photon of the tail is counted when it ends, by its
//! greatest depth: what it passed since it left its generation, and where it turned. The number of its scatterings at each bottom is
//! lost, and with it that of the slab.

use crate::Control;
use crate::fluxes::Extent;
use crate::generations::{Generations, first_below};
use crate::half_space::HalfSpace;
use crate::lanes::{Block, LANES, LaneList, LanesOf, Row};
use crate::real::Real;
use crate::tally::Tally;
use std::ops::Range;

/// Steps between two looks at whether to stop.
const PATIENCE: u32 = 256;

/// Traces `photons`, each range into its tally, or as far as they came when cancelled.
#[inline(always)]
pub(crate) fn trace<R: Real>(
    half_space: &HalfSpace<'_>,
    extent: Extent,
    photons: &[Range<u64>],
    tallies: &mut [Tally],
    control: Control<'_>,
) {
    let Some(first) = tallies.first() else { return };
    let max_order = first.bins as u32 - 2;
    let bottoms: Vec<R> = half_space.bottoms.iter().copied().map(R::rounded).collect();
    for (photons, tally) in photons.iter().zip(tallies.iter_mut()) {
        tally.launch(photons.end - photons.start);
    }
    let table = R::table(half_space.medium);
    let generations = Generations::<R>::new(half_space, table, &bottoms, photons);
    match extent {
        Extent::ListedOrders => leave_the_rest(generations, max_order, bottoms.len(), tallies, control),
        Extent::ToTheEnd => {
            let tails = vec![Tail::new(bottoms.len()); tallies.len()];
            let mut flock = Flock {
                half_space,
                table,
                bottoms: &bottoms,
                generations,
                max_order,
                lanes: Block::parked(),
                deepest: Row([R::ZERO; LANES]),
                free: LaneList::all(),
                waiting: (LaneList::none(), 0),
                tails,
            };
            if flock.run(tallies, control) {
                flock.tails.iter().zip(tallies).for_each(|(tail, tally)| tail.close(tally));
            }
        }
    }
}

/// Counts what is still inside after the listed orders as absorbed there.
#[inline(always)]
fn leave_the_rest<R: Real>(
    mut generations: Generations<'_, R>,
    max_order: u32,
    slabs: usize,
    tallies: &mut [Tally],
    control: Control<'_>,
) {
    while let Some(range) = generations.next_row(max_order, tallies) {
        let mut inside = generations.inside().count_ones();
        for slab in 0..slabs {
            let past = generations.inside_past(slab);
            tallies[range].absorbed[slab] += u64::from(inside - past);
            inside = past;
        }
        if control.is_cancelled() {
            return;
        }
    }
}

/// What photons of one tally did after the listed orders.
#[derive(Clone)]
struct Tail {
    /// Those that had been below each bottom before.
    past: Vec<u64>,
    /// Those that ended, by the first bottom below their greatest depth.
    ended: Vec<u64>,
    /// Those of them that turned.
    turned: Vec<u64>,
    /// Those that were absorbed.
    absorbed: Vec<u64>,
}

impl Tail {
    fn new(slabs: usize) -> Self {
        let [ended, turned, absorbed] = std::array::from_fn(|_| vec![0; slabs + 1]);
        Self { past: vec![0; slabs], ended, turned, absorbed }
    }

    fn close(&self, tally: &mut Tally) {
        let mut below = 0;
        for slab in (0..self.past.len()).rev() {
            below += self.ended[slab + 1];
            tally.add_tail(slab, below - self.past[slab], self.turned[slab], self.absorbed[slab]);
        }
    }
}

struct Flock<'a, R: Real> {
    half_space: &'a HalfSpace<'a>,
    table: &'a R::Table,
    bottoms: &'a [R],
    generations: Generations<'a, R>,
    max_order: u32,
    /// A row is the place of the photon's tally here.
    lanes: Block<R>,
    /// Greatest depths before the last flight.
    deepest: Row<R>,
    /// Lanes without a photon.
    free: LaneList,
    /// Photons that have been through their generations, and the place of their tally.
    waiting: (LaneList, usize),
    tails: Vec<Tail>,
}

impl<R: Real> Flock<'_, R> {
    /// Whether all photons came to their end.
    #[inline(always)]
    fn run(&mut self, tallies: &mut [Tally], control: Control<'_>) -> bool {
        let mut alive = LANES;
        let mut step = 0_u32;
        loop {
            while let Some(lane) = self.free.pop() {
                if !self.launch(lane, tallies) {
                    self.lanes.park(lane);
                    alive -= 1;
                }
            }
            step = step.wrapping_add(1);
            if alive == 0 || step.is_multiple_of(PATIENCE) && control.is_cancelled() {
                return alive == 0;
            }
            self.step();
        }
    }

    #[inline(always)]
    fn step(&mut self) {
        let events = self.lanes.collide_and_fly(self.table, self.half_space.absorbs_from);
        for lane in LanesOf(events.absorbed) {
            // An absorbed photon flew on for nothing.
            if !self.lanes.is_parked(lane) {
                let below = self.end(lane, self.deepest.0[lane]);
                self.tail(lane).absorbed[below] += 1;
            }
        }
        for k in 0..LANES {
            let (depth, deepest) = (self.lanes.depth.0[k], self.deepest.0[k]);
            self.deepest.0[k] = if depth > deepest { depth } else { deepest };
        }
        for lane in LanesOf(events.left) {
            let below = self.end(lane, self.deepest.0[lane]);
            let up = self.lanes.depth.0[lane] < R::ZERO;
            self.tail(lane).turned[below] += u64::from(up);
        }
    }

    /// Counts the end of the photon in `lane`, which came as far as `deepest`; returns the first slab whose bottom is below that.
    #[inline(always)]
    fn end(&mut self, lane: usize, deepest: R) -> usize {
        let below = first_below(self.bottoms, deepest);
        self.tail(lane).ended[below] += 1;
        self.free.push(lane);
        below
    }

    #[inline(always)]
    fn tail(&mut self, lane: usize) -> &mut Tail {
        &mut self.tails[self.lanes.row.0[lane] as usize]
    }

    /// Starts the next photon that is inside after its listed orders; false if none is left.
    #[inline(always)]
    fn launch(&mut self, lane: usize, tallies: &mut [Tally]) -> bool {
        loop {
            let (waiting, range) = &mut self.waiting;
            if let Some(from) = waiting.pop() {
                self.deepest.0[lane] = self.generations.deepest.0[from];
                self.lanes.place(lane, self.generations.block.photon(from, *range as u32));
                return true;
            }
            let Some(range) = self.generations.next_row(self.max_order, tallies) else { return false };
            for (slab, past) in self.tails[range].past.iter_mut().enumerate() {
                *past += u64::from(self.generations.inside_past(slab));
            }
            self.waiting.1 = range;
            for lane in LanesOf(self.generations.inside()) {
                self.waiting.0.push(lane);
            }
        }
    }
}
