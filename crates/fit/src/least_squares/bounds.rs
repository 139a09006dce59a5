//! A box of allowed parameters.

use crate::FitError;
use stratiform_quantities::Range;

/// lower ≤ p ≤ upper, element by element; infinite where there is no bound.
#[derive(Clone, Debug, PartialEq)]
pub struct Bounds {
    lower: Vec<f64>,
    upper: Vec<f64>,
}

impl Bounds {
    /// No bounds on `n` parameters.
    pub fn none(n: usize) -> Self {
        Self { lower: vec![f64::NEG_INFINITY; n], upper: vec![f64::INFINITY; n] }
    }

    /// One closed interval per parameter; equal ends hold it fixed.
    ///
    /// # Errors
    /// [`FitError::Inconsistent`] where an interval is empty or NaN.
    pub fn new(intervals: &[[f64; 2]]) -> Result<Self, FitError> {
        for [lower, upper] in intervals {
            if lower.is_nan() || upper.is_nan() || lower > upper {
                return Err(FitError::Inconsistent(format!("the bounds [{lower}, {upper}] are empty")));
            }
        }
        let side = |k: usize| intervals.iter().map(|interval| interval[k]).collect();
        Ok(Self { lower: side(0), upper: side(1) })
    }

    /// Number of parameters.
    pub fn len(&self) -> usize {
        self.lower.len()
    }

    /// Whether there is no parameter at all.
    pub fn is_empty(&self) -> bool {
        self.lower.is_empty()
    }

    /// Refuses a start outside.
    pub(super) fn check(&self, start: &[f64]) -> Result<(), FitError> {
        FitError::check_length("the start", start.len(), self.len())?;
        for (i, &value) in start.iter().enumerate() {
            Range::closed(self.lower[i], self.upper[i]).check(&format!("start[{i}]"), value)?;
        }
        Ok(())
    }

    /// Whether `value` of parameter `i` sits on one of its bounds.
    pub fn holds(&self, i: usize, value: f64) -> bool {
        value <= self.lower[i] || value >= self.upper[i]
    }

    /// Whether descending along -`gradient` would leave the box at once.
    pub(super) fn blocks(&self, i: usize, value: f64, gradient: f64) -> bool {
        (value <= self.lower[i] && gradient >= 0.0) || (value >= self.upper[i] && gradient <= 0.0)
    }

    /// The bound between `value` and `value + step`, if any.
    pub(super) fn crossed(&self, i: usize, value: f64, step: f64) -> Option<f64> {
        if value + step < self.lower[i] {
            Some(self.lower[i])
        } else if value + step > self.upper[i] {
            Some(self.upper[i])
        } else {
            None
        }
    }
}
