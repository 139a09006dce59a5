//! Who traces which photons: shares of a round in parallel, folded in index order.

use super::RadianceRequest;
use crate::{Control, TransportError};
use rayon::prelude::*;
use std::ops::Range;

/// Shares of one round. It does not depend on the number of threads.
const ROUND: u64 = 64;

/// Traces all photons: `trace` one `share` of them, `fold` the shares in the order of their photons.
pub(super) fn run<T: Send>(
    request: &RadianceRequest,
    share: u64,
    control: Control<'_>,
    trace: impl Fn(Range<u64>) -> T + Sync,
    mut fold: impl FnMut(T),
) -> Result<(), TransportError> {
    let photons = request.photons;
    let shares = photons.div_ceil(share);
    let mut first = 0;
    while first < shares {
        let next = shares.min(first + ROUND);
        let one = |place: u64| {
            if control.is_cancelled() {
                return Err(TransportError::Cancelled);
            }
            Ok(trace(place * share..photons.min((place + 1) * share)))
        };
        let round: Vec<T> = (first..next).into_par_iter().map(one).collect::<Result<_, _>>()?;
        round.into_iter().for_each(&mut fold);
        first = next;
        control.advanced(photons.min(first * share), photons);
    }
    Ok(())
}
