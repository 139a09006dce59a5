//! The Mie coefficients a_n, b_n (Bohren & Huffman 1983, eqs. 4.88).
//!
//! With the logarithmic derivative D_n of ψ_n and ξ_n = ψ_n - iχ_n, a_n = p_n/(p_n - iq_n) where
//! p_n = (D_n(mx)/m + n/x)ψ_n - ψ_{n-1}, and q_n is the same with χ for ψ; b_n has mD_n for D_n/m.
//! Every recurrence runs in its stable direction: D_n and the ratio ψ_{n-1}/ψ_n downwards, χ_n upwards, ψ_n upwards
//! to n = x and by the ratio beyond. There p_n is written ψ_n(D_n(mx)/m - D_n(x)), which keeps the digits that the
//! difference loses in small spheres.

use super::{RefractiveIndex, SizeParameter};
use num_complex::Complex64;

/// a_n and b_n, entry 0 holding n = 1.
#[derive(Clone, Debug, PartialEq)]
pub struct Coefficients {
    /// a_n.
    pub a: Vec<Complex64>,
    /// b_n.
    pub b: Vec<Complex64>,
}

impl Coefficients {
    /// The coefficients up to [`last_order`].
    pub fn new(x: SizeParameter, m: RefractiveIndex) -> Self {
        coefficients(x.get(), m.get())
    }
}

/// Order after which terms no longer matter: x + 4.05x^{1/3} + 2 (Wiscombe 1980) and a margin for more digits.
pub fn last_order(x: f64) -> usize {
    (x + 4.8 * libm::cbrt(x) + 4.0) as usize
}

/// Order from which a downward recurrence with argument of size `z` has forgotten its start at order `n`.
pub(super) fn start_order(z: f64, n: usize) -> usize {
    n.max((z + 8.0 * libm::cbrt(z)) as usize) + 16
}

fn coefficients(x: f64, m: Complex64) -> Coefficients {
    let n_max = last_order(x);
    let inside = logarithmic_derivatives(m * x, n_max);
    let outside = RiccatiBessel::new(x, n_max);
    let inverse_m = m.inv();
    let (mut a, mut b) = (Vec::with_capacity(n_max), Vec::with_capacity(n_max));
    for (n, d) in inside.into_iter().enumerate().skip(1) {
        a.push(outside.coefficient(n, d * inverse_m));
        b.push(outside.coefficient(n, d * m));
    }
    Coefficients { a, b }
}

/// D_0 … D_{n_max} of z: D_{n-1} = n/z - 1/(D_n + n/z).
fn logarithmic_derivatives(z: Complex64, n_max: usize) -> Vec<Complex64> {
    let inverse = z.inv();
    let mut d = Complex64::default();
    let mut table = vec![d; n_max + 1];
    for n in (1..=start_order(z.norm_sqr().sqrt(), n_max)).rev() {
        let n_over_z = inverse * n as f64;
        d = n_over_z - (d + n_over_z).inv();
        if n <= n_max + 1 {
            table[n - 1] = d;
        }
    }
    table
}

/// ψ_n, χ_n of a real argument, and ψ_{n-1}/ψ_n where n > x.
struct RiccatiBessel {
    x: f64,
    psi: Vec<f64>,
    chi: Vec<f64>,
    ratio: Vec<f64>,
}

impl RiccatiBessel {
    fn new(x: f64, n_max: usize) -> Self {
        let ratio = psi_ratios(x, n_max);
        let (sin, cos) = (libm::sin(x), libm::cos(x));
        let (mut psi, mut chi) = (vec![sin], vec![cos]);
        for n in 1..=n_max {
            let factor = (2 * n - 1) as f64 / x;
            let next = if n as f64 > x {
                psi[n - 1] / ratio[n]
            } else {
                factor * psi[n - 1] - if n == 1 { cos } else { psi[n - 2] }
            };
            psi.push(next);
            chi.push(factor * chi[n - 1] + if n == 1 { sin } else { -chi[n - 2] });
        }
        Self { x, psi, chi, ratio }
    }

    /// a_n for `d` = D_n(mx)/m, b_n for `d` = mD_n(mx).
    fn coefficient(&self, n: usize, d: Complex64) -> Complex64 {
        let n_over_x = n as f64 / self.x;
        let p = if n as f64 > self.x {
            (d - (self.ratio[n] - n_over_x)) * self.psi[n]
        } else {
            (d + n_over_x) * self.psi[n] - self.psi[n - 1]
        };
        let q = (d + n_over_x) * self.chi[n] - self.chi[n - 1];
        p / Complex64::new(p.re + q.im, p.im - q.re)
    }
}

/// r_n = ψ_{n-1}/ψ_n for n > x (0 below): r_n = (2n+1)/x - 1/r_{n+1}.
fn psi_ratios(x: f64, n_max: usize) -> Vec<f64> {
    let mut table = vec![0.0; n_max + 1];
    let start = start_order(x, n_max);
    let mut ratio = (2 * start + 1) as f64 / x;
    for n in (1..start).rev().take_while(|&n| n as f64 > x) {
        ratio = (2 * n + 1) as f64 / x - 1.0 / ratio;
        if n <= n_max {
            table[n] = ratio;
        }
    }
    table
}
