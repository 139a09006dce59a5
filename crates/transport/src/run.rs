//! Rounds and batches: who traces which photons, and when to stop.
//!
//! Photons are numbered 0, 1, 2 …; a round takes the next of them and gives each batch an equal share. A batch is
//! owned by one task, tallies are integers, and each photon has its own random stream: the result does not
//! depend on the number of threads. Where a target error is set, the errors after a round decide how long the
//! next one is, by the law that they fall as one over the root of the photons.

use crate::tally::Tally;
use crate::{Control, TraceMedium, TraceRequest, Traced, TransportError};
use rayon::prelude::*;
use std::ops::Range;
use std::sync::atomic::{AtomicU64, Ordering};

/// Groups of photons whose scatter among each other gives covariances.
pub(crate) const BATCHES: usize = 256;
/// Photons of the longest round.
const LONGEST: u64 = 1 << 20;
/// Photons of the first round where a target error is set.
const FIRST: u64 = 1 << 16;
/// Photons of the shortest round after it.
const SHORTEST: u64 = 1 << 14;

/// A way to trace photons.
pub(crate) trait Estimator: Sync {
    /// Whether a photon's end counts for all thicker slabs too.
    const NESTED: bool;

    /// Traces the photons of these indices; stops anywhere once cancelled.
    fn trace(&self, photons: Range<u64>, tally: &mut Tally, control: Control<'_>);
}

/// Runs the estimator that `build` makes for the ascending thicknesses.
pub(crate) fn run<'a, E: Estimator>(
    medium: &'a TraceMedium,
    request: &TraceRequest,
    control: Control<'_>,
    build: impl FnOnce(&'a TraceMedium, &TraceRequest, &[f64]) -> E,
) -> Result<Traced, TransportError> {
    request.check()?;
    let (tau, rank) = ascending(&request.tau);
    let estimator = build(medium, request, &tau);
    let mut batches = vec![Tally::new(tau.len(), request.bins(), E::NESTED); BATCHES];
    let max = request.stop.max_photons();
    let mut done = 0;
    let mut length = if request.stop.target().is_some() { FIRST } else { LONGEST };
    while done < max {
        let end = max.min(done + length);
        round(&estimator, done..end, max, &mut batches, control)?;
        done = end;
        if let Some(target) = request.stop.target() {
            let traced = Traced::new(request, &rank, &batches)?.held_against(target);
            if done == max || traced.target_reached() == Some(true) {
                return Ok(traced);
            }
            length = photons_to_go(done, traced.worst_error() / target);
        }
    }
    Traced::new(request, &rank, &batches)
}

/// Length of the next round when `done` photons left the error `excess` times too large; 2 % are added so that one
/// more round is usually enough.
fn photons_to_go(done: u64, excess: f64) -> u64 {
    let photons = done as f64 * (1.02 * excess * excess - 1.0);
    photons.clamp(SHORTEST as f64, LONGEST as f64) as u64
}

/// Traces `photons`, each batch its share.
fn round<E: Estimator>(
    estimator: &E,
    photons: Range<u64>,
    max: u64,
    batches: &mut [Tally],
    control: Control<'_>,
) -> Result<(), TransportError> {
    let count = photons.end - photons.start;
    let bound = |batch: usize| photons.start + count * batch as u64 / BATCHES as u64;
    let done = AtomicU64::new(photons.start);
    batches.par_iter_mut().enumerate().try_for_each(|(batch, tally)| {
        let share = bound(batch)..bound(batch + 1);
        let size = share.end - share.start;
        estimator.trace(share, tally, control);
        if control.is_cancelled() {
            return Err(TransportError::Cancelled);
        }
        control.advanced(done.fetch_add(size, Ordering::Relaxed) + size, max);
        Ok(())
    })
}

/// Thicknesses in ascending order, and for each given one its place there.
fn ascending(tau: &[f64]) -> (Vec<f64>, Vec<usize>) {
    let mut places: Vec<usize> = (0..tau.len()).collect();
    places.sort_by(|&a, &b| tau[a].total_cmp(&tau[b]));
    let mut rank = vec![0; tau.len()];
    places.iter().enumerate().for_each(|(place, &given)| rank[given] = place);
    (places.iter().map(|&given| tau[given]).collect(), rank)
}
