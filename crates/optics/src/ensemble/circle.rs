//! The intensities of spheres up to a few thousand orders as cosine series.
//!
//! The amplitudes of a sphere of N orders are cosine series of N terms ([`CosineTerms`]), so |S|² has 2N of them, whatever
//! number of angles P is wanted at: M > 2N values hold it. They are taken round the circle, a quarter step off
//! (Θ_m = 2π(m+¼)/M, of which no two are each other's mirror images), by one Fourier sum each for S1+S2 and S1-S2. The
//! weighted |S|² of spheres of similar size are added there; a sum turns into its series once, however many they are.
//!
//! The error is a rounding error of the forward peak: relative to P at its smallest, 1e-16 times the span of P.

use super::cosines::CosineTerms;
use super::fourier::{Fourier, Point, place};
use crate::mie::{LANES, Lanes};
use std::f64::consts::PI;

/// Most orders of a sphere: the table of their series takes 16 MiB, and P spans 1e9.
pub(super) const MOST_ORDERS: usize = 2047;

const ZERO: Point = [Lanes([0.0; LANES]); 2];

/// The tables of one average: circles of 2, 4, … points.
pub(super) struct Circles {
    last: usize,
    terms: CosineTerms,
    circles: Vec<Circle>,
}

struct Circle {
    fourier: Fourier,
    /// ½e^{iπk/2M}: the quarter step, and the half of a cosine; 1 at k = 0.
    quarters: Vec<[f64; 2]>,
}

/// Σ weight·|S|² at the points of every circle, in the order of the Fourier sums; empty where no sphere was.
#[derive(Clone, Debug, Default)]
pub(super) struct Sums(Vec<Vec<f64>>);

impl Circles {
    /// For spheres of `last` orders or fewer.
    pub(super) fn new(last: usize) -> Self {
        let sizes = circle_of(last) + 1;
        Self {
            last,
            terms: CosineTerms::new(last),
            circles: (0..sizes).map(|i| Circle::new(2 << i)).collect(),
        }
    }

    /// Adds spheres to the sums of S1+S2 and of S1-S2: rows of [`combined`](super::kernel::combined) orders, and a weight each.
    /// `points` is room to work in.
    pub(super) fn add(
        &self,
        orders: &[[Lanes; 4]],
        weights: &Lanes,
        sums: &mut [Sums; 2],
        points: &mut Vec<Point>,
    ) {
        let place = circle_of(orders.len());
        let circle = &self.circles[place];
        for (series, sum) in sums.iter_mut().enumerate() {
            points.clear();
            points.resize(circle.quarters.len(), ZERO);
            unroll(&self.terms, orders, 2 * series, &circle.quarters, points);
            circle.fourier.sum(points);
            add_intensities(points, weights, sum.at(place));
        }
    }

    /// C_k of Σ_k C_k cos kΘ, the two sums together: |S1-S2|² is that at the supplement of Θ.
    pub(super) fn cosines(&self, sums: &[Sums; 2]) -> Vec<f64> {
        let mut total = Vec::new();
        for (i, circle) in self.circles.iter().enumerate() {
            let Some([plus, minus]) = sums[0].0.get(i).zip(sums[1].0.get(i)).map(|(a, b)| [a, b]) else {
                break;
            };
            if plus.is_empty() {
                continue;
            }
            let series = circle.cosines([plus, minus]);
            total.resize(series.len(), 0.0);
            for (k, (total, [plus, minus])) in total.iter_mut().zip(series).enumerate() {
                *total += if k % 2 == 0 { plus + minus } else { plus - minus };
            }
        }
        total.truncate(2 * self.last + 1);
        total
    }
}

/// The index of the least circle that holds the intensity of `last` orders.
fn circle_of(last: usize) -> usize {
    (2 * last + 1).next_power_of_two().trailing_zeros() as usize - 1
}

impl Sums {
    fn at(&mut self, circle: usize) -> &mut [f64] {
        if self.0.len() <= circle {
            self.0.resize(circle + 1, Vec::new());
        }
        let sum = &mut self.0[circle];
        sum.resize(2 << circle, 0.0);
        sum
    }

    pub(super) fn merge(&mut self, other: &Self) {
        for (circle, part) in other.0.iter().enumerate().filter(|(_, part)| !part.is_empty()) {
            self.at(circle).iter_mut().zip(part).for_each(|(sum, part)| *sum += part);
        }
    }
}

impl Circle {
    fn new(points: usize) -> Self {
        let quarter = |k: usize| {
            let (sine, cosine) = libm::sincos(0.5 * PI * k as f64 / points as f64);
            if k == 0 { [1.0, 0.0] } else { [0.5 * cosine, 0.5 * sine] }
        };
        Self { fourier: Fourier::new(points), quarters: (0..points).map(quarter).collect() }
    }

