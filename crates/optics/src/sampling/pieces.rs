//! Inversion of a phase function's cumulative by straight pieces in single precision: 32 random bits to v = 1 - cosΘ.
//!
//! The top 12 bits of the random word choose one of 4096 intervals of equal probability; the other 20, as a fraction
//! t = (bits + ½)/2²⁰, the place in it: v = start + t·slope, stored as v = first + bits·step. Each piece keeps the interval's mean of v and
//! stays between the exact v at its ends; it starts (ends) at the exact v where v(ξ) is convex (concave). So
//! samples are monotone in the word and g is kept, and what is lost is the shape inside 1/4096 of the probability.
//!
//! Where a piece would miss its share by more than 1/128 of an interval (next to jumps and gaps of P), the
//! interval is split into 256 pieces of a second level, chosen by the next 8 bits; t is then of the last 12.
//!
//! Layout of [`LinearPieces::words`], that of a buffer of pairs of f32: word k < 4096 is the piece of interval k,
//! `first` in the low half, `step` in the high one. A negative step marks a split interval: `first` is then the index (a
//! whole number) of its first piece of the second level, in the same buffer.

use crate::phase::{PhaseFunction, gauss_legendre};

const INTERVAL_BITS: u32 = 12;
const SPLIT_BITS: u32 = 8;
/// Pieces of the first level.
const INTERVALS: usize = 1 << INTERVAL_BITS;
/// Pieces of the second level in one interval.
const SPLITS: usize = 1 << SPLIT_BITS;
/// Largest |C(v) - ξ| of a piece that is not split, as a share of its interval.
const TOLERANCE: f64 = 1.0 / 128.0;
/// Samples that are looked through together for split intervals.
const GROUP: usize = 16;
/// Points at which an interval's mean is taken and its piece is held against the cumulative.
const POINTS: usize = 4;

/// v = first + bits·step.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Piece {
    first: f32,
    step: f32,
}

impl Piece {
    /// The piece v = start + t·slope whose t has `bits` bits.
    fn new(start: f64, slope: f64, bits: u32) -> Self {
        let step = slope / (1_u64 << bits) as f64;
        Self { first: (start + 0.5 * step) as f32, step: step as f32 }
    }

    fn packed(self) -> u64 {
        u64::from(self.first.to_bits()) | (u64::from(self.step.to_bits()) << 32)
    }

    #[inline(always)]
    fn unpacked(word: u64) -> Self {
        Self { first: f32::from_bits(word as u32), step: f32::from_bits((word >> 32) as u32) }
    }

    /// At the place that the bits of `word` past its top `USED` ones give.
    #[inline(always)]
    fn at<const USED: u32>(self, word: u32) -> f32 {
        self.first + rest::<USED>(word) * self.step
    }
}

/// A phase function as straight pieces of its inverse cumulative.
#[derive(Clone, Debug)]
pub struct LinearPieces {
    first: Box<[u64; INTERVALS]>,
    second: Vec<u64>,
}

impl LinearPieces {
    /// Tabulates `phase`: five inversions and four cumulatives per interval, 1280 inversions more per split one.
    pub fn new(phase: &dyn PhaseFunction) -> Self {
        let rule = Rule::new();
        let width = 1.0 / INTERVALS as f64;
        let mut second = Vec::new();
        let first = Box::new(std::array::from_fn(|k| {
            let from = k as f64 * width;
            let line = rule.line(phase, from, width);
            if rule.error(phase, from, width, line) <= TOLERANCE * width {
                return Piece::new(line.0, line.1, 32 - INTERVAL_BITS).packed();
            }
            let index = INTERVALS + second.len();
            let part = width / SPLITS as f64;
            second.extend((0..SPLITS).map(|j| {
                let (start, slope) = rule.line(phase, from + j as f64 * part, part);
                Piece::new(start, slope, 32 - INTERVAL_BITS - SPLIT_BITS).packed()
            }));
            Piece { first: index as f32, step: -1.0 }.packed()
        }));
        Self { first, second }
    }

    /// v = 1 - cosΘ of the random word `bits`: non-decreasing in `bits` but for rounding, within \[0, 2\] and one unit in the last place.
    #[inline(always)]
    pub fn sample(&self, bits: u32) -> f32 {
        let piece = Piece::unpacked(self.first[(bits >> (32 - INTERVAL_BITS)) as usize]);
        if piece.step < 0.0 { self.split(piece, bits) } else { piece.at::<INTERVAL_BITS>(bits) }
    }

