//! Who traces which photons: shares of a round in parallel, folded in index order.

use super::RadianceRequest;
use crate::{Control, TransportError};
use rayon::prelude::*;
use std::ops::Range;

/// Photons of one share, and shares of one round. Neither depends on the number of threads.
const SHARE: u64 = 1024;
const ROUND: u64 = 64;

/// Traces all photons: `trace` one share of them, `fold` the shares in the order of their photons.
pub(super) fn run<T: Send>(
    request: &RadianceRequest,
    control: Control<'_>,
    trace: impl Fn(Range<u64>) -> T + Sync,
    mut fold: impl FnMut(T),
) -> Result<(), TransportError> {
    let photons = request.photons;
    let shares = photons.div_ceil(SHARE);
    let mut first = 0;
    while first < shares {
        let next = shares.min(first + ROUND);
        let one = |share: u64| {
            if control.is_cancelled() {
                return Err(TransportError::Cancelled);
            }
            Ok(trace(share * SHARE..photons.min((share + 1) * SHARE)))
        };
        let round: Vec<T> = (first..next).into_par_iter().map(one).collect::<Result<_, _>>()?;
        round.into_iter().for_each(&mut fold);
        first = next;
        control.advanced(photons.min(first * SHARE), photons);
    }
    Ok(())
}
