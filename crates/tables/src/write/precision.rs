//! How a container stores numbers, and which it can hold.

use crate::set::SampledSet;
use half::f16;
use serde::{Deserialize, Serialize};
use stratiform_quantities::{DomainError, Range};

/// The f16 nearest to `value`, ties to even. The crate's own conversion rounds to f32 first where the processor has the
/// instruction, so that its bits depend on the machine.
pub(super) fn half(value: f64) -> f16 {
    const SMALLEST_NORMAL: i32 = -14;
    if value == 0.0 || !value.is_finite() {
        return f16::from_f64(value);
    }
    let step = libm::ldexp(1.0, libm::ilogb(value).max(SMALLEST_NORMAL) - 10);
    f16::from_f64(libm::rint(value / step) * step)
}

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
            Self::F16 => half(value).to_f64(),
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

#[cfg(test)]
mod tests {
    use super::*;

    /// Every finite f16 is its own nearest; between neighbours the middle goes to the even one, and a hair beside the
    /// middle (lost if rounded to f32 first) to the nearer one.
    #[test]
    fn halves_are_rounded_once() {
        for bits in 0..0x7BFF_u16 {
            let (below, above) = (f16::from_bits(bits), f16::from_bits(bits + 1));
            assert_eq!(half(below.to_f64()).to_bits(), bits);
            let middle = 0.5 * (below.to_f64() + above.to_f64());
            assert_eq!(half(middle).to_bits(), bits + (bits & 1));
            assert_eq!(half(middle * (1.0 + 1e-12)).to_bits(), bits + 1);
            assert_eq!(half(middle * (1.0 - 1e-12)).to_bits(), bits);
        }
    }
}
