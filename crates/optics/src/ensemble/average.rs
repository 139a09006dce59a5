//! Sums over radii of everything the averages need.

use super::circle::{self, Circles, Room};
use super::kernel::{self, Cosines, Sphere};
use super::radii::Node;
use crate::mie::{LANES, LaneCoefficients, Lanes, RefractiveIndex, SizeParameter, last_order};
use rayon::prelude::*;
use std::f64::consts::PI;

/// What all spheres of an average share.
pub(super) struct Basis {
    wave_number: f64,
    index: RefractiveIndex,
    cosines: Cosines,
    circles: Circles,
}

impl Basis {
    /// For radii up to `largest`.
    pub(super) fn new(wave_number: f64, index: RefractiveIndex, angles: &[f64], largest: f64) -> Self {
        // One more: the largest radius may come back a rounding error larger.
        let last = (last_order(wave_number * largest) + 1).min(circle::MOST_ORDERS);
        Self { wave_number, index, cosines: Cosines::new(angles), circles: Circles::new(last) }
    }
}

/// Sums of n(r) dr/du times cross-sections and intensities; the common factor du is left out.
#[derive(Clone, Debug, Default)]
pub(super) struct Average {
    extinction: f64,
    scattering: f64,
    forward: f64,
    /// Σ(|S1|²+|S2|²) of spheres that a circle holds.
    circles: circle::Sums,
    /// Σ|S1+S2|² at each angle and Σ|S1-S2|² at each angle's supplement, of larger spheres; empty without any.
    angles: [Vec<f64>; 2],
}

impl Average {
    /// Adds the radii `nodes`. Blocks of them are independent and added in their order.
    pub(super) fn add(&mut self, nodes: &[Node], basis: &Basis) {
        let blocks: Vec<Self> =
            nodes.par_chunks(kernel::BLOCK).map(|block| Self::of_block(block, basis)).collect();
        blocks.iter().for_each(|block| self.merge(block));
    }

    fn of_block(block: &[Node], basis: &Basis) -> Self {
        let mut sum = Self::default();
        // The range was checked; its square root may come back a rounding error outside.
        let checked = |&(radius, weight): &Node| {
            Some((SizeParameter::new(basis.wave_number * radius).ok()?, radius, weight))
        };
        let nodes: Vec<_> = block.iter().filter_map(checked).collect();
        let (mut large, mut room) = (Vec::new(), Room::default());
        for lanes in nodes.chunks(LANES) {
            let x = std::array::from_fn(|l| lanes[l.min(lanes.len() - 1)].0);
            let coefficients = LaneCoefficients::new(&x, basis.index);
            for ((_, radius, weight), q) in lanes.iter().zip(coefficients.efficiencies()) {
                let area = weight * PI * radius * radius;
                sum.extinction += area * q.q_ext;
                sum.scattering += area * q.q_sca;
                sum.forward += area * q.q_sca * q.g;
            }
            let weights: Vec<f64> = lanes.iter().map(|node| node.2).collect();
            if coefficients.orders.len() <= circle::MOST_ORDERS {
                // Lanes without a sphere have no weight.
                let weights = Lanes(std::array::from_fn(|l| weights.get(l).copied().unwrap_or(0.0)));
                basis.circles.add(&coefficients.orders, &weights, &mut sum.circles, &mut room);
            } else {
                large.extend(Sphere::of_lanes(&coefficients, &weights));
            }
        }
        if !large.is_empty() {
            sum.angles = kernel::intensities(&large, &basis.cosines);
        }
        sum
    }

    fn merge(&mut self, other: &Self) {
        self.extinction += other.extinction;
        self.scattering += other.scattering;
        self.forward += other.forward;
        self.circles.merge(&other.circles);
        for (sum, part) in self.angles.iter_mut().zip(&other.angles) {
            sum.resize(sum.len().max(part.len()), 0.0);
            sum.iter_mut().zip(part).for_each(|(sum, part)| *sum += part);
        }
    }

    pub(super) fn extinction(&self) -> f64 {
        self.extinction
    }

    /// ω; droplets that do not absorb have Q_sca = Q_ext to rounding, which may fall on either side of 1.
    pub(super) fn albedo(&self) -> f64 {
        (self.scattering / self.extinction).min(1.0)
    }

    pub(super) fn asymmetry(&self) -> f64 {
        self.forward / self.scattering
    }

    /// P at each angle, from (|S1|² + |S2|²)/2 = (|S1+S2|² + |S1-S2|²)/4.
    pub(super) fn phase(&self, basis: &Basis) -> Vec<f64> {
        let factor = PI / (basis.wave_number * basis.wave_number * self.scattering);
        let series = basis.circles.cosines(&self.circles);
        let mut p = basis.cosines.map(|mu| circle::at_cosines(&series, mu));
        p.iter_mut().for_each(|p| *p *= 2.0 * factor);
        let [plus, minus] = &self.angles;
        let pairs = p.iter_mut().zip(plus.iter().zip(minus.iter().rev()));
        pairs.for_each(|(p, (plus, minus))| *p += factor * (plus + minus));
        p
    }
}
