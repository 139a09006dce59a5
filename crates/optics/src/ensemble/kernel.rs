//! The intensities of many spheres at many angles, as one blocked matrix product: for spheres too large for
//! [`circle`](super::circle).
//!
//! With p_n = π_n + τ_n and c_n = (2n+1)/(n(n+1)), S1+S2 = Σ c_n(a_n+b_n)p_n(μ), and because
//! π_n - τ_n at μ is (-1)^{n-1}p_n(-μ), S1-S2 = Σ (-1)^{n-1}c_n(a_n-b_n)p_n(-μ). On a grid symmetric about 90° one
//! matrix p therefore serves both sums: per sphere, order and angle four products. A tile of
//! [`LANES`] angles holds p for all orders while the spheres of a block pass. Sums run in a fixed order without fused
//! multiply-add, so that every instruction set gives the same bits.
//!
//! Per sphere and order a tile needs eight products and eight sums of vectors of eight, which fill the two such units of a core
//! with AVX-512 for eight cycles; its loads (two of p, four of coefficients) take three.

use crate::mie::{LANES, LaneCoefficients, Lanes};

/// Spheres that share a pass over the angles.
pub(super) const BLOCK: usize = 32;

/// Four real coefficients per order: c_n(a_n+b_n) and (-1)^{n-1}c_n(a_n-b_n).
pub(super) struct Sphere {
    orders: Vec<[f64; 4]>,
    weight: f64,
}

impl Sphere {
    /// The spheres of the lanes, as many as there are `weights`.
    pub(super) fn of_lanes(coefficients: &LaneCoefficients, weights: &[f64]) -> Vec<Self> {
        let lanes = weights.iter().zip(coefficients.last);
        let mut spheres: Vec<Self> =
            lanes.map(|(&weight, last)| Self { orders: Vec::with_capacity(last), weight }).collect();
        for (i, parts) in coefficients.orders.iter().enumerate() {
            let rows = combined(i, parts);
            for (l, sphere) in spheres.iter_mut().enumerate().filter(|(l, _)| i < coefficients.last[*l]) {
                sphere.orders.push(rows.each_ref().map(|row| row.0[l]));
            }
        }
        spheres
    }
}

/// c_n(a_n+b_n) and (-1)^{n-1}c_n(a_n-b_n) with n = i + 1.
fn combined(i: usize, [a_re, a_im, b_re, b_im]: &[Lanes; 4]) -> [Lanes; 4] {
    let n = (i + 1) as f64;
    let c = (2.0 * n + 1.0) / (n * (n + 1.0));
    let sign = if i.is_multiple_of(2) { c } else { -c };
    let sum = |a: &Lanes, b: &Lanes| Lanes(std::array::from_fn(|l| (a.0[l] + b.0[l]) * c));
    let difference = |a: &Lanes, b: &Lanes| Lanes(std::array::from_fn(|l| (a.0[l] - b.0[l]) * sign));
    [sum(a_re, b_re), sum(a_im, b_im), difference(a_re, b_re), difference(a_im, b_im)]
}

/// cosΘ of a symmetric grid, padded to whole tiles.
pub(super) struct Cosines {
    tiles: Vec<Lanes>,
    count: usize,
}

impl Cosines {
    pub(super) fn new(theta_deg: &[f64]) -> Self {
        let cosine = |t: f64| if t == 90.0 { 0.0 } else { libm::cos(t.to_radians()) };
        let symmetric = |t: &f64| if *t > 90.0 { -cosine(180.0 - t) } else { cosine(*t) };
        let all: Vec<f64> = theta_deg.iter().map(symmetric).collect();
        let tile = |chunk: &[f64]| {
            let mut lanes = [0.0; LANES];
            lanes[..chunk.len()].copy_from_slice(chunk);
            Lanes(lanes)
        };
        Self { tiles: all.chunks(LANES).map(tile).collect(), count: all.len() }
    }

    /// `f` of every cosine.
    pub(super) fn map(&self, f: impl Fn(&Lanes) -> Lanes) -> Vec<f64> {
        let mut values: Vec<f64> = self.tiles.iter().flat_map(|mu| f(mu).0).collect();
        values.truncate(self.count);
        values
    }
}

