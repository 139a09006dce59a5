//! P = 1.

use super::PhaseFunction;

/// Scattering with no preferred direction.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Isotropic;

impl PhaseFunction for Isotropic {
    fn value(&self, _v: f64) -> f64 {
        1.0
    }

    fn cumulative(&self, v: f64) -> f64 {
        0.5 * v
    }

    fn invert(&self, xi: f64) -> f64 {
        2.0 * xi
    }

    fn asymmetry(&self) -> f64 {
        0.0
    }

    fn moments(&self, count: usize) -> Vec<f64> {
        (0..count).map(|l| if l == 0 { 1.0 } else { 0.0 }).collect()
    }
}
