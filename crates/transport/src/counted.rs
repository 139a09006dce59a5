//! What some photons of a trace have counted, and which are to be traced next.
//!
//! Tallies are integers and say nothing of the order in which photons came, so the counts of any photons can be
//! added to those of any others. Where a target error is set, the errors after a round decide how long the next one is
//! (they fall as one over the root of the photons), so that rounds are traced one after the other.

use crate::cells::{BATCHES, Cell, LONGEST, cells, fixed_round};
use crate::photon_set::PhotonSet;
use crate::tally::Tally;
use crate::{Stop, Stretch, TraceRequest, Traced, TransportError};
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

    /// The photons of `within` to trace next in one go, at most `longest`: none if nothing is left to do.
    pub fn next_stretch(
        &mut self,
        within: &Range<u64>,
        longest: u64,
    ) -> Result<Option<Stretch>, TransportError> {
        let Some(round) = self.next_round(within)? else { return Ok(None) };
        let mut within = within.clone();
        if self.request.stop.target().is_some() {
            self.round = round.clone();
            within.end = round.end;
        }
        let stretch = |gap: &Range<u64>| {
            let photons = gap.start..gap.end.min(gap.start.saturating_add(longest));
            let last_round = match self.request.stop {
                Stop::Photons(max) => fixed_round(photons.end - 1, max),
                Stop::StdError { .. } => round.clone(),
            };
            Stretch { photons, first_round: round.start, last_round }
        };
        Ok(self.photons.gaps(&within).first().map(stretch))
    }

    /// Adds what the photons of `cell` have counted.
    pub fn add(&mut self, cell: &Cell, tally: &Tally) -> Result<(), TransportError> {
        self.check_uncounted(&cell.photons)?;
        check_launched(&cell.photons, cell.photons.end - cell.photons.start, tally.launched)?;
        self.batches[cell.batch].add(tally);
        self.photons.insert(cell.photons.clone());
        Ok(())
    }

    /// Adds what the photons of `stretch` have counted, batch by batch.
    pub fn add_stretch(&mut self, stretch: &Stretch, batches: &[Tally]) -> Result<(), TransportError> {
        self.check_uncounted(&stretch.photons)?;
        for (share, batch) in stretch.shares().into_iter().zip(batches) {
            check_launched(&stretch.photons, share, batch.launched)?;
        }
        self.batches.iter_mut().zip(batches).for_each(|(sum, batch)| sum.add(batch));
        self.photons.insert(stretch.photons.clone());
        Ok(())
    }

    fn check_uncounted(&self, photons: &Range<u64>) -> Result<(), TransportError> {
        match self.photons.common(photons) {
            Some(common) => Err(TransportError::CountedTwice { from: common.start, to: common.end }),
            None => Ok(()),
        }
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

/// Whether of `photons` as many were launched as there are of them, or of them in one batch.
fn check_launched(photons: &Range<u64>, wanted: u64, launched: u64) -> Result<(), TransportError> {
    let Range { start: from, end: to } = *photons;
    if launched == wanted { Ok(()) } else { Err(TransportError::Launched { from, to, launched }) }
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Quantity;
    use stratiform_quantities::{Incidence, Order};

    /// 10¹² photons, reflected by all slabs after a million scatterings each or passed by all after three million: no counter is
    /// full, no photon is lost. A sum that is full is refused.
    #[test]
    fn a_million_million_photons_overflow_nothing() {
        let photons = 1_000_000_000_000;
        let (stop, incidence) = (Stop::Photons(photons), Incidence::Diffuse);
        let tau = vec![1.0, 1e6];
        let request = TraceRequest { tau, incidence, stop, max_order: 1, seed: 1, stream: 0 };
        let mut counted = Counted::nothing(&request, true);
        counted.photons.insert(0..photons);
        for batch in &mut counted.batches {
            let share = photons / BATCHES as u64;
            let (passed, turned) = (share / 2, share - share / 2);
            batch.launched = share;
            batch.reflected[2] = turned;
            batch.turned[0] = turned * 1_000_000;
            (batch.transmitted[2], batch.transmitted[5]) = (passed, passed);
            (batch.passed[0], batch.passed[1]) = (passed * 3_000_000, passed * 3_000_000);
        }
        assert!(counted.is_sound());
        let traced = counted.finish().unwrap();
        assert_eq!(traced.photons(), photons);
        for slab in 0..2 {
            assert_eq!(traced.hits(slab, Quantity::Reflectance(Order::Tail)), photons / 2);
            assert_eq!(traced.hits(slab, Quantity::Transmittance(Order::Total)), photons / 2);
            assert!((traced.mean_scatterings(slab).value - 2e6).abs() < 1.0);
        }
        counted.batches[7].passed[1] = u64::MAX;
        assert_eq!(counted.finish(), Err(TransportError::TooManyScatterings { tau: 1e6 }));
    }

    #[test]
    fn contradictions_are_seen() {
        let stop = Stop::StdError { target: 1e-3, max_photons: 1000 };
        let (tau, incidence) = (vec![1.0], Incidence::Diffuse);
        let request = TraceRequest { tau, incidence, stop, max_order: 1, seed: 1, stream: 0 };
        let good = Counted::nothing(&request, true);
        assert!(good.is_sound());
        let damages: [fn(&mut Counted); 8] = [
            |counted| counted.photons.insert(0..5),
            |counted| counted.batches[3].launched = 5,
            |counted| counted.batches[3].reflected.push(0),
            |counted| counted.batches[3].bins = 2,
            |counted| drop(counted.batches.pop()),
            |counted| counted.round = 0..1001,
            |counted| counted.request.tau.push(f64::NAN),
            |counted| {
                counted.photons.insert(999..1001);
                counted.batches[0].launched = 2;
            },
        ];
        for (index, damage) in damages.iter().enumerate() {
            let mut counted = good.clone();
            damage(&mut counted);
            assert!(!counted.is_sound(), "damage {index}");
        }
    }
}
