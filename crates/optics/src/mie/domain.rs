//! The checked arguments of the Mie series.

use num_complex::Complex64;
use stratiform_quantities::{DomainError, Range};

/// x = 2πr/λ.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct SizeParameter(f64);

impl SizeParameter {
    /// The sizes the series is computed for.
    pub const RANGE: Range = Range::closed(1e-3, 1e5);

    /// Checks `x`.
    ///
    /// # Errors
    /// [`DomainError`] outside [`Self::RANGE`].
    pub fn new(x: f64) -> Result<Self, DomainError> {
        Self::RANGE.check("x", x).map(Self)
    }

    /// The number.
    pub const fn get(self) -> f64 {
        self.0
    }
}

/// m = n + ik of the sphere relative to its surroundings.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RefractiveIndex(Complex64);

impl RefractiveIndex {
    /// Real parts the series is computed for.
    pub const REAL: Range = Range::closed(0.01, 100.0);
    /// Imaginary parts, absorbing.
    pub const IMAGINARY: Range = Range::closed(0.0, 100.0);
    /// |m - 1|: nearer to 1 there is nothing to scatter and every digit cancels.
    pub const CONTRAST: Range = Range::at_least(1e-6);

    /// Checks n and k.
    ///
    /// # Errors
    /// [`DomainError`] outside [`Self::REAL`] and [`Self::IMAGINARY`], or if m is not told apart from 1.
    pub fn new(n: f64, k: f64) -> Result<Self, DomainError> {
        let m = Complex64::new(
            Self::REAL.check("n of m = n + ik", n)?,
            Self::IMAGINARY.check("k of m = n + ik", k)?,
        );
        Self::CONTRAST.check("|m - 1|", (m - 1.0).norm_sqr().sqrt())?;
        Ok(Self(m))
    }

    /// The number.
    pub const fn get(self) -> Complex64 {
        self.0
    }
}

/// Θ, kept as its cosine, which is exact at 0°, 90° and 180°.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ScatteringAngle {
    degrees: f64,
    cos: f64,
}

impl ScatteringAngle {
    /// Scattering angles.
    pub const RANGE_DEG: Range = Range::closed(0.0, 180.0);

    /// Checks an angle in degrees.
    ///
    /// # Errors
    /// [`DomainError`] outside \[0, 180\].
    pub fn from_degrees(theta: f64) -> Result<Self, DomainError> {
        let degrees = Self::RANGE_DEG.check("theta_deg", theta)?;
        let folded = if degrees > 90.0 { 180.0 - degrees } else { degrees };
        let cos = if folded == 90.0 { 0.0 } else { libm::cos(folded.to_radians()) };
        Ok(Self { degrees, cos: if degrees > 90.0 { -cos } else { cos } })
    }

    /// Θ in degrees, as given.
    pub const fn degrees(self) -> f64 {
        self.degrees
    }

    /// cosΘ.
    pub const fn cos(self) -> f64 {
        self.cos
    }
}
