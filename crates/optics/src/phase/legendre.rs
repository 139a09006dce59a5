//! Legendre moments χ_l = ½∫P·P_l sinΘ dΘ of the peak of any function, and sums Σ(2l+1)χ_l P_l.
//!
//! Each panel of a peak gets enough Gauss–Legendre points for the oscillation of the highest P_l, whose phase is lΘ; the
//! quadrature error is then below 1e-12. The recurrence (l+1)P_{l+1} = (2l+1)μP_l - lP_{l-1} runs over lanes of
//! points. Blocks of points are summed in their order: the bits do not depend on the number of threads.

use super::gauss::gauss_legendre;
use rayon::prelude::*;

/// Points that are summed one after the other.
const LANES: usize = 32;

/// Such runs of points that share one pass of the recurrence, side by side.
const RUNS: usize = 8;

/// What Θ < `end` contributes to the moments of a smooth P(v): panels halve towards the forward direction, 2⁻²⁴ of
/// `end` being the last.
pub(super) fn below_smooth(p: impl Fn(f64) -> f64, end: f64, count: usize) -> Vec<f64> {
    const HALVINGS: i32 = 24;
    let mut rules = Rules::new(count);
    let mut start = 0.0;
    for halving in (0..=HALVINGS).rev() {
        let width = libm::scalbn(end, -halving) - start;
        rules.add(start, width, 20.0, |t| {
            let sine = libm::sin(0.5 * (start + t));
            p(2.0 * sine * sine)
        });
        start += width;
    }
    rules.moments()
}

/// Quadrature points of moments, cell by cell.
struct Rules {
    count: usize,
    rules: [Vec<(f64, f64)>; 5],
    /// (cosΘ, ½ w P sinΘ).
    points: Vec<(f64, f64)>,
}

impl Rules {
    fn new(count: usize) -> Self {
        Self { count, rules: [6, 8, 12, 20, 48].map(gauss_legendre), points: Vec::new() }
    }

    /// A cell from `start` on, of `width` radians, where P is `p` of the distance from `start` and needs
    /// `least` points by itself.
    fn add(&mut self, start: f64, width: f64, least: f64, p: impl Fn(f64) -> f64) {
        let count = self.count as f64;
        // 48 points serve a phase of 50; wider cells are split.
        let pieces = (width * count / 50.0).ceil().max(1.0);
        let half = 0.5 * width / pieces;
        let needed = 5.0 + 0.5 * (2.0 * half * count) + 3.0 * half;
        let finest = &self.rules[self.rules.len() - 1];
        let rule = self.rules.iter().find(|rule| rule.len() as f64 >= needed.max(least)).unwrap_or(finest);
        for piece in 0..pieces as usize {
            let centre = half * (2 * piece + 1) as f64;
            self.points.extend(rule.iter().map(|(node, weight)| {
                let t = centre + half * node;
                let theta = start + t;
                (libm::cos(theta), 0.5 * weight * half * p(t) * libm::sin(theta))
            }));
        }
    }

    fn moments(&self) -> Vec<f64> {
        let blocks: Vec<Vec<f64>> =
            self.points.par_chunks(64 * LANES).map(|block| block_moments(block, self.count)).collect();
        blocks.iter().fold(vec![0.0; self.count], |mut sum, block| {
            sum.iter_mut().zip(block).for_each(|(total, part)| *total += part);
            sum
        })
    }
}

fn block_moments(points: &[(f64, f64)], count: usize) -> Vec<f64> {
    let mut sums = vec![0.0; count];
    for group in points.chunks(RUNS * LANES) {
        let (mut mu, mut weight) = ([[0.0; RUNS]; LANES], [[0.0; RUNS]; LANES]);
        for (i, point) in group.iter().enumerate() {
            let (run, lane) = (i / LANES, i % LANES);
            (mu[lane][run], weight[lane][run]) = *point;
        }
        accumulate(&mut sums, &mu, &weight);
    }
    sums
}

/// Adds Σ w P_l(μ) over the runs, one after the other, to `sums[l]`. The recurrence runs on wP_l itself, which is linear in w.
#[multiversion::multiversion(targets("x86_64+avx512f+avx512dq+avx512vl", "x86_64+avx2"))]
fn accumulate(sums: &mut [f64], mu: &[[f64; RUNS]; LANES], weight: &[[f64; RUNS]; LANES]) {
    let (mut before, mut legendre) = ([[0.0; RUNS]; LANES], *weight);
    for (l, sum) in sums.iter_mut().enumerate() {
        let l = l as f64;
        let (up, down) = ((2.0 * l + 1.0) / (l + 1.0), l / (l + 1.0));
        let mut totals = [0.0; RUNS];
        for ((mu, before), legendre) in mu.iter().zip(&mut before).zip(&mut legendre) {
            for run in 0..RUNS {
                totals[run] += legendre[run];
                let next = up * mu[run] * legendre[run] - down * before[run];
                before[run] = legendre[run];
                legendre[run] = next;
            }
        }
        *sum = totals.iter().fold(*sum, |sum, total| sum + total);
    }
}

/// Σ (2l+1)χ_l P_l(cosΘ) at each angle, radians.
pub(super) fn sum(moments: &[f64], theta: &[f64]) -> Vec<f64> {
    let blocks: Vec<Vec<f64>> = theta.par_chunks(LANES).map(|block| block_sum(moments, block)).collect();
    blocks.concat()
}

#[multiversion::multiversion(targets("x86_64+avx512f+avx512dq+avx512vl", "x86_64+avx2"))]
fn block_sum(moments: &[f64], theta: &[f64]) -> Vec<f64> {
    let mut mu = [0.0; LANES];
    theta.iter().enumerate().for_each(|(i, t)| mu[i] = libm::cos(*t));
    let (mut before, mut legendre, mut total) = ([0.0; LANES], [1.0; LANES], [0.0; LANES]);
    for (l, chi) in moments.iter().enumerate() {
        let l = l as f64;
        let weight = (2.0 * l + 1.0) * chi;
        let (up, down) = ((2.0 * l + 1.0) / (l + 1.0), l / (l + 1.0));
        for i in 0..LANES {
            total[i] += weight * legendre[i];
            let next = up * mu[i] * legendre[i] - down * before[i];
            before[i] = legendre[i];
            legendre[i] = next;
        }
    }
    total[..theta.len()].to_vec()
}
