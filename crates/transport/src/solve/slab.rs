//! One slab under diffuse light, and by reciprocity under light from any direction.
//!
//! Uniform radiance 1 from above is half the sum of two problems: lit alike from both sides (S even about
//! the middle) and lit with opposite signs (S odd). Each is one system of n equations, without growing
//! exponentials; in a lossless medium the first has the exact solution 1, so R + T = 1 to rounding. By
//! reciprocity the radiance that leaves towards μ0 is the plane albedo R(μ0), that which leaves below is
//! T(μ0): one solution serves every μ0, no beam enters, and μ0 equal to a stream is nothing special. The
//! radiance in direction μ0 is the integral of the source function along it (Chandrasekhar 1950, ch. 1 §
//! 9), in closed form, of which μ0 → 0 is the value at the surface.

use super::matrix::Matrix;
use super::modes::Modes;

/// Reflectance and transmittance, the latter with unscattered light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Pair {
    pub(crate) reflectance: f64,
    pub(crate) transmittance: f64,
}

/// Below this k·τ/2 a mode counts as linear in depth.
const LINEAR: f64 = 1e-5;

/// A direction of incidence: μ0 and the modes' scattering into it.
#[derive(Clone, Debug)]
pub(crate) struct Direction {
    pub(crate) mu0: f64,
    pub(crate) sum: Vec<f64>,
    pub(crate) difference: Vec<f64>,
}

/// Amplitudes of the modes for optical thickness τ.
#[derive(Clone, Debug)]
pub(crate) struct Slab<'a> {
    modes: &'a Modes,
    tau: f64,
    even: Vec<f64>,
    odd: Vec<f64>,
}

impl<'a> Slab<'a> {
    pub(crate) fn new(modes: &'a Modes, tau: f64) -> Self {
        let lit: Vec<f64> = modes.streams.root_weight.iter().map(|root| 2.0 * root).collect();
        Self::lit_by(modes, tau, &lit)
    }

    /// Lit by twice the radiances `lit` (times √w) in the streams.
    fn lit_by(modes: &'a Modes, tau: f64, lit: &[f64]) -> Self {
        let (phi, psi) = (&modes.sum, &modes.difference);
        let slopes: Vec<(f64, f64)> = modes.decay.iter().map(|k| slope(*k, tau)).collect();
        let even = |i: usize, j: usize| phi[(j, i)] + modes.decay[j] * slopes[j].0 * psi[(j, i)];
        let odd = |i: usize, j: usize| psi[(j, i)] + slopes[j].1 * phi[(j, i)];
        let count = lit.len();
        let even = Matrix::from_fn(count, even).solve(lit.to_vec());
        let odd = Matrix::from_fn(count, odd).solve(lit.to_vec());
        Self { modes, tau, even, odd }
    }

    /// Plane albedo and total transmittance for light from `direction`.
    pub(crate) fn lit_from(&self, direction: &Direction) -> Pair {
        if self.tau == 0.0 {
            return Pair { reflectance: 0.0, transmittance: 1.0 };
        }
        let (mut even, mut odd) = (0.0, 0.0);
        for (j, &k) in self.modes.decay.iter().enumerate() {
            let path = Path::new(k, self.tau, direction.mu0);
            let (sum, difference) = (direction.sum[j], direction.difference[j]);
            even += self.even[j] * (sum * path.cosh + difference * k * k * path.sinh_by_k);
            odd -= self.odd[j] * (sum * path.sinh_by_k + difference * path.cosh);
        }
        let half = 0.25 * self.modes.omega;
        let unscattered = libm::exp(-self.tau / direction.mu0);
        Pair { reflectance: half * (even + odd), transmittance: unscattered + half * (even - odd) }
    }

    /// Reflectance and transmittance of diffuse light: fluxes of the streams.
    pub(crate) fn lit_diffusely(&self) -> Pair {
        if self.tau == 0.0 {
            return Pair { reflectance: 0.0, transmittance: 1.0 };
        }
        let (reflected, transmitted) = self.leaving();
        let streams = &self.modes.streams;
        let flux = |radiance: &[f64]| {
            (0..streams.count())
                .fold(0.0, |sum, i| sum + 2.0 * streams.mu[i] * streams.root_weight[i] * radiance[i])
        };
        Pair { reflectance: flux(&reflected), transmittance: flux(&transmitted) }
    }

