//! The two transcendental functions of the inner loop, as plain arithmetic: the same bits on every machine.
//!
//! A random word u stands for ξ = (u + ½)/2³², which is neither 0 nor 1; a word serves azimuth and path of a flight as
//! [`single`](crate::single) tells.
//! Both functions are power series cut where the first term left out is below 5·10⁻¹⁴.

use std::f64::consts::{LN_2, PI, SQRT_2};
use std::ops::{Add, Mul};

/// The unit of ξ for one random word.
const WORD: f64 = 1.0 / 4_294_967_296.0;

/// ξ of a random word.
#[inline(always)]
pub(crate) fn uniform(bits: u32) -> f64 {
    (f64::from(bits) + 0.5) * WORD
}

/// -ln ξ, an optical path of mean 1.
#[inline(always)]
pub(crate) fn optical_path(bits: u32) -> f64 {
    minus_logarithm(uniform(bits))
}

/// -ln ξ', the path between two collisions.
#[inline(always)]
pub(crate) fn flight_path(bits: u32) -> f64 {
    let low = bits & 0x003f_ffff;
    minus_logarithm((f64::from(low) + 0.5) * (1.0 / 4_194_304.0))
}

/// -ln ξ.
///
/// ξ = 2ᵏm with m ∈ \[√½, √2), and ln m = 2 artanh s = 2s(1 + s²/3 + s⁴/5 + …), s = (m-1)/(m+1), |s| < 0.172.
#[inline(always)]
fn minus_logarithm(xi: f64) -> f64 {
    let word = xi.to_bits();
    // The exponent field, counted from √½ instead of from ½.
    let shifted = word.wrapping_sub((0.5 * SQRT_2).to_bits());
    let exponent = (shifted >> 52) as i64 as i32;
    let exponent = (exponent << 20) >> 20;
    let m = f64::from_bits(word.wrapping_sub((exponent as i64 as u64) << 52));
    let s = (m - 1.0) / (m + 1.0);
    let series =
        horner(s * s, [1.0, 1.0 / 3.0, 0.2, 1.0 / 7.0, 1.0 / 9.0, 1.0 / 11.0, 1.0 / 13.0, 1.0 / 15.0]);
    -(f64::from(exponent) * LN_2 + 2.0 * s * series)
}

/// The cosine of a uniform azimuth.
///
/// sin y with y = π(½ - |i|/2³¹), i the word as a signed number, |y| ≤ π/2, by Taylor's series up to y¹⁷.
#[inline(always)]
pub(crate) fn azimuth_cosine(bits: u32) -> f64 {
    let y = PI * (0.5 - 2.0 * WORD * f64::from(bits as i32).abs());
    y * horner(y * y, SINE)
}

/// (-1)ⁿ/(2n+1)!
const SINE: [f64; 9] = {
    let mut terms = [1.0; 9];
    let mut n = 1;
    while n < 9 {
        terms[n] = -terms[n - 1] / ((2 * n) * (2 * n + 1)) as f64;
        n += 1;
    }
    terms
};

/// Σ c_n xⁿ.
#[inline(always)]
pub(crate) fn horner<T, const N: usize>(x: T, coefficients: [T; N]) -> T
where
    T: Copy + Add<Output = T> + Mul<Output = T>,
{
    let mut sum = coefficients[N - 1];
    for n in (0..N - 1).rev() {
        sum = sum * x + coefficients[n];
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;

    fn words() -> impl Iterator<Item = u32> {
        let ends = (0..2000).chain((0..2000).map(|k| u32::MAX - k));
        let powers = (1..32).flat_map(|k| (0..3_u32).map(move |d| (1_u32 << k) - 1 + d));
        ends.chain(powers).chain((0..2_000_000_u32).map(|k| k.wrapping_mul(2_654_435_761)))
    }

    #[test]
    fn the_path_is_the_logarithm() {
        for bits in words() {
            let exact = -libm::log(uniform(bits));
            let got = optical_path(bits);
            assert!((got - exact).abs() <= 5e-14 && got > 0.0, "{bits}: {got} {exact}");
        }
    }

    #[test]
    fn the_path_of_a_flight_is_the_logarithm_of_the_lower_bits() {
        for bits in words() {
            let exact = -libm::log((f64::from(bits % (1 << 22)) + 0.5) / 4_194_304.0);
            let got = flight_path(bits);
            assert!((got - exact).abs() <= 5e-14 && got > 0.0, "{bits}: {got} {exact}");
        }
    }

    #[test]
    fn the_azimuth_is_the_cosine() {
        for bits in words() {
            let exact = libm::cos(2.0 * PI * f64::from(bits as i32) * WORD);
            let got = azimuth_cosine(bits);
            assert!((got - exact).abs() <= 1e-13, "{bits}: {got} {exact}");
        }
    }
}
