//! Legendre moments χ_l = ½∫P·P_l sinΘ dΘ of a table, and sums Σ(2l+1)χ_l P_l.
//!
//! Each cell gets enough Gauss–Legendre points for the oscillation of the highest P_l, whose phase is lΘ; the
//! quadrature error is then below 1e-12. The recurrence (l+1)P_{l+1} = (2l+1)μP_l - lP_{l-1} runs over lanes of
//! points. Blocks of points are summed in their order: the bits do not depend on the number of threads.

use super::PhaseTable;
use super::gauss::gauss_legendre;
use rayon::prelude::*;

/// Points that share one pass of the recurrence.
const LANES: usize = 32;

/// χ_0 … χ_{count-1} of `table`.
pub(super) fn moments(table: &PhaseTable, count: usize) -> Vec<f64> {
    let points = quadrature(table, count);
    let blocks: Vec<Vec<f64>> =
        points.par_chunks(64 * LANES).map(|block| block_moments(block, count)).collect();
    blocks.iter().fold(vec![0.0; count], |mut sum, block| {
        sum.iter_mut().zip(block).for_each(|(total, part)| *total += part);
        sum
    })
}

/// (cosΘ, ½ w P sinΘ) of every quadrature point.
fn quadrature(table: &PhaseTable, count: usize) -> Vec<(f64, f64)> {
    const RULES: [usize; 5] = [6, 8, 12, 20, 48];
    let rules = RULES.map(gauss_legendre);
    let mut points = Vec::new();
    for (cell, width) in table.cells() {
        // 48 points serve a phase of 50; wider cells are split.
        let pieces = (width * count as f64 / 50.0).ceil().max(1.0);
        let half = 0.5 * width / pieces;
        let needed = 5.0 + 0.5 * (2.0 * half * count as f64) + 3.0 * half;
        let rule = rules.iter().find(|rule| rule.len() as f64 >= needed).unwrap_or(&rules[RULES.len() - 1]);
        for piece in 0..pieces as usize {
            let centre = half * (2 * piece + 1) as f64;
            points.extend(rule.iter().map(|(node, weight)| {
                let t = centre + half * node;
                let theta = cell.start + t;
                (libm::cos(theta), 0.5 * weight * half * (cell.value + cell.slope * t) * libm::sin(theta))
            }));
        }
    }
    points
}

fn block_moments(points: &[(f64, f64)], count: usize) -> Vec<f64> {
    let mut sums = vec![0.0; count];
    for lanes in points.chunks(LANES) {
        let (mut mu, mut weight) = ([0.0; LANES], [0.0; LANES]);
        for (i, point) in lanes.iter().enumerate() {
            (mu[i], weight[i]) = *point;
        }
        accumulate(&mut sums, &mu, &weight);
    }
    sums
}

/// Adds Σ w P_l(μ) over the lanes to `sums[l]`. The recurrence runs on wP_l itself, which is linear in w.
#[multiversion::multiversion(targets("x86_64+avx512f+avx512dq+avx512vl", "x86_64+avx2"))]
fn accumulate(sums: &mut [f64], mu: &[f64; LANES], weight: &[f64; LANES]) {
    let (mut before, mut legendre) = ([0.0; LANES], *weight);
    for (l, sum) in sums.iter_mut().enumerate() {
        *sum += legendre.iter().fold(0.0, |total, p| total + p);
        let l = l as f64;
        let (up, down) = ((2.0 * l + 1.0) / (l + 1.0), l / (l + 1.0));
        for i in 0..LANES {
            let next = up * mu[i] * legendre[i] - down * before[i];
            before[i] = legendre[i];
            legendre[i] = next;
        }
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
