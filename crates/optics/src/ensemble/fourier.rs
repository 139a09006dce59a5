//! Fourier sums of many spheres at once: z_m = Σ_k Z_k e^{2πikm/M}, M a power of two, one sphere per lane.
//!
//! Decimation in frequency (Gentleman & Sande 1966): sums and turned differences of both halves, then each half alone.
//! Places come out with their bits reversed, which [`place`] undoes. A half that fits the nearest cache is finished before
//! the next is touched. No fused multiply-add: every instruction set gives the same bits.

use crate::mie::{LANES, Lanes};
use std::f64::consts::PI;

/// Real and imaginary part of every lane.
pub(super) type Point = [Lanes; 2];

/// Points that fit the nearest cache: 32 KiB.
const NEAR: usize = 128;

/// The sums at M points.
pub(super) struct Fourier {
    /// e^{2πik/M}, k < M/2.
    turns: Vec<[f64; 2]>,
}

impl Fourier {
    /// `points` is a power of two, 2 or more.
    pub(super) fn new(points: usize) -> Self {
        let turn = |k: usize| {
            let (sine, cosine) = libm::sincos(2.0 * PI * k as f64 / points as f64);
            [cosine, sine]
        };
        Self { turns: (0..points / 2).map(turn).collect() }
    }

    /// Replaces Z by z.
    pub(super) fn sum(&self, z: &mut [Point]) {
        if z.len() <= NEAR {
            return all_halves(z, &self.turns);
        }
        halve(z, &self.turns);
        let (first, second) = z.split_at_mut(z.len() / 2);
        self.sum(first);
        self.sum(second);
    }
}

/// Where the sum at point `m` of `points` is found.
pub(super) fn place(m: usize, points: usize) -> usize {
    m.reverse_bits() >> (usize::BITS - points.trailing_zeros())
}

#[multiversion::multiversion(targets("x86_64+avx512f+avx512dq+avx512vl", "x86_64+avx2"))]
fn halve(z: &mut [Point], turns: &[[f64; 2]]) {
    butterflies(z, turns);
}

#[multiversion::multiversion(targets("x86_64+avx512f+avx512dq+avx512vl", "x86_64+avx2"))]
fn all_halves(z: &mut [Point], turns: &[[f64; 2]]) {
    let mut size = z.len();
    while size > 1 {
        z.chunks_exact_mut(size).for_each(|part| butterflies(part, turns));
        size /= 2;
    }
}

#[inline(always)]
fn butterflies(z: &mut [Point], turns: &[[f64; 2]]) {
    let (first, second) = z.split_at_mut(z.len() / 2);
    let every = turns.len() / first.len();
    for ((a, b), [cosine, sine]) in first.iter_mut().zip(second).zip(turns.iter().step_by(every)) {
        // Copies: that places of memory are apart is then known.
        let ([a_re, a_im], [b_re, b_im]) = (*a, *b);
        let [mut re, mut im] = [[0.0; LANES]; 2];
        for l in 0..LANES {
            (a[0].0[l], a[1].0[l]) = (a_re.0[l] + b_re.0[l], a_im.0[l] + b_im.0[l]);
            (re[l], im[l]) = (a_re.0[l] - b_re.0[l], a_im.0[l] - b_im.0[l]);
        }
        for l in 0..LANES {
            b[0].0[l] = re[l] * cosine - im[l] * sine;
            b[1].0[l] = re[l] * sine + im[l] * cosine;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Against the definition, with another sequence in every lane; 512 points pass through both ways.
    #[test]
    fn sums_are_those_of_the_definition() {
        for points in [2, 8, 512] {
            let value = |k: usize, l: usize, part: f64| libm::sin((k * k + 3 * l) as f64 + part);
            let point = |k: usize| [0.0, 1.0].map(|part| Lanes(std::array::from_fn(|l| value(k, l, part))));
            let mut z: Vec<Point> = (0..points).map(point).collect();
            Fourier::new(points).sum(&mut z);
            for m in 0..points {
                for l in [0, LANES - 1] {
                    let expected = (0..points).fold([0.0; 2], |sum, k| {
                        let (s, c) = libm::sincos(2.0 * PI * (k * m % points) as f64 / points as f64);
                        let (re, im) = (value(k, l, 0.0), value(k, l, 1.0));
                        [sum[0] + re * c - im * s, sum[1] + re * s + im * c]
                    });
                    let found = z[place(m, points)].each_ref().map(|part| part.0[l]);
                    let off = (found[0] - expected[0]).abs().max((found[1] - expected[1]).abs());
                    assert!(off < 1e-12, "{points} {m} {l}: {off:e}");
                }
            }
        }
    }
}
