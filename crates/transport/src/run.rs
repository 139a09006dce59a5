//! Tracing cells in parallel, and a whole request in one go.
//!
//! A cell is owned by one task, tallies are integers, and each photon has its own random stream: the result does not
//! depend on the number of threads, nor on the order in which cells end.

use crate::cells::Cell;
use crate::counted::{Counted, ascending};
use crate::tally::Tally;
use crate::{Control, TraceMedium, TraceRequest, Traced, TransportError};
use rayon::prelude::*;
use std::ops::Range;
use std::sync::{Mutex, PoisonError};

/// Groups of cells per thread, at least: enough for the threads to end together.
const GROUPS: usize = 4;

/// A way to trace photons.
pub(crate) trait Estimator: Sync {
    /// Whether a photon's end counts for all thicker slabs too.
    const NESTED: bool;
    /// Most photons to trace between two looks at what else there is to do. Changes no number.
    const LONGEST: u64 = u64::MAX;
    /// Most cells to trace in one go. Changes no number.
    const TOGETHER: usize = 1;

    /// Traces the photons of these indices; stops anywhere once cancelled.
    fn trace(&self, photons: Range<u64>, tally: &mut Tally, control: Control<'_>);

    /// The same for several ranges, each with its tally.
    fn trace_all(&self, photons: &[Range<u64>], tallies: &mut [Tally], control: Control<'_>) {
        for (photons, tally) in photons.iter().zip(tallies) {
            self.trace(photons.clone(), tally, control);
        }
    }
}

/// Runs the estimator that `build` makes for the ascending thicknesses.
pub(crate) fn run<'a, E: Estimator>(
    medium: &'a TraceMedium,
    request: &TraceRequest,
    control: Control<'_>,
    build: impl FnOnce(&'a TraceMedium, &TraceRequest, &[f64]) -> E,
) -> Result<Traced, TransportError> {
    request.check()?;
    let estimator = build(medium, request, &ascending(&request.tau).0);
    let mut counted = Counted::nothing(request, E::NESTED);
    let max = request.stop.max_photons();
    loop {
        let cells = counted.next(&(0..max), E::LONGEST)?;
        if cells.is_empty() {
            return counted.finish();
        }
        let empty = counted.empty_tally();
        trace_cells(&estimator, cells, &empty, control, |cell, tally| {
            counted.add(cell, tally)?;
            control.advanced(counted.photons().len(), max);
            Ok(())
        })?;
    }
}

/// Traces `cells`, each into a tally of its own; `take` has them one by one as they end, and none that was cut short.
pub(crate) fn trace_cells<E: Estimator>(
    estimator: &E,
    cells: Vec<Cell>,
    empty: &Tally,
    control: Control<'_>,
    take: impl FnMut(&Cell, &Tally) -> Result<(), TransportError> + Send,
) -> Result<(), TransportError> {
    let take = Mutex::new(take);
    let together = (cells.len() / (GROUPS * rayon::current_num_threads())).clamp(1, E::TOGETHER);
    cells.par_chunks(together).try_for_each(|cells| {
        let photons: Vec<Range<u64>> = cells.iter().map(Cell::photons).collect();
        let mut tallies = vec![empty.clone(); cells.len()];
        estimator.trace_all(&photons, &mut tallies, control);
        if control.is_cancelled() {
            return Err(TransportError::Cancelled);
        }
        let mut take = take.lock().unwrap_or_else(PoisonError::into_inner);
        cells.iter().zip(&tallies).try_for_each(|(cell, tally)| take(cell, tally))
    })
}
