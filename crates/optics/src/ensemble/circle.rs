//! The intensities of spheres up to a few thousand orders as cosine series.
//!
//! The amplitudes of a sphere of N orders are cosine series of N terms ([`CosineTerms`]), so |S|² has 2N of them, whatever
//! number of angles P is wanted at: M > 2N values hold it. They are taken round the circle, a quarter step off
//! (Θ_m = 2π(m+¼)/M, of which no two are each other's mirror images), by one Fourier sum each for S1 and S2. The
//! weighted |S|² of spheres of similar size are added there; a sum turns into its series once, however many they are.
//!
//! The error is a rounding error of the forward peak: relative to P at its smallest, 1e-16 times the span of P.

use super::cosines::{CosineTerms, Term};
use super::fourier::{Fourier, Point, place};
use crate::mie::{LANES, Lanes};
use std::f64::consts::PI;

/// Most orders of a sphere: the table of their series takes 8 MiB, and P spans 1e9.
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

/// Room to work in, kept from one group of spheres to the next.
#[derive(Default)]
pub(super) struct Room {
    series: Vec<Term>,
    points: Vec<Point>,
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

    /// Adds spheres of the coefficients `orders` (Re a, Im a, Re b, Im b), a weight each.
    pub(super) fn add(&self, orders: &[Term], weights: &Lanes, sums: &mut Sums, room: &mut Room) {
        let place = circle_of(orders.len());
        let circle = &self.circles[place];
        let sum = sums.at(place);
        amplitude_series(&self.terms, orders, &mut room.series);
        for amplitude in 0..2 {
            room.points.resize(circle.quarters.len(), ZERO);
            unroll(&room.series[..orders.len() + 2], amplitude, &circle.quarters, &mut room.points);
            circle.fourier.sum(&mut room.points);
            add_intensities(&room.points, weights, sum);
        }
    }

    /// C_k of Σ weight·(|S1|²+|S2|²) = Σ_k C_k cos kΘ.
    pub(super) fn cosines(&self, sums: &Sums) -> Vec<f64> {
        let mut total = Vec::new();
        for (circle, sum) in self.circles.iter().zip(&sums.0).filter(|(_, sum)| !sum.is_empty()) {
            total.resize(sum.len(), 0.0);
            total.iter_mut().zip(circle.cosines(sum)).for_each(|(total, c)| *total += c);
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

    /// C_k = 2/M Σ_m g_m cos kΘ_m (half of it for k = 0) of a real sum g, which rides in one lane.
    fn cosines(&self, sum: &[f64]) -> impl Iterator<Item = f64> {
        let count = self.quarters.len();
        let mut points = vec![ZERO; count];
        for (m, point) in points.iter_mut().enumerate() {
            point[0].0[0] = sum[place(m, count)];
        }
        self.fourier.sum(&mut points);
        self.quarters.iter().enumerate().map(move |(k, [cosine, sine])| {
            let [re, im] = &points[place(k, count)];
            let factor = if k == 0 { 1.0 } else { 4.0 } / count as f64;
            factor * (re.0[0] * cosine - im.0[0] * sine)
        })
    }
}

#[multiversion::multiversion(targets("x86_64+avx512f+avx512dq+avx512vl", "x86_64+avx2"))]
fn amplitude_series(terms: &CosineTerms, orders: &[Term], series: &mut Vec<Term>) {
    terms.series(orders, series);
}

/// S1 (`amplitude` 0) or S2 (1) as the terms of a Fourier sum: X_k cos kΘ_m = X_k ½(e^{ikΘ_m} + e^{-ikΘ_m}).
#[multiversion::multiversion(targets("x86_64+avx512f+avx512dq+avx512vl", "x86_64+avx2"))]
fn unroll(series: &[Term], amplitude: usize, quarters: &[[f64; 2]], points: &mut [Point]) {
    let (own, other) = (2 * amplitude, 2 - 2 * amplitude);
    for k in 0..series.len() - 1 {
        let [cosine, sine] = quarters[k];
        let (rate, twice) = (0.5 * k as f64, if k == 1 { 2.0 } else { 1.0 });
        let (here, below, above) = (&series[k], &series[k.saturating_sub(1)], &series[k + 1]);
        let [mut ahead, mut behind] = [ZERO; 2];
        for l in 0..LANES {
            let x = |part: usize| {
                here[own + part].0[l] + rate * (twice * below[other + part].0[l] - above[other + part].0[l])
            };
            let (re, im) = (x(0), x(1));
            (ahead[0].0[l], ahead[1].0[l]) = (re * cosine - im * sine, im * cosine + re * sine);
            (behind[0].0[l], behind[1].0[l]) = (re * cosine + im * sine, im * cosine - re * sine);
        }
        points[k] = ahead;
        if k > 0 {
            points[quarters.len() - k] = behind;
        }
    }
    points[series.len() - 1..quarters.len() + 2 - series.len()].fill(ZERO);
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
    use super::super::kernel::{Cosines, Sphere, intensities};
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
            let mut sums = Sums::default();
            circles.add(&coefficients.orders, &Lanes(weights), &mut sums, &mut Room::default());
            let series = circles.cosines(&sums);
            let found = cosines.map(|mu| at_cosines(&series, mu));
            for ((found, theta), (plus, minus)) in
                found.iter().zip(&angles).zip(plus.iter().zip(minus.iter().rev()))
            {
                let off = 2.0 * found / (plus + minus) - 1.0;
                assert!(off.abs() < bound, "x = {largest}, {theta} degrees: {off:e}");
            }
        }
    }
}
