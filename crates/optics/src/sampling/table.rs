//! Inversion of a phase function's cumulative by table: 32 random bits to v = 1 - cosΘ.
//!
//! The random word u stands for ξ = (u + ½)/2³². Its top 12 bits choose one of 4096 intervals of equal
//! probability; inside, v(ξ) is a parabola in the low 20 bits through the exact v at both ends and the middle.
//! v is stored, not cosΘ, which would lose the forward peak. An interval whose parabola
//! is not monotone, or misses the bound |C(v) - ξ| ≤ 2⁻²³ ([`SamplingTable::BOUND`]) at any of its test points,
//! is marked, and samples in it are inverted by the phase function itself. Such are the intervals next to a
//! jump or a gap of P. No sample lies below the smallest v of positive probability.

use crate::phase::PhaseFunction;
use std::sync::Arc;

const INTERVAL_BITS: u32 = 12;
const INTERVALS: usize = 1 << INTERVAL_BITS;
const OFFSET_BITS: u32 = 32 - INTERVAL_BITS;
const OFFSET_MASK: u32 = (1 << OFFSET_BITS) - 1;
/// The unit of ξ for one random word.
const WORD: f64 = 1.0 / 4_294_967_296.0;
/// Fractions of an interval where its parabola is held against the cumulative.
const TEST_POINTS: [f64; 6] = [0.06, 0.2, 0.35, 0.65, 0.8, 0.94];

/// v = start + t(slope + t·curve) for t ∈ (0, 1); slope is NaN where the interval is inverted exactly.
#[derive(Clone, Copy, Debug)]
struct Interval {
    start: f64,
    slope: f32,
    curve: f32,
}

impl Interval {
    const EXACT: Self = Self { start: 0.0, slope: f32::NAN, curve: 0.0 };

    #[inline(always)]
    fn at(&self, t: f64) -> f64 {
        self.start + t * (f64::from(self.slope) + t * f64::from(self.curve))
    }

    fn is_monotone(&self) -> bool {
        self.slope >= 0.0 && self.slope + 2.0 * self.curve >= 0.0
    }

    /// The parabola of interval `index`, or [`Self::EXACT`] where it is not good enough.
    fn fit(phase: &dyn PhaseFunction, index: usize, ends: [f64; 2]) -> Self {
        let xi = |t: f64| (index as f64 + t) / INTERVALS as f64;
        let [start, end] = ends;
        let middle = phase.invert(xi(0.5));
        let curve = 2.0 * (start + end) - 4.0 * middle;
        let fitted = Self { start, slope: (end - start - curve) as f32, curve: curve as f32 };
        let good = |t: &f64| (phase.cumulative(fitted.at(*t)) - xi(*t)).abs() <= SamplingTable::BOUND / 2.0;
        if fitted.is_monotone() && fitted.at(1.0) <= 2.0 && TEST_POINTS.iter().all(good) {
            fitted
        } else {
            Self::EXACT
        }
    }
}

/// A phase function with its table.
#[derive(Clone)]
pub struct SamplingTable {
    phase: Arc<dyn PhaseFunction>,
    intervals: Box<[Interval; INTERVALS]>,
}

impl SamplingTable {
    /// Largest |C(v) - ξ| of a sample, C being the phase function's own cumulative.
    pub const BOUND: f64 = 1.0 / 8_388_608.0;

    /// Tabulates `phase`: 8193 inversions and six cumulatives per interval.
    pub fn new(phase: Arc<dyn PhaseFunction>) -> Self {
        let knots: Vec<f64> = (0..=INTERVALS).map(|k| knot(phase.as_ref(), k)).collect();
        let fit = |k| Interval::fit(phase.as_ref(), k, [knots[k], knots[k + 1]]);
        let intervals = Box::new(std::array::from_fn(fit));
        Self { phase, intervals }
    }

    /// v = 1 - cosΘ of the random word `bits`: non-decreasing in `bits`, within \[0, 2\].
    #[inline(always)]
    pub fn sample(&self, bits: u32) -> f64 {
        let v = self.intervals[(bits >> OFFSET_BITS) as usize].at(offset(bits));
        if v.is_nan() { self.exact(bits) } else { v }
    }

    /// The same for many words at once, as loops that vector units can run.
    #[inline(always)]
    pub fn sample_all<const N: usize>(&self, words: &[u32; N]) -> [f64; N] {
        let (mut starts, mut slopes, mut curves) = ([0.0; N], [0.0; N], [0.0; N]);
        for k in 0..N {
            let Interval { start, slope, curve } = self.intervals[(words[k] >> OFFSET_BITS) as usize];
            (starts[k], slopes[k], curves[k]) = (start, slope, curve);
        }
        let mut v = [0.0; N];
        let mut inexact = false;
        for k in 0..N {
            v[k] = Interval { start: starts[k], slope: slopes[k], curve: curves[k] }.at(offset(words[k]));
            inexact |= v[k].is_nan();
        }
        if inexact {
            (0..N).filter(|&k| slopes[k].is_nan()).for_each(|k| v[k] = self.exact(words[k]));
        }
        v
    }

    #[cold]
    #[inline(never)]
    fn exact(&self, bits: u32) -> f64 {
        self.phase.invert((f64::from(bits) + 0.5) * WORD)
    }

    /// The tabulated function.
    pub fn phase(&self) -> &Arc<dyn PhaseFunction> {
        &self.phase
    }

    /// Share of samples that take the phase function's own inversion.
    pub fn exact_share(&self) -> f64 {
        let exact = self.intervals.iter().filter(|interval| interval.slope.is_nan()).count();
        exact as f64 / INTERVALS as f64
    }
}

/// Where in its interval a word lies, in (0, 1).
#[inline(always)]
fn offset(bits: u32) -> f64 {
    (f64::from((bits & OFFSET_MASK) as i32) + 0.5) * (1.0 / f64::from(1_u32 << OFFSET_BITS))
}

/// v at the lower end of interval `index`.
fn knot(phase: &dyn PhaseFunction, index: usize) -> f64 {
    let xi = (index as f64 / INTERVALS as f64).min(1.0 - 0.5 * f64::EPSILON);
    phase.invert(xi).min(2.0)
}
