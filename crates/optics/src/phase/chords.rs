//! A table's P at many v = 1 - cosΘ at once, without the arcsine of each.
//!
//! The variable is the half chord x = sin(Θ/2) = √(v/2) up to 90° and x = √2 - cos(Θ/2) beyond: it keeps the digits of both ends and
//! costs one root. P is linear in Θ between the table's nodes, so that in x each cell has the cubic Taylor polynomial of Θ(x) about
//! its middle; cells wider than 1/512 are cut. The fourth derivative of Θ is 192 at most, at 90°, so that Θ is off by less
//! than (1/1024)⁴·192/24 = 7.3e-12.

use super::cell::Cell;
use std::f64::consts::{FRAC_1_SQRT_2, FRAC_PI_2, SQRT_2};

/// Cells per unit of x, at least.
const DENSITY: f64 = 512.0;

/// Buckets per unit of x: a power of 2, so that nothing is rounded.
const BUCKETS: f64 = 4096.0;

/// More buckets than there are: a power of 2.
const ALL: usize = 8192;

/// Added to a number below 2⁵², leaves its nearest integer in the last bits.
const TO_INTEGER: f64 = 4_503_599_627_370_496.0;

/// P by cells in x.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Chords {
    pieces: Vec<Piece>,
    /// The piece at the lower edge of each bucket, half a bucket below its number.
    first: Vec<u32>,
}

/// P = Σ `series`ₙ (x - `middle`)ⁿ below `end`.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Piece {
    end: f64,
    middle: f64,
    series: [f64; 4],
}

impl Chords {
    /// For the cells of a table with their widths, none of them empty.
    pub(super) fn new(cells: impl Iterator<Item = (Cell, f64)>) -> Self {
        let mut pieces = Vec::new();
        for (cell, width) in cells {
            let end = cell.start + width;
            let seam = FRAC_PI_2.clamp(cell.start, end);
            for [low, high] in [[cell.start, seam], [seam, end]].map(|ends| ends.map(half_chord)) {
                let parts = (DENSITY * (high - low)).ceil();
                let edge = |part: usize| low + (high - low) * part as f64 / parts;
                pieces.extend((0..parts as usize).map(|i| Piece::new(&cell, edge(i), edge(i + 1))));
            }
        }
        // The last piece has no end.
        pieces.last_mut().iter_mut().for_each(|last| last.end = f64::INFINITY);
        let edge = |bucket: usize| (bucket as f64 - 0.5) / BUCKETS;
        let first = |bucket: usize| pieces.partition_point(|piece| piece.end <= edge(bucket)) as u32;
        let first = (0..ALL).map(first).collect();
        Self { pieces, first }
    }

    /// Replaces each v ∈ \[0, 2\] by P; what rounding puts outside is taken to the end.
    pub(super) fn values_at(&self, v: &mut [f64]) {
        half_chords(v);
        v.iter_mut().for_each(|x| *x = self.value(*x));
    }

    /// P at x. Few buckets hold the ends of two pieces or more.
    #[inline]
    fn value(&self, x: f64) -> f64 {
        // NaN lies in any.
        let bucket = (x * BUCKETS + TO_INTEGER).to_bits() as usize % ALL;
        let mut place = self.first[bucket] as usize;
        place += usize::from(self.pieces[place].end <= x);
        while self.pieces[place].end <= x {
            place += 1;
        }
        let Piece { middle, series, .. } = &self.pieces[place];
        let t = x - middle;
        series[0] + t * (series[1] + t * (series[2] + t * series[3]))
    }
}

impl Piece {
    /// Of a `cell` from `start` to `end`.
    fn new(cell: &Cell, start: f64, end: f64) -> Self {
        let middle = 0.5 * (start + end);
        let narrow = middle < FRAC_1_SQRT_2;
        let x = if narrow { middle } else { SQRT_2 - middle };
        let (square, sign) = (1.0 - x * x, if narrow { 1.0 } else { -1.0 });
        // Θ = 2 asin x, or π less that; and its derivatives by n!.
        let theta = FRAC_PI_2 + sign * (2.0 * libm::asin(x) - FRAC_PI_2);
        let first = cell.slope * 2.0 / square.sqrt();
        let second = first * sign * 0.5 * x / square;
        let third = first * (1.0 + 2.0 * x * x) / (6.0 * square * square);
        let value = cell.value + cell.slope * (theta - cell.start);
        Self { end, middle, series: [value, first, second, third] }
    }
}

/// x of Θ.
fn half_chord(theta: f64) -> f64 {
    let (sine, cosine) = libm::sincos(0.5 * theta);
    if theta <= FRAC_PI_2 { sine } else { SQRT_2 - cosine }
}

/// Replaces each v by x, in a processor's lanes; NaN stays NaN. The same bits on every processor: nothing is fused.
#[multiversion::multiversion(targets("x86_64+avx512f+avx512dq+avx512vl", "x86_64+avx2"))]
fn half_chords(v: &mut [f64]) {
    for v in v {
        let half = if *v < 0.0 { 0.0 } else { 0.5 * *v };
        let half = if half > 1.0 { 1.0 } else { half };
        let narrow = half <= 0.5;
        let root = (if narrow { half } else { 1.0 - half }).sqrt();
        *v = if narrow { root } else { SQRT_2 - root };
    }
}

#[cfg(test)]
mod tests {
    use crate::phase::{Norm, PhaseFunction, PhaseTable};

    /// Against the library's arcsine: a forward peak, a jump, cells of all widths; near 180° v itself does not know Θ better than 1e-8.
    #[test]
    fn values_are_those_of_the_angles() {
        let graded = (0..=300).map(|i| 120.0 * libm::pow(f64::from(i) / 300.0, 3.0));
        let theta: Vec<f64> = graded.chain([120.0, 150.0, 180.0]).collect();
        let p = theta.iter().enumerate().map(|(i, t)| 1e3 * libm::exp(-t) + (i % 7) as f64).collect();
        let table = PhaseTable::new(theta, p, Norm::Any).unwrap();
        let steepest = table.cells().fold(0.0, |most, (cell, _)| f64::max(most, cell.slope.abs()));
        let mut v: Vec<f64> = (0..=40_000).map(|i| f64::from(i) / 20_000.0).collect();
        v.extend((0..300).map(|i| libm::exp(-f64::from(i))));
        v.extend([1.0_f64.next_down(), 1.0_f64.next_up(), -1e-17, 2.0_f64.next_up()]);
        let mut found = v.clone();
        table.values_at(&mut found);
        for (v, found) in v.iter().zip(&found) {
            let expected = table.value(*v);
            let off = (found - expected).abs();
            assert!(off <= 8e-12 * steepest + 1e-13 * expected, "{v}: {found} {expected}");
        }
        let mut wrong = [f64::NAN];
        table.values_at(&mut wrong);
        assert!(wrong[0].is_nan());
    }
}
