//! The two number types of the model: f64 for fitting, f32 as the shaders' twin.

use std::fmt::Debug;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// A floating-point number with the three functions that the model needs. Both types call `libm`, so that the
/// bits are the same on every machine.
pub trait Real:
    Copy
    + Debug
    + PartialOrd
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// Terms of the series of e^y - 1 - y that reach full precision for |y| ≤ 1.
    const TAIL_TERMS: u32;
    /// Terms of the series of E_1 that reach full precision for x ≤ 1.
    const E1_TERMS: u32;
    /// Depth of the continued fraction of E_3 that reaches full precision for x ≥ 1.
    const E3_DEPTH: u32;
    /// The nearest number to `value`.
    fn of(value: f64) -> Self;
    /// The same number in double precision.
    fn to_f64(self) -> f64;
    /// e^self.
    fn exp(self) -> Self;
    /// Natural logarithm.
    fn ln(self) -> Self;
}

impl Real for f64 {
    const TAIL_TERMS: u32 = 17;
    const E1_TERMS: u32 = 18;
    const E3_DEPTH: u32 = 100;

    fn of(value: f64) -> Self {
        value
    }

    fn to_f64(self) -> f64 {
        self
    }

    fn exp(self) -> Self {
        libm::exp(self)
    }

    fn ln(self) -> Self {
        libm::log(self)
    }
}

impl Real for f32 {
    const TAIL_TERMS: u32 = 9;
    const E1_TERMS: u32 = 10;
    const E3_DEPTH: u32 = 24;

    #[expect(clippy::cast_possible_truncation, reason = "rounding to single precision is what is asked for")]
    fn of(value: f64) -> Self {
        value as f32
    }

    fn to_f64(self) -> f64 {
        f64::from(self)
    }

    fn exp(self) -> Self {
        libm::expf(self)
    }

    fn ln(self) -> Self {
        libm::logf(self)
    }
}