    /// C_k = 2/M Σ_m g_m cos kΘ_m (half of it for k = 0) of two real sums g at once, which ride in two lanes.
    fn cosines(&self, sums: [&[f64]; 2]) -> Vec<[f64; 2]> {
        let count = self.quarters.len();
        let mut points = vec![ZERO; count];
        for (m, point) in points.iter_mut().enumerate() {
            for (l, sum) in sums.iter().enumerate() {
                point[0].0[l] = sum[place(m, count)];
            }
        }
        self.fourier.sum(&mut points);
        let share = 1.0 / count as f64;
        let term = |(k, [cosine, sine]): (usize, &[f64; 2])| {
            let [re, im] = &points[place(k, count)];
            let factor = if k == 0 { share } else { 4.0 * share };
            std::array::from_fn(|l| factor * (re.0[l] * cosine - im.0[l] * sine))
        };
        self.quarters.iter().enumerate().map(term).collect()
    }
}

/// Σ X_k cos kΘ_m = Σ_k X_k ½(e^{ikΘ_m} + e^{-ikΘ_m}) as the terms of a Fourier sum; `points` come as zeros.
#[multiversion::multiversion(targets("x86_64+avx512f+avx512dq+avx512vl", "x86_64+avx2"))]
fn unroll(
    terms: &CosineTerms,
    orders: &[[Lanes; 4]],
    part: usize,
    quarters: &[[f64; 2]],
    points: &mut [Point],
) {
    terms.series(orders, part, |k, re, im| {
        let [cosine, sine] = quarters[k];
        let [mut ahead, mut behind] = [ZERO; 2];
        for l in 0..LANES {
            let (along, across) = ([re.0[l] * cosine, im.0[l] * cosine], [im.0[l] * sine, re.0[l] * sine]);
            (ahead[0].0[l], ahead[1].0[l]) = (along[0] - across[0], along[1] + across[1]);
            (behind[0].0[l], behind[1].0[l]) = (along[0] + across[0], along[1] - across[1]);
        }
        points[k] = ahead;
        if k > 0 {
            points[quarters.len() - k] = behind;
        }
    });
}

#[multiversion::multiversion(targets("x86_64+avx512f+avx512dq+avx512vl", "x86_64+avx2"))]
fn add_intensities(points: &[Point], weights: &Lanes, sums: &mut [f64]) {
    for ([re, im], sum) in points.iter().zip(sums) {
        let mut parts = [0.0; LANES];
        let squares = re.0.iter().zip(&im.0).map(|(re, im)| re * re + im * im);
        parts.iter_mut().zip(&weights.0).zip(squares).for_each(|((part, w), square)| *part = w * square);
        // Halves are added to halves: the same tree on every instruction set.
        let mut width = LANES / 2;
        while width > 0 {
            for l in 0..width {
                parts[l] += parts[l + width];
            }
            width /= 2;
        }
        *sum += parts[0];
    }
}

/// Σ C_k cos kΘ at each lane's cosΘ.
#[multiversion::multiversion(targets("x86_64+avx512f+avx512dq+avx512vl", "x86_64+avx2"))]
pub(super) fn at_cosines(series: &[f64], mu: &Lanes) -> Lanes {
    let (mut before, mut cosine, mut total) = (mu.0, [1.0; LANES], [0.0; LANES]);
    for c in series {
        for l in 0..LANES {
            total[l] += c * cosine[l];
            let next = 2.0 * mu.0[l] * cosine[l] - before[l];
            before[l] = cosine[l];
            cosine[l] = next;
        }
    }
    Lanes(total)
}

#[cfg(test)]
mod tests {
    use super::super::kernel::{Cosines, Sphere, combined, intensities};
    use super::*;
    use crate::mie::{LaneCoefficients, RefractiveIndex, SizeParameter};

    /// P of sixteen spheres by both ways, from a few orders to as many as a circle holds; a part of what P spans.
    #[test]
    fn a_circle_gives_what_the_sums_angle_by_angle_give() {
        let index = RefractiveIndex::new(1.333, 1e-6).unwrap();
        let angles: Vec<f64> = (0..=360).map(|i| 0.5 * f64::from(i)).collect();
        let cosines = Cosines::new(&angles);
        let circles = Circles::new(MOST_ORDERS);
        for (largest, bound) in [(0.5, 1e-13), (20.0, 1e-12), (300.0, 1e-10), (1950.0, 1e-7)] {
            let x = std::array::from_fn(|l| SizeParameter::new(largest * (1.0 - 0.03 * l as f64)).unwrap());
            let coefficients = LaneCoefficients::new(&x, index);
            let weights: [f64; LANES] = std::array::from_fn(|l| 1.0 + l as f64);
            let [plus, minus] = intensities(&Sphere::of_lanes(&coefficients, &weights), &cosines);
            let orders: Vec<_> =
                coefficients.orders.iter().enumerate().map(|(i, parts)| combined(i, parts)).collect();
            let mut sums = [Sums::default(), Sums::default()];
            circles.add(&orders, &Lanes(weights), &mut sums, &mut Vec::new());
            let series = circles.cosines(&sums);
            let found = cosines.map(|mu| at_cosines(&series, mu));
            for ((found, theta), (plus, minus)) in
                found.iter().zip(&angles).zip(plus.iter().zip(minus.iter().rev()))
            {
                let off = found / (plus + minus) - 1.0;
                assert!(off.abs() < bound, "x = {largest}, {theta} degrees: {off:e}");
            }
        }
    }
}
