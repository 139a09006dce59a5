//! One place on the ladder of stream numbers: its last rungs, and the nearest answer.

use super::second::excess;
use stratiform_stats::Estimate;

/// Streams per hemisphere.
pub(super) const LADDER: [usize; 8] = [8, 16, 24, 32, 48, 64, 96, 128];

/// Times the rest of a 1/n series.
const MARGIN: f64 = 1.5;

/// Rounding and limits (k = 0, μ = 0) relative to radiances of order one.
const ROUNDING: f64 = 1e-8;

/// A place's way up.
#[derive(Clone, Debug)]
pub(super) struct Climb {
    /// Values of the last two rungs.
    below: [f64; 2],
    /// The rung with the smallest error so far.
    pub(super) nearest: Estimate,
    /// Its streams; 0 before three rungs are known.
    pub(super) streams: usize,
}

impl Climb {
    pub(super) fn new() -> Self {
        let nearest = Estimate { value: f64::NAN, std_error: f64::INFINITY };
        Self { below: [f64::NAN; 2], nearest, streams: 0 }
    }

    /// Takes the next rung in; `rest` is what it leaves out by intent.
    pub(super) fn step(&mut self, rung: usize, found: &Estimate, rest: f64) {
        let [first, second] = self.below;
        self.below = [second, found.value];
        if rung < 2 {
            return;
        }
        let settled = settled(rung, [first, second], found, rest);
        if self.streams == 0 || excess(&settled) < excess(&self.nearest) {
            (self.nearest, self.streams) = (settled, LADDER[rung]);
        }
    }
}

/// The last of three rungs with its error: as much of the last step (at the horizon and in the aureole results
/// converge no faster than 1/n) with a margin as such a series leaves, or half of the step before lest two rungs agree by
/// chance; the error of order 2; what the azimuth series leaves out; rounding.
fn settled(rung: usize, [first, second]: [f64; 2], third: &Estimate, rest: f64) -> Estimate {
    let (before, count) = (LADDER[rung - 1], LADDER[rung]);
    let left = before as f64 / (count - before) as f64;
    let last = MARGIN * left * (third.value - second).abs();
    let step = last.max(0.5 * (second - first).abs());
    let error = step + third.std_error + rest + ROUNDING * third.value.abs().max(1.0);
    Estimate { value: third.value, std_error: if error.is_finite() { error } else { f64::INFINITY } }
}
