//! What may be spent.

use crate::AdviseError;
use serde::{Deserialize, Serialize};
use stratiform_quantities::Range;

/// The largest error, the largest cost, or both.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Budget {
    /// Relative, in (0, 1].
    pub max_error: Option<f64>,
    /// Nanoseconds for a pixel in f32 on one thread, above 0.
    pub max_ns: Option<f64>,
}

impl Budget {
    /// Checks the numbers.
    ///
    /// # Errors
    /// [`AdviseError::Domain`] outside of 0 < error ≤ 1 or 0 < ns ≤ 1e12; [`AdviseError::NoBudget`].
    pub fn new(max_error: Option<f64>, max_ns: Option<f64>) -> Result<Self, AdviseError> {
        let above_0 = |max| Range { min_included: false, ..Range::closed(0.0, max) };
        max_error.map_or(Ok(()), |error| above_0(1.0).check("max_error", error).map(|_| ()))?;
        max_ns.map_or(Ok(()), |ns| above_0(1e12).check("max_ns", ns).map(|_| ()))?;
        if max_error.is_none() && max_ns.is_none() {
            Err(AdviseError::NoBudget)
        } else {
            Ok(Self { max_error, max_ns })
        }
    }

    /// A share as people type it: `2%` or `0.02`.
    ///
    /// # Errors
    /// [`AdviseError::Share`].
    pub fn share(text: &str) -> Result<f64, AdviseError> {
        let refuse = || AdviseError::Share { text: text.to_owned() };
        let (number, scale) =
            text.trim().strip_suffix('%').map_or((text.trim(), 1.0), |number| (number, 0.01));
        number.trim().parse::<f64>().map(|value| scale * value).map_err(|_| refuse())
    }

    /// Whether an error is within it.
    pub(crate) fn allows_error(&self, error: f64) -> bool {
        self.max_error.is_none_or(|most| error <= most)
    }

    /// Whether a cost is.
    pub(crate) fn allows_ns(&self, ns: f64) -> bool {
        self.max_ns.is_none_or(|most| ns <= most)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nonsense_is_refused() {
        assert!(
            (Budget::share("2%").unwrap() - 0.02).abs() < 1e-15 && Budget::share(" 0.5 ").unwrap() == 0.5
        );
        assert!(Budget::share("two").is_err() && Budget::share("%").is_err());
        for error in [0.0, -0.1, 1.5, f64::NAN, f64::INFINITY] {
            assert!(Budget::new(Some(error), None).is_err(), "{error}");
        }
        for ns in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            assert!(Budget::new(None, Some(ns)).is_err(), "{ns}");
        }
        assert!(Budget::new(None, None).is_err() && Budget::new(Some(1.0), Some(30.0)).is_ok());
    }
}
