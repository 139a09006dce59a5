//! How a container stores numbers, and which it can hold.

use crate::set::SampledSet;
use half::f16;
use serde::{Deserialize, Serialize};
use stratiform_quantities::{DomainError, Range};

/// IEEE 754 binary formats.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Precision {
    /// 11 bits, up to 65504.
    F16,
    /// 24 bits.
    F32,
    /// 53 bits.
    F64,
}

impl Precision {
    /// The name in files.
    pub fn name(self) -> &'static str {
        match self {
            Self::F16 => "f16",
            Self::F32 => "f32",
            Self::F64 => "f64",
        }
    }

    /// `value` as it reads back.
    pub fn stored(self, value: f64) -> f64 {
        match self {
            Self::F16 => f16::from_f64(value).to_f64(),
            Self::F32 => f64::from(value as f32),
            Self::F64 => value,
        }
    }

    /// Finite values that do not round to infinity.
    fn range(self) -> Range {
        let most = match self {
            Self::F16 => 65504.0,
            Self::F32 => f64::from(f32::MAX),
            Self::F64 => f64::MAX,
        };
        Range::closed(-most, most)
    }

    /// `value`, if it can be held.
    ///
    /// # Errors
    /// [`DomainError`] naming `what` for NaN and for what would become infinite.
    pub fn check(self, what: &str, value: f64) -> Result<f64, DomainError> {
        self.range().check(&format!("{what} in {}", self.name()), value)
    }

    /// Checks every value of a set.
    ///
    /// # Errors
    /// [`DomainError`] naming function and channel.
    pub(super) fn check_set(self, set: &SampledSet) -> Result<(), DomainError> {
        for (function, row) in set.functions.iter().zip(&set.rows) {
            for (channel, sample) in set.channels.iter().zip(row) {
                let what = format!("p of {} at {}", function.name(), channel.name());
                for &value in &sample.values {
                    self.check(&what, value)?;
                }
            }
        }
        Ok(())
    }
}
