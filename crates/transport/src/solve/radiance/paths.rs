//! How a mode's depth dependence reaches a face, for all modes at once.
//!
//! ∫₀^τ f(t) e^{-t/μ} dt/μ with f = cosh kx and sinh(kx)/k, x = t - τ/2, both divided by cosh(kτ/2); as [`crate::solve::slab::Path`],
//! by one form without branches: from the near side (1 - e^{-a-b})/(1 + kμ), from the far side b e^{-min(a,b)}ψ(|a-b|),
//! a = kτ, b = τ/μ.

use super::elementary::{exponentials, more_than_0};

/// Below this kτ/2 a mode counts as linear in depth.
const LINEAR: f64 = 1e-5;

/// The integrals of each mode.
pub(super) struct Paths {
    pub(super) cosh: Vec<f64>,
    /// Of sinh(kx)/k.
    pub(super) sinh_by_k: Vec<f64>,
}

impl Paths {
    pub(super) fn new(decay: &[f64], tau: f64, mu: f64) -> Self {
        let (mut cosh, mut sinh_by_k) = (vec![0.0; decay.len()], vec![0.0; decay.len()]);
        integrate(decay, tau, mu, &mut cosh, &mut sinh_by_k);
        Self { cosh, sinh_by_k }
    }
}

#[multiversion::multiversion(targets("x86_64+avx512f+avx512dq+avx512vl", "x86_64+avx2"))]
fn integrate(decay: &[f64], tau: f64, mu: f64, cosh: &mut [f64], sinh_by_k: &mut [f64]) {
    let b = tau / mu;
    let straight = linear(tau, mu);
    for ((k, cosh), sinh_by_k) in decay.iter().zip(cosh).zip(sinh_by_k) {
        let a = k * tau;
        let (least, most) = if a < b { (a, b) } else { (b, a) };
        let apart = more_than_0(most - least);
        let ((power, less), (faded, less_again)) = (exponentials(-least), exponentials(-apart));
        // e^{-a}, and e^{-a-b} - 1.
        let decayed = if a < b { power } else { power * faded };
        let both_less = less + power * (less + power * less_again);
        let slant = 1.0 + k * mu;
        let (near, far) = (-both_less * apart, -b * power * less_again * slant);
        // Quotients are slow: one for all.
        let scale = 1.0 / (k * apart * slant * (1.0 + decayed));
        *cosh = (far + near) * k * scale;
        *sinh_by_k = if 0.5 * a < LINEAR { straight } else { (far - near) * scale };
    }
}

/// ∫(t - τ/2) e^{-t/μ} dt/μ.
fn linear(tau: f64, mu: f64) -> f64 {
    let b = tau / mu;
    let rest = if b > 700.0 { 0.0 } else { libm::exp(-b) * (mu + tau) };
    mu - rest + 0.5 * tau * libm::expm1(-b)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::solve::slab::Path;

    #[test]
    fn they_are_those_of_the_fluxes() {
        let decay = [1e-8, 1e-3, 0.4, 1.999_999, 2.0, 2.7, 35.0, 4e3];
        for (tau, mu) in [(1e-3, 0.5), (0.3, 0.5), (7.0, 0.5), (300.0, 1.0), (1e4, 1e-10)] {
            let paths = Paths::new(&decay, tau, mu);
            for (j, k) in decay.iter().enumerate() {
                let one = Path::new(*k, tau, mu);
                let near = |found: f64, expected: f64, rounding: f64| {
                    (found - expected).abs() <= 1e-12 * expected.abs() + rounding
                };
                assert!(near(paths.cosh[j], one.cosh, 1e-14), "{k} {tau} {mu}");
                // A difference divided by k, in both forms.
                assert!(near(paths.sinh_by_k[j], one.sinh_by_k, 1e-15 / k), "{k} {tau} {mu}");
            }
        }
    }
}
