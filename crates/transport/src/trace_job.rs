//! A trace done in parts: some of its photons now, others later or elsewhere.
//!
//! A [`TraceJob`] says what is traced; it fills a [`Part`], whose counts are those of exactly the photons that it
//! names. Parts go to other processes and come back, are merged, and finish as the result that one uninterrupted
//! process gives, bit for bit.

use crate::counted::ascending;
use crate::half_space::HalfSpace;
use crate::plain::Plain;
use crate::run::{Estimator, trace_cells};
use crate::{
    Cell, Control, Identity, Kernel, Part, Share, Tally, TraceMedium, TraceRequest, TransportError,
    fingerprint,
};
use std::fmt;
use std::ops::Range;

/// Which tracer of this crate.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Tracer {
    /// Depth and μ only, one history for all thicknesses.
    HalfSpace,
    /// Three-dimensional, one slab at a time: the reference.
    Plain,
}

impl fmt::Display for Tracer {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Tracer::HalfSpace => "half-space",
            Tracer::Plain => "plain",
        })
    }
}

/// A tracer set up for one request.
pub(crate) enum Engine<'a> {
    HalfSpace(HalfSpace<'a>),
    Plain(Plain<'a>),
}

impl<'a> Engine<'a> {
    /// `tracer` for a request that has been checked.
    pub fn new(tracer: Tracer, medium: &'a TraceMedium, request: &TraceRequest) -> Self {
        let tau = ascending(&request.tau).0;
        match tracer {
            Tracer::HalfSpace => Self::HalfSpace(HalfSpace::new(Kernel::default(), medium, request, &tau)),
            Tracer::Plain => Self::Plain(Plain::new(medium, request, &tau)),
        }
    }

    /// What `photons` count, in this thread.
    pub fn count(&self, photons: Range<u64>, mut tally: Tally) -> Tally {
        match self {
            Self::HalfSpace(tracer) => tracer.trace(photons, &mut tally, Control::default()),
            Self::Plain(tracer) => tracer.trace(photons, &mut tally, Control::default()),
        }
        tally
    }

    /// Whether an end counts for all thicker slabs too.
    pub fn nested(&self) -> bool {
        match self {
            Self::HalfSpace(_) => HalfSpace::NESTED,
            Self::Plain(_) => Plain::NESTED,
        }
    }

    fn longest(&self) -> u64 {
        match self {
            Self::HalfSpace(_) => HalfSpace::LONGEST,
            Self::Plain(_) => Plain::LONGEST,
        }
    }

    fn trace(
        &self,
        cells: Vec<Cell>,
        empty: &Tally,
        control: Control<'_>,
        take: impl FnMut(&Cell, &Tally) -> Result<(), TransportError> + Send,
    ) -> Result<(), TransportError> {
        match self {
            Self::HalfSpace(tracer) => trace_cells(tracer, cells, empty, control, take),
            Self::Plain(tracer) => trace_cells(tracer, cells, empty, control, take),
        }
    }
}

/// A request with its medium and tracer.
pub struct TraceJob<'a> {
    engine: Engine<'a>,
    identity: Identity,
    request: TraceRequest,
}

impl<'a> TraceJob<'a> {
    /// Checks the request and takes the fingerprints of medium and tracer (some milliseconds).
    ///
    /// # Errors
    /// [`TransportError`] naming the number that is out of domain.
    pub fn new(
        tracer: Tracer,
        medium: &'a TraceMedium,
        request: &TraceRequest,
    ) -> Result<Self, TransportError> {
        request.check()?;
        let identity = Identity::new(&tracer.to_string(), &fingerprint::of_tracer(tracer)?, medium);
        Ok(Self { engine: Engine::new(tracer, medium, request), identity, request: request.clone() })
    }

    /// A part with no photon in it yet.
    pub fn part(&self) -> Part {
        Part::nothing(self.identity.clone(), &self.request, self.engine.nested())
    }

    /// Traces those photons of `share` that `part` lacks. `keep` sees the part whenever more photons are in it, from
    /// one thread at a time, often: it must be fast but for the moments when it stores something.
    ///
    /// # Errors
    /// [`TransportError::Cancelled`], when the part has all photons that were done by then;
    /// [`Foreign`](TransportError::Foreign) if it belongs to another trace; [`OneAfterTheOther`](TransportError::OneAfterTheOther)
    /// for a share of a trace that has a target error.
    pub fn trace(
        &self,
        part: &mut Part,
        share: Share,
        control: Control<'_>,
        mut keep: impl FnMut(&Part) + Send,
    ) -> Result<(), TransportError> {
        part.check_same(&self.part())?;
        let photons = part.share(share)?;
        let total = photons.end - photons.start;
        loop {
            let cells = part.next(share, self.engine.longest())?;
            if cells.is_empty() {
                return Ok(());
            }
            let empty = part.empty_tally();
            self.engine.trace(cells, &empty, control, |cell, tally| {
                part.add(cell, tally)?;
                control.advanced(part.photons().min(total), total);
                keep(part);
                Ok(())
            })?;
        }
    }
}
