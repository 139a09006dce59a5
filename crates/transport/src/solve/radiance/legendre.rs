//! Normalised associated Legendre functions and Gauss–Legendre points.
//!
//! Λ_l^m = √((l-m)!/(l+m)!) P_l^m without the Condon–Shortley sign, so that P_l(cosΘ) = Σ_m(2-δ_m0) Λ_l^m(μ)Λ_l^m(μ')
//! cos m(φ-φ') (addition theorem; Abramowitz & Stegun 8.7). Recurrence in l: √((l+1)²-m²) Λ_{l+1} = (2l+1)μΛ_l -
//! √(l²-m²) Λ_{l-1}, from Λ_m^m = √((2m-1)!!/(2m)!!) (1-μ²)^{m/2}. Λ_l^m(-μ) = (-1)^{l-m}Λ_l^m(μ).

use crate::solve::quadrature::legendre_row;
use std::f64::consts::PI;

/// Λ_m^m … Λ_{m+n-1}^m at `mu`, n the length of `row`.
pub(super) fn associated(m: usize, mu: f64, row: &mut [f64]) {
    let square = (1.0 - mu) * (1.0 + mu);
    let start = (1..=m).fold(1.0, |product, k| product * (2 * k - 1) as f64 / (2 * k) as f64 * square);
    let (mut before, mut value) = (0.0, start.sqrt());
    let order = (m * m) as f64;
    let mut below = 0.0;
    for (place, entry) in row.iter_mut().enumerate() {
        *entry = value;
        let l = (m + place) as f64;
        let above = ((l + 1.0) * (l + 1.0) - order).sqrt();
        (before, value) = (value, ((2.0 * l + 1.0) * mu * value - below * before) / above);
        below = above;
    }
}

/// Points, falling, and weights of the Gauss rule of ∫₀¹f dx.
pub(super) fn gauss(count: usize) -> (Vec<f64>, Vec<f64>) {
    let n = count as f64;
    let mut row = vec![0.0; count + 1];
    let mut point = |i: usize| {
        let mut x = libm::cos(PI * (i as f64 + 0.75) / (n + 0.5));
        let mut slope = 1.0;
        for _ in 0..6 {
            legendre_row(x, &mut row);
            slope = n * (x * row[count] - row[count - 1]) / (x * x - 1.0);
            x -= row[count] / slope;
        }
        (0.5 * (1.0 + x), 1.0 / ((1.0 - x * x) * slope * slope))
    };
    (0..count).map(&mut point).unzip()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_rule_integrates_powers() {
        for count in [1, 2, 7, 64] {
            let (x, w) = gauss(count);
            for power in [0, 1, 2 * count - 1] {
                let sum = x.iter().zip(&w).fold(0.0, |sum, (x, w)| sum + w * libm::pow(*x, power as f64));
                assert!((sum * (power + 1) as f64 - 1.0).abs() < 1e-12, "{count} {power}");
            }
        }
    }

    /// The addition theorem at one pair of directions.
    #[test]
    fn the_addition_theorem_holds() {
        const L: usize = 40;
        let (a, b, phi): (f64, f64, f64) = (0.83, -0.31, 1.1);
        let cosine = a * b + ((1.0 - a * a) * (1.0 - b * b)).sqrt() * libm::cos(phi);
        let mut expected = vec![0.0; L];
        legendre_row(cosine, &mut expected);
        let mut found = vec![0.0; L];
        for m in 0..L {
            let (mut of_a, mut of_b) = (vec![0.0; L - m], vec![0.0; L - m]);
            associated(m, a, &mut of_a);
            associated(m, b, &mut of_b);
            let weight = if m == 0 { 1.0 } else { 2.0 } * libm::cos(m as f64 * phi);
            (m..L).for_each(|l| found[l] += weight * of_a[l - m] * of_b[l - m]);
        }
        assert!(found.iter().zip(&expected).all(|(f, e)| (f - e).abs() < 1e-12));
    }
}
