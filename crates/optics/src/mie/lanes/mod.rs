//! The coefficients of many spheres at once, one lane each, with the bits of [`Coefficients`](super::Coefficients).
//!
//! The same recurrences in the same order of operations, without fused multiply-add: every instruction set gives the
//! bits of one sphere alone. Lanes differ in where a recurrence starts and in which order is their last; a lane waits
//! for its start, and what follows its last order is zero. Best when the spheres have similar sizes.

mod efficiencies;
mod recurrences;

use super::coefficients::start_order;
use super::{RefractiveIndex, SizeParameter, last_order};

/// Spheres computed together.
pub const LANES: usize = 16;

/// One number of every lane.
#[derive(Clone, Copy, Debug)]
#[repr(align(64))]
pub struct Lanes(pub [f64; LANES]);

const ZERO: Lanes = Lanes([0.0; LANES]);

/// a_n and b_n of [`LANES`] spheres, entry 0 holding n = 1.
pub struct LaneCoefficients {
    /// Parts of a_n and b_n: Re a, Im a, Re b, Im b.
    pub orders: Vec<[Lanes; 4]>,
    /// The last order of each lane.
    pub last: [usize; LANES],
    x: [f64; LANES],
}

impl LaneCoefficients {
    /// The coefficients of the spheres `x`; a caller with fewer spheres repeats one.
    pub fn new(x: &[SizeParameter; LANES], m: RefractiveIndex) -> Self {
        let sizes = Sizes::new(x);
        let most = sizes.last.iter().copied().max().unwrap_or(0);
        let mut tables = vec![Row::default(); most + 1];
        recurrences::logarithmic_derivatives(&sizes, m.get(), &mut tables);
        recurrences::psi_ratios(&sizes, &mut tables);
        recurrences::riccati_bessel(&sizes, &mut tables);
        let mut orders = vec![[ZERO; 4]; most];
        recurrences::coefficients(&sizes, m.get(), &tables, &mut orders);
        Self { orders, last: sizes.last, x: sizes.x }
    }
}

/// x of every lane, and its last order.
struct Sizes {
    x: [f64; LANES],
    last: [usize; LANES],
}

impl Sizes {
    fn new(x: &[SizeParameter; LANES]) -> Self {
        let x = x.map(SizeParameter::get);
        Self { x, last: x.map(last_order) }
    }

    /// Where a downward recurrence starts in every lane whose argument has size `z`, as a number, and the largest start.
    fn starts(&self, z: [f64; LANES]) -> ([f64; LANES], usize) {
        let starts: [usize; LANES] = std::array::from_fn(|l| start_order(z[l], self.last[l]));
        (starts.map(|n| n as f64), starts.into_iter().max().unwrap_or(0))
    }
}

/// D_n(mx), ψ_n, χ_n of x, and ψ_{n-1}/ψ_n where n > x.
#[derive(Clone, Copy)]
struct Row {
    d_re: Lanes,
    d_im: Lanes,
    ratio: Lanes,
    psi: Lanes,
    chi: Lanes,
}

impl Default for Row {
    fn default() -> Self {
        Self { d_re: ZERO, d_im: ZERO, ratio: ZERO, psi: ZERO, chi: ZERO }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mie::{Coefficients, efficiencies};

    fn equals_scalar(x: &[f64], n: f64, k: f64) {
        let sizes: Vec<SizeParameter> = x.iter().map(|&x| SizeParameter::new(x).unwrap()).collect();
        let m = RefractiveIndex::new(n, k).unwrap();
        let together = LaneCoefficients::new(&std::array::from_fn(|l| sizes[l.min(sizes.len() - 1)]), m);
        for (l, &x) in sizes.iter().enumerate() {
            let alone = Coefficients::new(x, m);
            assert_eq!(together.last[l], alone.a.len());
            assert_eq!(together.efficiencies()[l], efficiencies(x, &alone), "x = {x:?}, m = {n} + {k}i");
            for (i, parts) in together.orders.iter().enumerate() {
                let found = parts.map(|part| part.0[l].to_bits());
                let (a, b) = alone.a.get(i).copied().zip(alone.b.get(i).copied()).unwrap_or_default();
                let expected = [a.re, a.im, b.re, b.im].map(f64::to_bits);
                assert_eq!(found, expected, "x = {x:?}, m = {n} + {k}i, order {}", i + 1);
            }
        }
    }

    #[test]
    fn lanes_give_the_bits_of_one_sphere_alone() {
        let wide: Vec<f64> = (0..LANES).map(|l| libm::pow(10.0, l as f64 / 3.0 - 2.5)).collect();
        let narrow: Vec<f64> = (0..LANES).map(|l| 83.7 + 0.13 * l as f64).collect();
        for (n, k) in [(1.333, 0.0), (1.333, 1.96e-9), (1.26, 2e-3), (1.5, 1.0), (0.7, 0.1), (7.0, 3.0)] {
            equals_scalar(&wide, n, k);
            equals_scalar(&narrow, n, k);
            equals_scalar(&[1e-3, 5.0, 1e4], n, k);
            equals_scalar(&[64.0], n, k);
        }
    }
}
