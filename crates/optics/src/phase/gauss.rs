//! Gauss–Legendre rules on [-1, 1] by Newton's method on P_n (Abramowitz & Stegun 25.4.29).

use std::f64::consts::PI;

/// (node, weight) of the rule with `n` points, exact for polynomials up to degree 2n-1.
pub fn gauss_legendre(n: usize) -> Vec<(f64, f64)> {
    let count = n as f64;
    let rule = |i: usize| {
        let mut x = libm::cos(PI * (i as f64 + 0.75) / (count + 0.5));
        let mut slope = 1.0;
        for _ in 0..8 {
            let (value, derivative) = legendre(n, x);
            slope = derivative;
            x -= value / derivative;
        }
        (-x, 2.0 / ((1.0 - x * x) * slope * slope))
    };
    (0..n).map(rule).collect()
}

/// P_n and its derivative at `x`.
fn legendre(n: usize, x: f64) -> (f64, f64) {
    let (mut before, mut value) = (1.0, x);
    for l in 2..=n {
        let l = l as f64;
        (before, value) = (value, ((2.0 * l - 1.0) * x * value - (l - 1.0) * before) / l);
    }
    (value, n as f64 * (x * value - before) / (x * x - 1.0))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// ∫x^{2k} dx = 2/(2k+1) up to degree 2n-1.
    #[test]
    fn rules_are_exact_for_their_degree() {
        for n in [2, 3, 6, 20, 48] {
            for k in 0..n as i32 {
                let integral = gauss_legendre(n)
                    .iter()
                    .fold(0.0, |sum, (x, w)| sum + w * libm::pow(*x, f64::from(2 * k)));
                assert!((integral * f64::from(2 * k + 1) - 2.0).abs() < 1e-12, "{n} {k}");
            }
        }
    }
}
