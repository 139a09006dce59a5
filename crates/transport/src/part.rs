//! What some photons of a trace have counted, with all that says which trace: it can be stored, sent, and merged.
//!
//! Counts are integers and each photon has its own random stream: parts of a trace add up to the same numbers whoever
//! traced which photons, and in which order. A part refuses photons that it has already, and the photons of any other
//! trace; it finishes only when none is missing.

use crate::cells::Cell;
use crate::counted::Counted;
use crate::{Share, Stop, Stretch, Tally, TraceMedium, TraceRequest, Traced, TransportError, fingerprint};
use serde::{Deserialize, Serialize};
use std::ops::Range;

/// What the photons of a trace depend on besides the request.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Identity {
    tracer: String,
    algorithm: String,
    medium: String,
}

impl Identity {
    /// `tracer` is its name; `algorithm` differs wherever the same photon may fare otherwise.
    pub fn new(tracer: &str, algorithm: &str, medium: &TraceMedium) -> Self {
        let (tracer, algorithm) = (tracer.to_owned(), algorithm.to_owned());
        Self { tracer, algorithm, medium: fingerprint::of_medium(medium) }
    }
}

/// Counts of some photons of one trace.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "Unchecked")]
pub struct Part {
    identity: Identity,
    counted: Counted,
}

/// As read, before it is known whether the numbers can be what they say.
#[derive(Deserialize)]
struct Unchecked {
    identity: Identity,
    counted: Counted,
}

impl TryFrom<Unchecked> for Part {
    type Error = TransportError;

    fn try_from(Unchecked { identity, counted }: Unchecked) -> Result<Self, TransportError> {
        if counted.is_sound() { Ok(Self { identity, counted }) } else { Err(TransportError::Damaged) }
    }
}

impl Part {
    /// No photon yet: for an engine that is not of this crate. `nested` says that its tallies count an end for all
    /// thicker slabs too.
    ///
    /// # Errors
    /// [`TransportError`] naming the number of the request that is out of domain.
    pub fn of_engine(
        identity: Identity,
        request: &TraceRequest,
        nested: bool,
    ) -> Result<Self, TransportError> {
        request.check()?;
        Ok(Self::nothing(identity, request, nested))
    }

    pub(crate) fn nothing(identity: Identity, request: &TraceRequest, nested: bool) -> Self {
        Self { identity, counted: Counted::nothing(request, nested) }
    }

    /// The request.
    pub fn request(&self) -> &TraceRequest {
        &self.counted.request
    }

    /// Number of photons counted.
    pub fn photons(&self) -> u64 {
        self.counted.photons().len()
    }

    /// The photons of `share`.
    ///
    /// # Errors
    /// [`TransportError::OneAfterTheOther`] for less than the whole of a trace that has a target error.
    pub fn share(&self, share: Share) -> Result<Range<u64>, TransportError> {
        match self.request().stop {
            Stop::StdError { .. } if share.of() > 1 => Err(TransportError::OneAfterTheOther),
            stop => Ok(share.photons(stop.max_photons())),
        }
    }

    /// What to trace next of `share`, in pieces of at most `longest` photons: none if nothing is left. Each piece is
    /// to be [added](Self::add) once.
    ///
    /// # Errors
    /// As [`share`](Self::share).
    pub fn next(&mut self, share: Share, longest: u64) -> Result<Vec<Cell>, TransportError> {
        let within = self.share(share)?;
        self.counted.next(&within, longest)
    }

    /// What to trace next of `share` in one go, at most `longest` photons, for an engine that takes many at once; it is to be
    /// [added](Self::add_stretch) once.
    ///
    /// # Errors
    /// As [`share`](Self::share).
    pub fn next_stretch(&mut self, share: Share, longest: u64) -> Result<Option<Stretch>, TransportError> {
        let within = self.share(share)?;
        self.counted.next_stretch(&within, longest)
    }

    /// A tally of no photon in the shape that [`add`](Self::add) takes.
    pub fn empty_tally(&self) -> Tally {
        self.counted.empty_tally()
    }