/// Σ weight·|S1+S2|² at each angle, and Σ weight·|S1-S2|² at each angle's supplement.
pub(super) fn intensities(spheres: &[Sphere], cosines: &Cosines) -> [Vec<f64>; 2] {
    let orders = spheres.iter().map(|sphere| sphere.orders.len()).max().unwrap_or(0);
    let mut rows = vec![Lanes([0.0; LANES]); orders];
    let (mut plus, mut minus) = (Vec::new(), Vec::new());
    for mu in &cosines.tiles {
        angular_functions(&mu.0, &mut rows);
        let [mut p, mut m] = [[0.0; LANES]; 2];
        for sphere in spheres {
            add_intensity(sphere, &rows, &mut p, &mut m);
        }
        plus.extend(p);
        minus.extend(m);
    }
    plus.truncate(cosines.count);
    minus.truncate(cosines.count);
    [plus, minus]
}

/// `rows[n-1]` = π_n + τ_n at every angle of a tile.
#[multiversion::multiversion(targets("x86_64+avx512f+avx512dq+avx512vl", "x86_64+avx2"))]
fn angular_functions(mu: &[f64; LANES], rows: &mut [Lanes]) {
    let (mut pi, mut before) = ([1.0; LANES], [0.0; LANES]);
    for (i, row) in rows.iter_mut().enumerate() {
        let n = (i + 1) as f64;
        let growth = (n + 1.0) / n;
        for l in 0..LANES {
            let s = mu[l] * pi[l];
            let t = s - before[l];
            row.0[l] = pi[l] + (n * t - before[l]);
            before[l] = pi[l];
            pi[l] = s + growth * t;
        }
    }
}

#[multiversion::multiversion(targets("x86_64+avx512f+avx512dq+avx512vl", "x86_64+avx2"))]
fn add_intensity(sphere: &Sphere, rows: &[Lanes], plus: &mut [f64; LANES], minus: &mut [f64; LANES]) {
    let [mut pr, mut pi, mut mr, mut mi] = [[0.0; LANES]; 4];
    for (c, row) in sphere.orders.iter().zip(rows) {
        for l in 0..LANES {
            pr[l] += c[0] * row.0[l];
            pi[l] += c[1] * row.0[l];
            mr[l] += c[2] * row.0[l];
            mi[l] += c[3] * row.0[l];
        }
    }
    for l in 0..LANES {
        plus[l] += sphere.weight * (pr[l] * pr[l] + pi[l] * pi[l]);
        minus[l] += sphere.weight * (mr[l] * mr[l] + mi[l] * mi[l]);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mie::{RefractiveIndex, SizeParameter};

    /// The same sums angle by angle, compiled for the least instruction set.
    fn plainly(sphere: &Sphere, mu: f64) -> [f64; 2] {
        let (mut pi, mut before, mut sums) = (1.0, 0.0, [0.0; 4]);
        for (i, c) in sphere.orders.iter().enumerate() {
            let n = (i + 1) as f64;
            let s = mu * pi;
            let t = s - before;
            let p = pi + (n * t - before);
            sums.iter_mut().zip(c).for_each(|(sum, c)| *sum += c * p);
            (before, pi) = (pi, s + (n + 1.0) / n * t);
        }
        let [pr, pi, mr, mi] = sums;
        [sphere.weight * (pr * pr + pi * pi), sphere.weight * (mr * mr + mi * mi)]
    }

    #[test]
    fn every_instruction_set_gives_the_same_bits() {
        let index = RefractiveIndex::new(1.333, 1e-6).unwrap();
        let sizes = std::array::from_fn(|l| SizeParameter::new(61.0 + 22.7 * l as f64).unwrap());
        let spheres = Sphere::of_lanes(&LaneCoefficients::new(&sizes, index), &[0.2, 0.3]);
        let angles: Vec<f64> = (0..=36).map(|i| 5.0 * f64::from(i)).collect();
        let cosines = Cosines::new(&angles);
        let [plus, minus] = intensities(&spheres, &cosines);
        for (i, mu) in cosines.tiles.iter().flat_map(|tile| tile.0).take(angles.len()).enumerate() {
            let [first, second] = [&spheres[0], &spheres[1]].map(|sphere| plainly(sphere, mu));
            assert_eq!([plus[i], minus[i]], [first[0] + second[0], first[1] + second[1]], "{}", angles[i]);
        }
    }
}
