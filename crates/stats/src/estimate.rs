//! A mean and its standard error: the only form in which a sampled number leaves the tracer.

use serde::{Deserialize, Serialize};

/// A value with its standard error (of the mean, not of one sample).
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Estimate {
    /// The mean.
    pub value: f64,
    /// The standard error of the mean.
    pub std_error: f64,
}

impl Estimate {
    /// `hits` out of `trials`: value k/n, standard error √(p̃(1-p̃)/(n+3)) with p̃ = (k+1)/(n+2).
    ///
    /// The error is the standard deviation of the uniform prior's posterior. It tends to √(p(1-p)/n), and
    /// stays above 1/(n+3) where no trial, or every trial, hit: a rare event is not reported as certain.
    /// `trials` = 0 gives value 0 and the prior's own deviation.
    pub fn from_hits(hits: u64, trials: u64) -> Self {
        let (k, n) = (hits as f64, trials as f64);
        let p = (k + 1.0) / (n + 2.0);
        let value = if trials == 0 { 0.0 } else { k / n };
        Self { value, std_error: (p * (1.0 - p) / (n + 3.0)).sqrt() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn hits_tend_to_the_binomial_error() {
        let e = Estimate::from_hits(250_000, 1_000_000);
        assert_eq!(e.value, 0.25);
        assert!((e.std_error - (0.25_f64 * 0.75 / 1e6).sqrt()).abs() < 1e-8);
    }

    #[test]
    fn no_hit_is_not_certainty() {
        for hits in [0, 1_000_000] {
            let e = Estimate::from_hits(hits, 1_000_000);
            assert!(e.std_error > 0.9e-6 && e.std_error < 1.1e-6, "{e:?}");
        }
    }
}
