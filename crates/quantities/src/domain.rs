//! The one error for a number outside its domain.

use std::fmt;

/// The set of values a quantity may have, for checks and for messages.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Range {
    /// Smallest value.
    pub min: f64,
    /// Largest value; infinity where there is none.
    pub max: f64,
    /// Whether `min` itself belongs to the range.
    pub min_included: bool,
    /// Whether `max` itself belongs to the range.
    pub max_included: bool,
}

impl Range {
    /// \[min, max\].
    pub const fn closed(min: f64, max: f64) -> Self {
        Self { min, max, min_included: true, max_included: true }
    }

    /// (min, max).
    pub const fn open(min: f64, max: f64) -> Self {
        Self { min, max, min_included: false, max_included: false }
    }

    /// \[min, ∞).
    pub const fn at_least(min: f64) -> Self {
        Self { min, max: f64::INFINITY, min_included: true, max_included: false }
    }

    /// (min, ∞).
    pub const fn above(min: f64) -> Self {
        Self { min, max: f64::INFINITY, min_included: false, max_included: false }
    }

    /// Whether `value` is finite and inside.
    pub fn contains(&self, value: f64) -> bool {
        let above = if self.min_included { value >= self.min } else { value > self.min };
        let below = if self.max_included { value <= self.max } else { value < self.max };
        value.is_finite() && above && below
    }

    /// Returns `value` if it is inside, otherwise an error that names `quantity`.
    ///
    /// # Errors
    /// [`DomainError`] if `value` is not finite or lies outside.
    pub fn check(&self, quantity: &str, value: f64) -> Result<f64, DomainError> {
        if self.contains(value) {
            Ok(value)
        } else {
            Err(DomainError { quantity: quantity.to_owned(), value, range: *self })
        }
    }
}

impl fmt::Display for Range {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let open = if self.min_included { '[' } else { '(' };
        if self.max.is_infinite() {
            return write!(f, "{open}{}, infinity)", self.min);
        }
        let close = if self.max_included { ']' } else { ')' };
        write!(f, "{open}{}, {}{close}", self.min, self.max)
    }
}

/// A number outside the domain of the quantity it stands for.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("{quantity} = {value} is outside {range}")]
pub struct DomainError {
    /// The quantity's name, in the words of the user's input.
    pub quantity: String,
    /// The value that was refused.
    pub value: f64,
    /// The values that are allowed.
    pub range: Range,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bounds_are_as_written() {
        assert!(Range::closed(0.0, 1.0).contains(0.0) && Range::closed(0.0, 1.0).contains(1.0));
        assert!(!Range::open(0.0, 1.0).contains(0.0) && !Range::open(0.0, 1.0).contains(1.0));
        assert!(Range::at_least(0.0).contains(1e300) && !Range::at_least(0.0).contains(f64::INFINITY));
        assert!(!Range::above(0.0).contains(0.0));
        assert!(!Range::closed(0.0, 1.0).contains(f64::NAN));
    }

    #[test]
    fn the_message_names_quantity_value_and_range() {
        let error = Range::closed(0.0, 1.0).check("omega", 1.5).unwrap_err();
        assert_eq!(error.to_string(), "omega = 1.5 is outside [0, 1]");
        let error = Range::above(0.0).check("r_eff_um", -2.0).unwrap_err();
        assert_eq!(error.to_string(), "r_eff_um = -2 is outside (0, infinity)");
    }
}
