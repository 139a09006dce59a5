//! Sums over radii of everything the averages need.

use super::kernel::{self, Sphere};
use super::radii::Node;
use crate::mie::{LANES, LaneCoefficients, RefractiveIndex, SizeParameter};
use rayon::prelude::*;
use std::f64::consts::PI;

/// Sums of n(r) dr/du times cross-sections and intensities; the common factor du is left out.
#[derive(Clone, Debug)]
pub(super) struct Average {
    extinction: f64,
    scattering: f64,
    forward: f64,
    /// Σ|S1+S2|² at each angle.
    plus: Vec<f64>,
    /// Σ|S1-S2|² at each angle's supplement.
    minus: Vec<f64>,
}

impl Average {
    pub(super) fn new(angles: &[f64]) -> Self {
        let zeros = vec![0.0; angles.len()];
        Self { extinction: 0.0, scattering: 0.0, forward: 0.0, plus: zeros.clone(), minus: zeros }
    }

    /// Adds the radii `nodes`. Blocks of them are independent and added in their order.
    pub(super) fn add(&mut self, nodes: &[Node], wave_number: f64, index: RefractiveIndex, angles: &[f64]) {
        let cosines = kernel::Cosines::new(angles);
        let blocks: Vec<Self> = nodes
            .par_chunks(kernel::BLOCK)
            .map(|block| Self::of_block(block, wave_number, index, &cosines))
            .collect();
        blocks.iter().for_each(|block| self.merge(block));
    }

    fn of_block(block: &[Node], wave_number: f64, index: RefractiveIndex, cosines: &kernel::Cosines) -> Self {
        let mut sum =
            Self { extinction: 0.0, scattering: 0.0, forward: 0.0, plus: Vec::new(), minus: Vec::new() };
        // The range was checked; its square root may come back a rounding error outside.
        let checked =
            |&(radius, weight): &Node| Some((SizeParameter::new(wave_number * radius).ok()?, radius, weight));
        let nodes: Vec<_> = block.iter().filter_map(checked).collect();
        let mut spheres = Vec::with_capacity(nodes.len());
        for lanes in nodes.chunks(LANES) {
            let x = std::array::from_fn(|l| lanes[l.min(lanes.len() - 1)].0);
            let weights: Vec<f64> = lanes.iter().map(|node| node.2).collect();
            let coefficients = LaneCoefficients::new(&x, index);
            for ((_, radius, weight), q) in lanes.iter().zip(coefficients.efficiencies()) {
                let area = weight * PI * radius * radius;
                sum.extinction += area * q.q_ext;
                sum.scattering += area * q.q_sca;
                sum.forward += area * q.q_sca * q.g;
            }
            spheres.extend(Sphere::of_lanes(&coefficients, &weights));
        }
        (sum.plus, sum.minus) = kernel::intensities(&spheres, cosines);
        sum
    }

    fn merge(&mut self, other: &Self) {
        self.extinction += other.extinction;
        self.scattering += other.scattering;
        self.forward += other.forward;
        self.plus.iter_mut().zip(&other.plus).for_each(|(sum, part)| *sum += part);
        self.minus.iter_mut().zip(&other.minus).for_each(|(sum, part)| *sum += part);
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

    /// P at each angle: (|S1|² + |S2|²)/2 = (|S1+S2|² + |S1-S2|²)/4.
    pub(super) fn phase(&self, wave_number: f64) -> Vec<f64> {
        let factor = PI / (wave_number * wave_number * self.scattering);
        let pairs = self.plus.iter().zip(self.minus.iter().rev());
        pairs.map(|(plus, minus)| factor * (plus + minus)).collect()
    }
}
