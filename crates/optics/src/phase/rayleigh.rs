//! Rayleigh scattering, P = ¾(1 + cos²Θ) (Rayleigh 1871).
//!
//! In v = 1 - cosΘ the cumulative is ⅜(2v - v² + v³/3). Its inverse solves μ³ + 3μ = 4 - 8ξ, which has the one real
//! root μ = 2 sinh(⅓ asinh(2 - 4ξ)); one Newton step in v restores the digits that 1 - μ loses near forward.

use super::PhaseFunction;

/// Scattering by molecules, depolarisation neglected.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Rayleigh;

impl PhaseFunction for Rayleigh {
    fn value(&self, v: f64) -> f64 {
        let mu = 1.0 - v;
        0.75 * (1.0 + mu * mu)
    }

    fn cumulative(&self, v: f64) -> f64 {
        0.375 * v * (2.0 - v * (1.0 - v / 3.0))
    }

    fn invert(&self, xi: f64) -> f64 {
        let v = 1.0 - 2.0 * libm::sinh(libm::asinh(2.0 - 4.0 * xi) / 3.0);
        (v - 2.0 * (self.cumulative(v) - xi) / self.value(v)).clamp(0.0, 2.0)
    }

    fn asymmetry(&self) -> f64 {
        0.0
    }

    fn moments(&self, count: usize) -> Vec<f64> {
        let mut chi = vec![0.0; count];
        for (l, value) in [(0, 1.0), (2, 0.1)] {
            if l < count {
                chi[l] = value;
            }
        }
        chi
    }
}