    /// The same for many words at once, as loops that vector units can run.
    #[inline(always)]
    pub fn sample_all<const N: usize>(&self, words: &[u32; N]) -> [f32; N] {
        let mut pieces = [0; N];
        look_up(&self.first, words, &mut pieces);
        let pieces: &[[u32; 2]; N] = bytemuck::cast_ref(&pieces);
        let (mut v, mut steps) = ([0.0; N], [0; N]);
        let mut signs = 0;
        for k in 0..N {
            let [first, step] =
                if cfg!(target_endian = "little") { pieces[k] } else { [pieces[k][1], pieces[k][0]] };
            v[k] = f32::from_bits(first) + rest::<INTERVAL_BITS>(words[k]) * f32::from_bits(step);
            steps[k] = step;
            signs |= step;
        }
        if (signs as i32) < 0 {
            self.split_all(&steps, words, &mut v);
        }
        v
    }

    /// Replaces the samples that fall into split intervals.
    #[inline(always)]
    fn split_all(&self, steps: &[u32], words: &[u32], v: &mut [f32]) {
        // Most groups have none.
        let groups = steps.chunks(GROUP).zip(words.chunks(GROUP)).zip(v.chunks_mut(GROUP));
        for ((steps, words), v) in
            groups.filter(|((steps, _), _)| steps.iter().fold(0, |all, step| all | step) >> 31 == 1)
        {
            for ((step, &bits), v) in steps.iter().zip(words).zip(v) {
                if step >> 31 == 1 {
                    *v = self.sample(bits);
                }
            }
        }
    }

    #[inline]
    fn split(&self, piece: Piece, bits: u32) -> f32 {
        let part = (bits >> (32 - INTERVAL_BITS - SPLIT_BITS)) as usize % SPLITS;
        let word = self.second[piece.first as usize - INTERVALS + part];
        Piece::unpacked(word).at::<{ INTERVAL_BITS + SPLIT_BITS }>(bits)
    }

    /// Both levels as one buffer; see the module's first lines.
    pub fn words(&self) -> impl Iterator<Item = u64> {
        self.first.iter().chain(&self.second).copied()
    }

    /// Share of samples that need the second level.
    pub fn split_share(&self) -> f64 {
        (self.second.len() / SPLITS) as f64 / INTERVALS as f64
    }
}

/// The pieces of the first level. By itself, so that the compiler knows that no piece is in the table, and gathers.
#[inline(always)]
fn look_up<const N: usize>(first: &[u64; INTERVALS], words: &[u32; N], pieces: &mut [u64; N]) {
    for k in 0..N {
        pieces[k] = first[(words[k] >> (32 - INTERVAL_BITS)) as usize];
    }
}

/// A word past its top `USED` bits.
#[inline(always)]
fn rest<const USED: u32>(word: u32) -> f32 {
    (word & (u32::MAX >> USED)) as i32 as f32
}

/// Gauss's points and weights on \[0, 1\].
struct Rule(Vec<(f64, f64)>);

impl Rule {
    fn new() -> Self {
        Self(gauss_legendre(POINTS).iter().map(|(x, w)| (0.5 * (x + 1.0), 0.5 * w)).collect())
    }

    /// Start and slope of the piece of the interval from ξ = `from`.
    fn line(&self, phase: &dyn PhaseFunction, from: f64, width: f64) -> (f64, f64) {
        let v = |xi: f64| phase.invert(xi.min(1.0 - 0.5 * f64::EPSILON)).clamp(0.0, 2.0);
        let (start, end) = (v(from), v(from + width));
        let terms = self.0.iter().map(|(t, w)| w * v(from + t * width));
        let mean = terms.fold(0.0, |sum, term| sum + term).clamp(start, end.max(start));
        let convex = 2.0 * mean <= start + end;
        let start = if convex { start } else { 2.0 * mean - end };
        (start, 2.0 * (mean - start))
    }

    /// Largest |C(v) - ξ| of a piece at the points.
    fn error(&self, phase: &dyn PhaseFunction, from: f64, width: f64, (start, slope): (f64, f64)) -> f64 {
        let error = |(t, _): &(f64, f64)| {
            let v = (start + t * slope).min(2.0);
            (phase.cumulative(v) - from - t * width).abs()
        };
        self.0.iter().map(error).fold(0.0, f64::max)
    }
}
