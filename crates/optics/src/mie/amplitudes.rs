//! S1 and S2 at one angle (Bohren & Huffman 1983, eq. 4.74).
//!
//! S1 = Σ (2n+1)/(n(n+1)) (a_n π_n + b_n τ_n), S2 the same with π and τ exchanged. π_n and τ_n follow from
//! s = μπ_n, t = s - π_{n-1}: τ_n = nt - π_{n-1}, π_{n+1} = s + (n+1)/n·t (Wiscombe 1980, eq. 13).

use super::{Coefficients, ScatteringAngle};
use num_complex::Complex64;

/// The scattering amplitudes at one angle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Amplitudes {
    /// The angle.
    pub angle: ScatteringAngle,
    /// S1, perpendicular to the scattering plane.
    pub s1: Complex64,
    /// S2, parallel to it.
    pub s2: Complex64,
}

impl Amplitudes {
    /// (|S1|² + |S2|²)/2, the intensity for unpolarised light.
    pub fn intensity(&self) -> f64 {
        0.5 * (self.s1.norm_sqr() + self.s2.norm_sqr())
    }
}

/// S1 and S2 at `angle`.
pub fn amplitudes(coefficients: &Coefficients, angle: ScatteringAngle) -> Amplitudes {
    let mu = angle.cos();
    let (mut s1, mut s2) = (Complex64::default(), Complex64::default());
    let (mut pi, mut pi_before) = (1.0, 0.0);
    for (i, (a, b)) in coefficients.a.iter().zip(&coefficients.b).enumerate() {
        let n = (i + 1) as f64;
        let s = mu * pi;
        let t = s - pi_before;
        let tau = n * t - pi_before;
        let weight = (2.0 * n + 1.0) / (n * (n + 1.0));
        s1 += (a * pi + b * tau) * weight;
        s2 += (a * tau + b * pi) * weight;
        (pi, pi_before) = (s + (n + 1.0) / n * t, pi);
    }
    Amplitudes { angle, s1, s2 }
}
