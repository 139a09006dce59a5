//! Kolmogorov–Smirnov: the largest distance between distribution functions, with the probability of a larger one.
//!
//! Both tests take the samples in any order. For the p-values and their accuracy see `kolmogorov.rs`. They hold for
//! continuous distributions. **Ties** within the two samples together are compared only after the last of equal values, which
//! gives the true sup|F_m - G_n|; its p-value is then at least the true probability, so false alarms are rarer than stated. A
//! one-sample test of values that were rounded coarser than 1/n of the distribution has no stated rate.

use crate::kolmogorov::{one_sample_tail, two_sample_tail};

/// Why samples cannot be compared.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum KolmogorovSmirnovError {
    /// Nothing was observed.
    #[error("an empty sample has no distribution: at least 1 value is needed")]
    Empty,
    /// A value is not a number.
    #[error("value {index} of the sample is not a number")]
    NotANumber {
        /// Its place, from 0.
        index: usize,
    },
    /// The expected distribution function is none.
    #[error("the distribution function is {value} at {at}, outside [0, 1] or below what it was before")]
    Distribution {
        /// Where.
        at: f64,
        /// Its value there.
        value: f64,
    },
}

/// The outcome of a Kolmogorov–Smirnov test.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct KolmogorovSmirnov {
    /// Largest distance of the distribution functions.
    pub statistic: f64,
    /// Probability of at least this distance if the distributions are the same. A test that fails when this is at most α
    /// raises a false alarm with probability at most α.
    pub p_value: f64,
}

/// Compares a sample with the continuous distribution function `cdf`, which no value of the sample has shaped.
///
/// # Errors
/// [`KolmogorovSmirnovError`] for an empty sample, a NaN, or a `cdf` that leaves \[0, 1\] or falls.
pub fn kolmogorov_smirnov(
    sample: &[f64],
    cdf: impl Fn(f64) -> f64,
) -> Result<KolmogorovSmirnov, KolmogorovSmirnovError> {
    let sorted = sorted(sample)?;
    let n = sorted.len();
    let (mut statistic, mut before) = (0.0_f64, 0.0);
    for (i, &x) in sorted.iter().enumerate() {
        let value = cdf(x);
        if !(value >= before && value <= 1.0) {
            return Err(KolmogorovSmirnovError::Distribution { at: x, value });
        }
        before = value;
        let [below, above] = [i, i + 1].map(|count| count as f64 / n as f64);
        statistic = statistic.max(value - below).max(above - value);
    }
    Ok(KolmogorovSmirnov { statistic, p_value: one_sample_tail(n, statistic) })
}

/// Compares two samples, of any sizes.
///
/// # Errors
/// [`KolmogorovSmirnovError`] for an empty sample or a NaN.
pub fn kolmogorov_smirnov_two_sample(
    a: &[f64],
    b: &[f64],
) -> Result<KolmogorovSmirnov, KolmogorovSmirnovError> {
    let (a, b) = (sorted(a)?, sorted(b)?);
    let (m, n) = (a.len(), b.len());
    let (mut i, mut j, mut steps) = (0, 0, 0);
    while i < m && j < n {
        let x = a[i].min(b[j]);
        i += a[i..].iter().take_while(|value| **value == x).count();
        j += b[j..].iter().take_while(|value| **value == x).count();
        steps = steps.max((i as u128 * n as u128).abs_diff(j as u128 * m as u128));
    }
    let statistic = steps as f64 / (m as f64 * n as f64);
    Ok(KolmogorovSmirnov { statistic, p_value: two_sample_tail(m, n, steps) })
}

fn sorted(sample: &[f64]) -> Result<Vec<f64>, KolmogorovSmirnovError> {
    if sample.is_empty() {
        return Err(KolmogorovSmirnovError::Empty);
    }
    if let Some(index) = sample.iter().position(|value| value.is_nan()) {
        return Err(KolmogorovSmirnovError::NotANumber { index });
    }
    let mut sorted = sample.to_vec();
    sorted.sort_unstable_by(f64::total_cmp);
    Ok(sorted)
}
