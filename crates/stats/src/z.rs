//! Differences in standard errors, and the threshold that keeps many of them honest.

use crate::Estimate;
use std::f64::consts::FRAC_1_SQRT_2;

/// (a - b)/√(s_a² + s_b²): standard normal if both estimate the same number independently.
///
/// Two values without error give 0 if equal, otherwise ±∞.
pub fn z_score(a: Estimate, b: Estimate) -> f64 {
    let difference = a.value - b.value;
    if difference == 0.0 {
        return 0.0;
    }
    difference / libm::hypot(a.std_error, b.std_error)
}

/// The |z| that the largest of `tests` independent standard normals exceeds with probability `alpha` (Šidák 1967):
/// each test may raise a false alarm with probability 1 - (1-α)^{1/tests}. If the tests depend on each other the
/// family's rate is at most -ln(1-α), whatever the dependence (Boole's inequality).
///
/// Out-of-domain input (`alpha` outside (0, 1), no tests) gives `None`.
pub fn family_threshold(alpha: f64, tests: usize) -> Option<f64> {
    if !(alpha > 0.0 && alpha < 1.0) || tests == 0 {
        return None;
    }
    let single = -libm::expm1(libm::log1p(-alpha) / tests as f64);
    Some(two_sided_quantile(single))
}

/// The z with P(|Z| > z) = erfc(z/√2) = `probability`, by bisection to the last digit.
fn two_sided_quantile(probability: f64) -> f64 {
    let (mut low, mut high) = (0.0, 40.0);
    for _ in 0..64 {
        let middle = 0.5 * (low + high);
        if libm::erfc(middle * FRAC_1_SQRT_2) > probability {
            low = middle;
        } else {
            high = middle;
        }
    }
    0.5 * (low + high)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Purpose, key, photon_stream};
    use rand::Rng;

    /// Two-sided points of the normal distribution (Abramowitz & Stegun 1964, table 26.5).
    #[test]
    fn quantiles_are_the_tabulated_ones() {
        for (probability, z) in [(0.05, 1.959_964), (0.01, 2.575_829), (0.001, 3.290_527), (1e-8, 5.730_729)]
        {
            assert!((two_sided_quantile(probability) - z).abs() < 1e-6);
        }
    }

    #[test]
    fn one_test_has_the_plain_threshold_and_nonsense_has_none() {
        assert!((family_threshold(0.05, 1).unwrap() - 1.959_964).abs() < 1e-6);
        assert!(family_threshold(0.05, 100).unwrap() > 3.4);
        for (alpha, tests) in [(0.0, 1), (1.0, 1), (f64::NAN, 1), (0.05, 0)] {
            assert!(family_threshold(alpha, tests).is_none());
        }
    }

    fn proportion(index: u64, below: u32, trials: u64) -> Estimate {
        let mut rng = photon_stream(key(3, Purpose::Calibration), index);
        Estimate::from_hits((0..trials).filter(|_| rng.next_u32() < below).count() as u64, trials)
    }

    /// A difference of 8 standard errors is missed at threshold 4 less than once in 10⁴ seeds.
    #[test]
    fn a_planted_difference_is_rejected() {
        let exact = Estimate { value: 0.5, std_error: 0.0 };
        let shifted = proportion(0, (0.504 * 4_294_967_296.0) as u32, 1_000_000);
        assert!(z_score(shifted, exact).abs() > 4.0);
        assert!(z_score(proportion(1, 1 << 31, 1_000_000), exact).abs() < 4.0);
        assert_eq!(z_score(exact, exact), 0.0);
        assert_eq!(z_score(Estimate { value: 0.6, std_error: 0.0 }, exact), f64::INFINITY);
    }
}