    /// Radiances times √w leaving above and below.
    fn leaving(&self) -> (Vec<f64>, Vec<f64>) {
        let count = self.even.len();
        let (mut even, mut odd) = (vec![0.0; count], vec![0.0; count]);
        for (j, &k) in self.modes.decay.iter().enumerate() {
            let (tangent, by_k) = slope(k, self.tau);
            let (phi, psi) = (self.modes.sum.row(j), self.modes.difference.row(j));
            for i in 0..count {
                even[i] += self.even[j] * (phi[i] - k * tangent * psi[i]);
                odd[i] += self.odd[j] * (by_k * phi[i] - psi[i]);
            }
        }
        let quarter = |sign: f64| even.iter().zip(&odd).map(|(e, o)| 0.25 * (e + sign * o)).collect();
        (quarter(1.0), quarter(-1.0))
    }

    /// Bidirectional reflection between streams: row i the radiance towards stream j of unit flux from
    /// stream i.
    #[cfg(test)]
    pub(crate) fn reflection(modes: &'a Modes, tau: f64) -> Matrix {
        let streams = &modes.streams;
        let mut reflection = Matrix::zeros(streams.count());
        for i in 0..streams.count() {
            let mut lit = vec![0.0; streams.count()];
            lit[i] = 2.0 / (streams.root_weight[i] * streams.mu[i]);
            let (reflected, _) = Self::lit_by(modes, tau, &lit).leaving();
            for (j, radiance) in reflected.iter().enumerate() {
                reflection[(i, j)] = radiance / streams.root_weight[j];
            }
        }
        reflection
    }
}

/// tanh(kτ/2) and tanh(kτ/2)/k.
pub(crate) fn slope(k: f64, tau: f64) -> (f64, f64) {
    let x = 0.5 * k * tau;
    if x < LINEAR { (x, 0.5 * tau) } else { (libm::tanh(x), libm::tanh(x) / k) }
}

/// ∫₀^τ f(t) e^{-t/μ} dt/μ of a mode's depth dependence, with x = t - τ/2 and both functions divided by
/// cosh(kτ/2).
pub(crate) struct Path {
    pub(crate) cosh: f64,
    /// Of sinh(kx)/k.
    pub(crate) sinh_by_k: f64,
}

impl Path {
    pub(crate) fn new(k: f64, tau: f64, mu: f64) -> Self {
        let (a, b) = (k * tau, tau / mu);
        // From the near side: (1 - e^{-a-b})/(1 + kμ); from the far side: b(e^{-a} - e^{-b})/(b - a).
        let near = -libm::expm1(-a - b) / (1.0 + k * mu);
        let far = far_side(a, b, k * mu);
        let both = 1.0 + libm::exp(-a);
        let sinh_by_k = if 0.5 * a < LINEAR { linear(tau, mu) } else { (far - near) / (k * both) };
        Self { cosh: (far + near) / both, sinh_by_k }
    }
}

fn far_side(a: f64, b: f64, ratio: f64) -> f64 {
    if (ratio - 1.0).abs() > 0.5 {
        return (libm::exp(-a) - libm::exp(-b)) / (1.0 - ratio);
    }
    let difference = (b - a).abs();
    let mean = if difference > 0.0 { -libm::expm1(-difference) / difference } else { 1.0 };
    b * libm::exp(-a.min(b)) * mean
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
    use crate::solve::kernel::Kernel;

    /// Light from i towards j is light from j towards i.
    #[test]
    fn reflection_is_reciprocal() {
        let chi = |g: f64| std::iter::successors(Some(1.0), move |power| Some(power * g)).take(256).collect();
        for (g, omega, tau) in [(0.0, 1.0, 1.0), (0.85, 1.0, 100.0), (0.85, 0.9, 1e-3), (-0.5, 0.999, 1e4)] {
            let kernel = Kernel::new(chi(g), 24);
            let reflection = Slab::reflection(&Modes::new(&kernel, 24, omega), tau);
            let most = (0..24).fold(0.0_f64, |most, i| most.max(reflection[(i, i)]));
            for i in 0..24 {
                for j in 0..i {
                    let difference = reflection[(i, j)] - reflection[(j, i)];
                    assert!(difference.abs() < 1e-9 * most, "{g} {omega} {tau}: {difference:e}");
                }
            }
        }
    }
}
