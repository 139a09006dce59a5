//! Whether a picture differs from a sampled truth by more than the truth's noise.
//!
//! z = (picture - truth)/√(σ² + (ρ truth)²) at every pixel, ρ = 1e-5 for the picture's rounding. Were the picture the expectation of a truth
//! with normal errors, a share erfc(k/√2) of pixels would be beyond k; the number beyond is then binomial, and `probability` is that of so
//! many or more. Who rejects below a probability α falsely rejects at most a share α of perfect pictures.

use super::{Band, Sampled, triples};
use crate::{Grey, Image, ImagingError};
use stratiform_quantities::Range;

/// Share of the truth's value that single precision may cost a picture.
const ROUNDING: f64 = 1e-5;

/// Pixels beyond k standard errors.
#[derive(Clone, Debug, PartialEq)]
pub struct Significance {
    /// z of every pixel; 0 where neither a difference nor noise is.
    pub map: Grey,
    /// k.
    pub sigmas: f64,
    /// Share of pixels with |z| > k.
    pub beyond: f64,
    /// The share that noise alone has there.
    pub expected: f64,
    /// Of so many pixels beyond, or more, by noise alone.
    pub probability: f64,
}

/// Compares every pixel of `band` with the noise of the truth.
///
/// # Errors
/// [`ImagingError`] for images that are not alike or not finite, for a negative standard error, and for k outside (0, 8].
pub fn significance(
    picture: &Image,
    truth: &Sampled<'_>,
    band: Band,
    sigmas: f64,
) -> Result<Significance, ImagingError> {
    Range { min_included: false, ..Range::closed(0.0, 8.0) }.check("sigmas", sigmas)?;
    let pixels = triples(picture, truth, band)?;
    let z = pixels.iter().map(|p| {
        let rounding = ROUNDING * p.truth;
        let scale = (p.std_error * p.std_error + rounding * rounding).sqrt();
        let difference = p.picture - p.truth;
        // Light where the truth is exactly dark is as significant as can be.
        if difference == 0.0 {
            0.0
        } else {
            (difference / scale.max(f64::MIN_POSITIVE)).clamp(-1e6, 1e6) as f32
        }
    });
    let map = Grey::new(picture.width(), picture.height(), z.collect())?;
    let count = map.values().iter().filter(|z| f64::from(z.abs()) > sigmas).count();
    let expected = libm::erfc(sigmas * std::f64::consts::FRAC_1_SQRT_2);
    Ok(Significance {
        sigmas,
        beyond: count as f64 / pixels.len() as f64,
        expected,
        probability: at_least(count, pixels.len(), expected),
        map,
    })
}

/// Probability that a binomial count of `n` trials of probability `p` is `count` or more: the sum of its terms from the smallest.
fn at_least(count: usize, n: usize, p: f64) -> f64 {
    if count == 0 {
        return 1.0;
    }
    let (n_f, log_p, log_q) = (n as f64, libm::log(p), libm::log1p(-p));
    let log_term = |k: usize| {
        let k = k as f64;
        let choose = libm::lgamma(n_f + 1.0) - libm::lgamma(k + 1.0) - libm::lgamma(n_f - k + 1.0);
        choose + k * log_p + (n_f - k) * log_q
    };
    let sum = |range: std::ops::Range<usize>| range.rev().map(|k| libm::exp(log_term(k))).sum::<f64>();
    // The smaller of both tails, so that what is left after subtraction is exact.
    let above = (count as f64) > n_f * p;
    let tail = if above { sum(count..n + 1) } else { 1.0 - sum(0..count) };
    tail.clamp(0.0, 1.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Abramowitz & Stegun style closed cases: one trial, all of two, and a sum by hand.
    #[test]
    fn the_binomial_tail_is_the_binomials() {
        assert!((at_least(1, 1, 0.3) - 0.3).abs() < 1e-12);
        assert!((at_least(2, 2, 0.3) - 0.09).abs() < 1e-12);
        assert!((at_least(1, 10, 0.1) - (1.0 - libm::pow(0.9, 10.0))).abs() < 1e-12);
        assert!((at_least(3, 5, 0.5) - 0.5).abs() < 1e-12);
        assert_eq!(at_least(0, 5, 0.5), 1.0);
        assert!(at_least(60, 1000, 0.0027) < 1e-20);
    }
}
