//! What some photons of a trace have counted, and which are to be traced next.
//!
//! Tallies are integers and say nothing of the order in which photons came, so the counts of any photons can be
//! added to those of any others. Where a target error is set, the errors after a round decide how long the next one is
//! (they fall as one over the root of the photons), so that rounds are traced one after the other.

use crate::cells::{BATCHES, Cell, LONGEST, cells, fixed_round};
use crate::photon_set::PhotonSet;
use crate::tally::Tally;
use crate::{Stop, TraceRequest, Traced, TransportError};
use serde::{Deserialize, Serialize};
use std::ops::Range;

/// Photons of the first round where a target error is set.
const FIRST: u64 = 1 << 16;
/// Photons of the shortest round after it.
const SHORTEST: u64 = 1 << 14;

/// Counts of some photons of a request.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct Counted {
    pub request: TraceRequest,
    photons: PhotonSet,
    /// The present round, where a target error is set: those before it are complete.
    round: Range<u64>,
    batches: Vec<Tally>,
}

impl Counted {
    /// No photon yet, of a request that has been checked. Nested tallies count an end for all thicker slabs too.
    pub fn nothing(request: &TraceRequest, nested: bool) -> Self {
        let round = match request.stop {
            Stop::Photons(_) => 0..0,
            Stop::StdError { max_photons, .. } => 0..max_photons.min(FIRST),
        };
        let batches = vec![Tally::new(request.tau.len(), request.bins(), nested); BATCHES];
        Self { request: request.clone(), photons: PhotonSet::default(), round, batches }
    }

    /// Which photons are counted.
    pub fn photons(&self) -> &PhotonSet {
        &self.photons
    }

    /// A tally of no photon, in the shape of this one's.
    pub fn empty_tally(&self) -> Tally {
        let batch = &self.batches[0];
        Tally::new(self.request.tau.len(), self.request.bins(), batch.nested)
    }

    /// The cells of `within` to trace next, in pieces of at most `longest` photons: none if nothing is left to do.
    /// The same until they are added.
    pub fn next(&mut self, within: &Range<u64>, longest: u64) -> Result<Vec<Cell>, TransportError> {
        let Some(round) = self.next_round(within)? else { return Ok(Vec::new()) };
        if self.request.stop.target().is_some() {
            self.round = round.clone();
        }
        let within = within.start.max(round.start)..within.end.min(round.end);
        let gaps = self.photons.gaps(&within);
        Ok(gaps.iter().flat_map(|gap| cells(&round, gap, longest)).collect())
    }

    /// The first round that lacks photons of `within`; none if nothing is left to do.
    pub fn next_round(&self, within: &Range<u64>) -> Result<Option<Range<u64>>, TransportError> {
        let Stop::StdError { target, max_photons } = self.request.stop else {
            let first = self.photons.first_gap(within);
            return Ok(first.map(|photon| fixed_round(photon, self.request.stop.max_photons())));
        };
        if self.photons.first_gap(&self.round).is_some() {
            return Ok(Some(self.round.clone()));
        }
        let (traced, done) = (self.traced()?, self.round.end);
        if done == max_photons || traced.target_reached() == Some(true) {
            return Ok(None);
        }
        let length = photons_to_go(done, traced.worst_error() / target);
        Ok(Some(done..max_photons.min(done + length)))
    }

    /// Adds what the photons of `cell` have counted.
    pub fn add(&mut self, cell: &Cell, tally: &Tally) -> Result<(), TransportError> {
        let photons = cell.photons.clone();
        if let Some(common) = self.photons.common(&photons) {
            return Err(TransportError::CountedTwice { from: common.start, to: common.end });
        }
        if tally.launched != photons.end - photons.start {
            return Err(TransportError::Launched {
                from: photons.start,
                to: photons.end,
                launched: tally.launched,
            });
        }
        self.batches[cell.batch].add(tally);
        self.photons.insert(photons);
        Ok(())
    }

    /// Adds the counts of other photons of the same request.
    pub fn merge(&mut self, other: &Self) -> Result<(), TransportError> {
        if self.request.stop.target().is_some() {
            return Err(TransportError::OneAfterTheOther);
        }
        let held = other.photons.ranges().iter().find_map(|range| self.photons.common(range));
        if let Some(common) = held {
            return Err(TransportError::CountedTwice { from: common.start, to: common.end });
        }
        self.batches.iter_mut().zip(&other.batches).for_each(|(sum, batch)| sum.add(batch));
        other.photons.ranges().iter().for_each(|range| self.photons.insert(range.clone()));
        Ok(())
    }

    /// Photons of `within` that are not counted yet, as ranges.
    pub fn missing(&self, within: &Range<u64>) -> Vec<Range<u64>> {
        self.photons.gaps(within)
    }

    /// The result, if every photon has been counted.
    pub fn finish(&self) -> Result<Traced, TransportError> {
        let end = match self.request.stop {
            Stop::Photons(max) => max,
            Stop::StdError { .. } => self.round.end,
        };
        let missing = |gaps: Vec<Range<u64>>| {
            let photons = gaps.iter().map(|gap| gap.end - gap.start).sum();
            gaps.first().map(|gap| TransportError::Missing { photons, from: gap.start, to: gap.end })
        };
        if let Some(error) = missing(self.missing(&(0..end))) {
            return Err(error);
        }
        let traced = self.traced()?;
        let max = self.request.stop.max_photons();
        if traced.target_reached() == Some(false) && end < max {
            return Err(TransportError::Missing { photons: max - end, from: end, to: max });
        }
        Ok(traced)
    }

    /// The estimates so far.
    fn traced(&self) -> Result<Traced, TransportError> {
        let traced = Traced::new(&self.request, &ascending(&self.request.tau).1, &self.batches)?;
        Ok(match self.request.stop.target() {
            Some(target) => traced.held_against(target),
            None => traced,
        })
    }

    /// Whether the numbers can be what they say: false for damaged ones.
    pub fn is_sound(&self) -> bool {
        let (request, max) = (&self.request, self.request.stop.max_photons());
        let shape = |batch: &Tally| batch.has_shape(request.tau.len(), request.bins());
        let launched = self.batches.iter().fold(0_u64, |sum, batch| sum.saturating_add(batch.launched));
        request.check().is_ok()
            && self.photons.is_sound()
            && self.photons.ranges().last().is_none_or(|last| last.end <= max)
            && self.round.start <= self.round.end
            && self.round.end <= max
            && self.batches.len() == BATCHES
            && self.batches.iter().all(shape)
            && launched == self.photons.len()
    }
}

/// Length of the next round when `done` photons left the error `excess` times too large; 2 % are added so that one
/// more round is usually enough.
fn photons_to_go(done: u64, excess: f64) -> u64 {
    let photons = done as f64 * (1.02 * excess * excess - 1.0);
    photons.clamp(SHORTEST as f64, LONGEST as f64) as u64
}

/// Thicknesses in ascending order, and for each given one its place there.
pub(crate) fn ascending(tau: &[f64]) -> (Vec<f64>, Vec<usize>) {
    let mut places: Vec<usize> = (0..tau.len()).collect();
    places.sort_by(|&a, &b| tau[a].total_cmp(&tau[b]));
    let mut rank = vec![0; tau.len()];
    places.iter().enumerate().for_each(|(place, &given)| rank[given] = place);
    (places.iter().map(|&given| tau[given]).collect(), rank)
}
