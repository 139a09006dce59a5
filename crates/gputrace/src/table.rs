//! The phase function's inversion table as the device reads it.

use stratiform_optics::phase::PhaseFunction;
use stratiform_optics::sampling::LinearPieces;

/// Pieces of both levels: start in the low half, slope in the high one.
pub(crate) fn pieces(phase: &dyn PhaseFunction) -> Vec<u64> {
    LinearPieces::new(phase).words().collect()
}