    /// Adds what the photons of `cell` have counted.
    ///
    /// # Errors
    /// [`TransportError::CountedTwice`] if some are counted already, [`Launched`](TransportError::Launched) if there
    /// are more or fewer of them, [`Shape`](TransportError::Shape) if the tally is of other slabs or orders.
    pub fn add(&mut self, cell: &Cell, tally: &Tally) -> Result<(), TransportError> {
        self.check_shape(tally)?;
        self.counted.add(cell, tally)
    }

    /// Adds what the photons of `stretch` have counted, one tally per batch.
    ///
    /// # Errors
    /// As [`add`](Self::add).
    pub fn add_stretch(
        &mut self,
        stretch: &Stretch,
        batches: &[Tally; Stretch::BATCHES],
    ) -> Result<(), TransportError> {
        batches.iter().try_for_each(|tally| self.check_shape(tally))?;
        self.counted.add_stretch(stretch, batches)
    }

    fn check_shape(&self, tally: &Tally) -> Result<(), TransportError> {
        let (thicknesses, orders) = (self.request().tau.len(), self.request().bins());
        match tally.has_shape(thicknesses, orders) {
            true => Ok(()),
            false => Err(TransportError::Shape { thicknesses, orders }),
        }
    }

    /// Adds the photons of another part of the same trace; changes nothing if that fails.
    ///
    /// # Errors
    /// [`TransportError::Foreign`] naming the first difference, [`CountedTwice`](TransportError::CountedTwice) with
    /// the photons that both have, [`OneAfterTheOther`](TransportError::OneAfterTheOther) where a target error is set.
    pub fn merge(&mut self, other: &Self) -> Result<(), TransportError> {
        other.check_same(self)?;
        self.counted.merge(&other.counted)
    }

    /// Photons of `share` that are not counted yet, as ranges.
    ///
    /// # Errors
    /// As [`share`](Self::share).
    pub fn missing(&self, share: Share) -> Result<Vec<Range<u64>>, TransportError> {
        Ok(self.counted.missing(&self.share(share)?))
    }

    /// Whether nothing of `share` is left to trace; with a target error, whether it is reached or all photons are used.
    ///
    /// # Errors
    /// As [`share`](Self::share), and [`TransportError::Books`] if counts do not add up.
    pub fn is_complete(&self, share: Share) -> Result<bool, TransportError> {
        let within = self.share(share)?;
        Ok(self.counted.next_round(&within)?.is_none())
    }

    /// The result.
    ///
    /// # Errors
    /// [`TransportError::Missing`] if photons are, [`Books`](TransportError::Books) if they do not add up.
    pub fn finish(&self) -> Result<Traced, TransportError> {
        self.counted.finish()
    }

    /// Whether this is a part of the same trace as `wanted`.
    ///
    /// # Errors
    /// [`TransportError::Foreign`] naming the first difference.
    pub fn check_same(&self, wanted: &Self) -> Result<(), TransportError> {
        let (here, there) = (self.features(), wanted.features());
        match here.into_iter().zip(there).find(|(here, there)| here != there) {
            None => Ok(()),
            Some(((what, found), (_, wanted))) => Err(TransportError::Foreign { what, found, wanted }),
        }
    }

    /// Everything that must be equal, in words.
    fn features(&self) -> [(&'static str, String); 10] {
        let (identity, request) = (&self.identity, self.request());
        [
            ("tracer", identity.tracer.clone()),
            ("seed", request.seed.to_string()),
            ("mu0", request.incidence.to_string()),
            ("tau", format!("{:?}", request.tau)),
            ("photons", request.stop.to_string()),
            ("orders", request.max_order.to_string()),
            ("medium", identity.medium.clone()),
            ("stream", request.stream.to_string()),
            ("algorithm of the tracer", identity.algorithm.clone()),
            ("shape of the tally", format!("{:?}", self.empty_tally().nested)),
        ]
    }
}
