//! Exponentials and sines without branches, so that loops over them run in a processor's lanes.
//!
//! e^x = 2^k e^r with |r| ≤ ½ ln 2 (Cody & Waite 1980) and the Taylor series of e^r - 1; sine and cosine of half an azimuth by their series
//! about π/2. Errors are a few units of the last place. The same bits on every processor: nothing is fused.

use std::f64::consts::{FRAC_PI_2, LOG2_E};

/// Below this e^x is taken for it.
const LEAST: f64 = -708.0;

/// ln 2 in two parts, the first of 20 bits.
const LN2: [f64; 2] = [0.693_146_705_627_441_4, 4.749_325_039_031_672_6e-7];

/// Added to a number below 2⁵¹, leaves its nearest integer in the last bits.
const TO_INTEGER: f64 = 6_755_399_441_055_744.0;

const TERMS: usize = 14;

/// 1/n!.
const INVERSE_FACTORIAL: [f64; 2 * TERMS] = {
    let mut series = [1.0; 2 * TERMS];
    let mut n = 1;
    while n < 2 * TERMS {
        series[n] = series[n - 1] / n as f64;
        n += 1;
    }
    series
};

/// e^x, and e^x - 1 without cancellation, for x ≤ 709; e^x is never below 1e-308.
#[inline(always)]
pub(super) fn exponentials(x: f64) -> (f64, f64) {
    let x = if x < LEAST { LEAST } else { x };
    let shifted = x * LOG2_E + TO_INTEGER;
    let k = shifted - TO_INTEGER;
    let r = (x - k * LN2[0]) - k * LN2[1];
    // (e^r - 1)/r, two chains side by side.
    let square = r * r;
    let (mut even, mut odd) = (INVERSE_FACTORIAL[TERMS - 1], INVERSE_FACTORIAL[TERMS]);
    for n in (0..TERMS / 2 - 1).rev() {
        even = INVERSE_FACTORIAL[2 * n + 1] + square * even;
        odd = INVERSE_FACTORIAL[2 * n + 2] + square * odd;
    }
    let sum = even + r * odd;
    let exponent = shifted.to_bits().wrapping_sub(TO_INTEGER.to_bits()).wrapping_add(1023);
    let power = f64::from_bits(exponent << 52);
    let rest = power * (r * sum);
    (power + rest, (power - 1.0) + rest)
}

/// ψ(x) = (1 - e^{-x})/x = exp\[0, -x\], with e^{-x}; x ≥ 0.
#[inline(always)]
pub(super) fn mean_exponential(x: f64) -> (f64, f64) {
    let (power, less) = exponentials(-x);
    (if x == 0.0 { 1.0 } else { -less / x }, power)
}

/// x ≥ 0, or the 1e-100 whose (1 - e^{-x})/x is 1 as well.
#[inline(always)]
pub(super) fn more_than_0(x: f64) -> f64 {
    if x < 1e-100 { 1e-100 } else { x }
}

/// Sine and cosine of x ∈ \[0, π\].
#[inline(always)]
pub(super) fn sine_cosine(x: f64) -> (f64, f64) {
    let y = x - FRAC_PI_2;
    let square = -y * y;
    let (mut even, mut odd) = (INVERSE_FACTORIAL[2 * TERMS - 2], INVERSE_FACTORIAL[2 * TERMS - 1]);
    for n in (0..TERMS - 1).rev() {
        even = INVERSE_FACTORIAL[2 * n] + square * even;
        odd = INVERSE_FACTORIAL[2 * n + 1] + square * odd;
    }
    (even, -y * odd)
}

#[cfg(test)]
mod tests {
    use super::*;

    const ULPS: f64 = 4.0 * f64::EPSILON;

    #[test]
    fn they_are_those_of_the_library() {
        for i in 0..100_000 {
            let x = f64::from(i) * 7e-3;
            for x in [-x, x, -1e-6 * x, 1e-9 * x] {
                let (power, less) = exponentials(x);
                assert!((power / libm::exp(x) - 1.0).abs() < ULPS, "{x}");
                assert!((less - libm::expm1(x)).abs() <= ULPS * libm::expm1(x).abs(), "{x}");
            }
            let x = std::f64::consts::PI * f64::from(i) / 99_999.0;
            let (sine, cosine) = sine_cosine(x);
            assert!((sine - libm::sin(x)).abs() < ULPS && (cosine - libm::cos(x)).abs() < ULPS, "{x}");
        }
    }

    #[test]
    fn ends_are_sound() {
        assert_eq!(exponentials(0.0), (1.0, 0.0));
        assert_eq!(mean_exponential(0.0), (1.0, 1.0));
        let (power, less) = exponentials(f64::NEG_INFINITY);
        assert!(power < 1e-300 && less == -1.0);
        assert!(mean_exponential(f64::INFINITY).0 == 0.0);
        assert!(exponentials(f64::NAN).0.is_nan() && mean_exponential(f64::NAN).0.is_nan());
    }
}
