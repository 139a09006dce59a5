//! Draine's phase function (2003, eq. 20): P ∝ (1 + α cos²Θ)(1-g²)/(1+g²-2g cosΘ)^{3/2}, norm 1 + α(1+2g²)/3.
//!
//! With d = 1-g, s = √(d²+2gv) and J_k = ∫_0^v u^k/(d²+2gu)^{3/2} du, which come out free of the singularity at g = 0
//! as J_0 = 2v/(ds(s+d)), J_1 = 2v²/(s(s+d)²), J_2 = 2v³(s+3d)/(3s(s+d)³), the cumulative is
//! ½(1-g²)[(1+α)J_0 - 2αJ_1 + αJ_2] over the norm. Newton's method inverts it. Moments follow from g^l by the
//! recurrence for μP_l, applied twice.

use super::PhaseFunction;
use stratiform_quantities::{Asymmetry, DomainError, Range};

/// Draine's function; α = 0 is Henyey–Greenstein, g = 0 and α = 1 is Rayleigh.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Draine {
    g: f64,
    alpha: f64,
    norm: f64,
}

impl Draine {
    /// The function with parameters `g` and `alpha`.
    ///
    /// # Errors
    /// [`DomainError`] unless 0 ≤ `alpha` ≤ 1e3.
    pub fn new(g: Asymmetry, alpha: f64) -> Result<Self, DomainError> {
        let g = g.get();
        let alpha = Range::closed(0.0, 1e3).check("alpha", alpha)?;
        Ok(Self { g, alpha, norm: 1.0 + alpha * (1.0 + 2.0 * g * g) / 3.0 })
    }

    fn root(&self, v: f64) -> f64 {
        ((1.0 - self.g) * (1.0 - self.g) + 2.0 * self.g * v).sqrt()
    }
}

impl PhaseFunction for Draine {
    fn value(&self, v: f64) -> f64 {
        let (s, mu) = (self.root(v), 1.0 - v);
        (1.0 - self.g * self.g) * (1.0 + self.alpha * mu * mu) / (self.norm * s * s * s)
    }

    fn cumulative(&self, v: f64) -> f64 {
        let (d, s) = (1.0 - self.g, self.root(v));
        let ratio = v / (s + d);
        // (1-g)J_k, so that the factor 1-g² = d(1+g) is shared.
        let j0 = 2.0 * ratio / s;
        let j1 = 2.0 * d * ratio * ratio / s;
        let j2 = 2.0 * d * ratio * ratio * ratio * (s + 3.0 * d) / (3.0 * s);
        0.5 * (1.0 + self.g) * ((1.0 + self.alpha) * j0 + self.alpha * (j2 - 2.0 * j1)) / self.norm
    }

    /// Newton's method inside a shrinking bracket; v is found to rounding.
    fn invert(&self, xi: f64) -> f64 {
        let (mut low, mut high) = (0.0, 2.0);
        let forward = (1.0 - self.g) / (1.0 - self.g + 2.0 * self.g * (1.0 - xi));
        let mut v = 2.0 * xi * forward * forward * (1.0 + self.g * (1.0 - xi));
        for _ in 0..60 {
            let excess = self.cumulative(v) - xi;
            if excess > 0.0 {
                high = v;
            } else {
                low = v;
            }
            let newton = v - 2.0 * excess / self.value(v);
            let next = if newton > low && newton < high { newton } else { 0.5 * (low + high) };
            if (next - v).abs() <= 2.0 * f64::EPSILON * v {
                return next;
            }
            v = next;
        }
        v
    }

    fn asymmetry(&self) -> f64 {
        self.g * (1.0 + self.alpha * (3.0 + 2.0 * self.g * self.g) / 5.0) / self.norm
    }

    fn moments(&self, count: usize) -> Vec<f64> {
        let powers: Vec<f64> =
            std::iter::successors(Some(1.0), |p| Some(p * self.g)).take(count + 2).collect();
        let squared = times_mu(&times_mu(&powers));
        (0..count).map(|l| (powers[l] + self.alpha * squared[l]) / self.norm).collect()
    }
}

/// Moments of μP from those of P: μP_l = ((l+1)P_{l+1} + lP_{l-1})/(2l+1). One moment fewer.
fn times_mu(chi: &[f64]) -> Vec<f64> {
    let moment = |l: usize| {
        let before = if l == 0 { 0.0 } else { l as f64 * chi[l - 1] };
        ((l + 1) as f64 * chi[l + 1] + before) / (2 * l + 1) as f64
    };
    (0..chi.len() - 1).map(moment).collect()
}
