//! The Henyey–Greenstein phase function (Henyey & Greenstein 1941, eq. 2).
//!
//! With v = 1 - cosΘ, 1 + g² - 2g·cosΘ = (1-g)² + 2gv, so P = (1-g²)/((1-g)² + 2gv)^{3/2}. The probability
//! below v is (1-g²)/2 · [1/(1-g) - 1/√((1-g)²+2gv)]/g; multiplying out the bracket gives
//! (1+g)v / (s(s+1-g)) with s = √((1-g)²+2gv), which has no singularity at g = 0.

use super::PhaseFunction;
use stratiform_quantities::Asymmetry;

/// P with moments χ_l = g^l.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HenyeyGreenstein {
    g: f64,
}

impl HenyeyGreenstein {
    /// The function with asymmetry parameter `g`.
    pub const fn new(g: Asymmetry) -> Self {
        Self { g: g.get() }
    }

    /// s = √(1 + g² - 2g·cosΘ).
    fn root(&self, v: f64) -> f64 {
        ((1.0 - self.g) * (1.0 - self.g) + 2.0 * self.g * v).sqrt()
    }
}

impl PhaseFunction for HenyeyGreenstein {
    fn value(&self, v: f64) -> f64 {
        let s = self.root(v);
        (1.0 - self.g * self.g) / (s * s * s)
    }

    fn cumulative(&self, v: f64) -> f64 {
        let s = self.root(v);
        (1.0 + self.g) * v / (s * (s + 1.0 - self.g))
    }

    /// Solving the cumulative for v: with η = 1 - ξ, v = 2ξ(1-g)²(1+gη)/(1-g+2gη)².
    fn invert(&self, xi: f64) -> f64 {
        let eta = 1.0 - xi;
        let forward = (1.0 - self.g) / (1.0 - self.g + 2.0 * self.g * eta);
        (2.0 * xi * forward * forward * (1.0 + self.g * eta)).min(2.0)
    }

    fn asymmetry(&self) -> f64 {
        self.g
    }

    fn moments(&self, count: usize) -> Vec<f64> {
        std::iter::successors(Some(1.0), |power| Some(power * self.g)).take(count).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn inversion_undoes_the_cumulative() {
        for g in [-0.99, -0.5, -1e-9, 0.0, 1e-9, 0.5, 0.85, 0.99, 0.9999] {
            let hg = HenyeyGreenstein::new(Asymmetry::new(g).unwrap());
            for k in 0..=100 {
                let xi = f64::from(k) / 100.0;
                let v = hg.invert(xi);
                assert!((0.0..=2.0).contains(&v), "g {g} xi {xi} v {v}");
                assert!((hg.cumulative(v) - xi).abs() < 1e-11, "g {g} xi {xi} v {v}");
            }
        }
    }
}
