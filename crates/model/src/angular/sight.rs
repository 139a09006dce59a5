//! Where light comes from and where it goes.

use crate::Real;
use stratiform_quantities::{DomainError, Range, Side};

/// Sun and view of one radiance, in the precision of `F`.
///
/// v = 1 - cosΘ fixes the azimuth: cosΘ = sinθ_l sinθ_v cosφ - μ_l μ_v at the top, + μ_l μ_v at the bottom; φ = 0 where
/// light keeps the sun's azimuth. With unit vectors L and V that point away from the slab, v = ½|V + L|².
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sight<F> {
    /// Cosine of the sun's angle to the normal, in \[0, 1\].
    pub mu_l: F,
    /// Cosine of the leaving light's angle to the normal, in \[0, 1\].
    pub mu_v: F,
    /// 1 - cosΘ, in \[0, 2\].
    pub v: F,
    /// The face the light leaves.
    pub side: Side,
}

impl Sight<f64> {
    /// From cosines and azimuth, without cancellation near Θ = 0:
    /// v = ½((sinθ_l - sinθ_v)² + (μ_l ± μ_v)²) + 2 sinθ_l sinθ_v sin²(φ/2).
    ///
    /// # Errors
    /// [`DomainError`] unless 0 ≤ μ_l, μ_v ≤ 1 and |φ| ≤ 360°.
    pub fn new(mu_l: f64, mu_v: f64, phi_deg: f64, side: Side) -> Result<Self, DomainError> {
        let cosine = Range::closed(0.0, 1.0);
        cosine.check("mu_l", mu_l)?;
        cosine.check("mu_v", mu_v)?;
        Range::closed(-360.0, 360.0).check("phi_deg", phi_deg)?;
        let (sine_l, sine_v) = ((1.0 - mu_l * mu_l).sqrt(), (1.0 - mu_v * mu_v).sqrt());
        let along = if side == Side::Top { mu_l + mu_v } else { mu_l - mu_v };
        let across = sine_l - sine_v;
        let half = libm::sin(0.5 * phi_deg.to_radians());
        let v = 0.5 * (across * across + along * along) + 2.0 * sine_l * sine_v * half * half;
        Ok(Self { mu_l, mu_v, v: v.min(2.0), side })
    }

    /// The same in another precision.
    pub fn cast<F: Real>(&self) -> Sight<F> {
        Sight { mu_l: F::of(self.mu_l), mu_v: F::of(self.mu_v), v: F::of(self.v), side: self.side }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_glory_is_opposite_the_sun_and_the_aureole_around_it() {
        let glory = Sight::new(0.6, 0.6, 180.0, Side::Top).unwrap();
        let aureole = Sight::new(0.6, 0.6, 0.0, Side::Bottom).unwrap();
        assert!((glory.v - 2.0).abs() < 1e-15 && aureole.v == 0.0);
    }

    #[test]
    fn small_angles_keep_their_digits() {
        let theta = 1e-6_f64;
        let sight = Sight::new(1.0, libm::cos(theta), 0.0, Side::Bottom).unwrap();
        assert!((sight.v / (0.5 * theta * theta) - 1.0).abs() < 1e-3);
        assert!(Sight::new(1.1, 0.5, 0.0, Side::Top).is_err());
        assert!(Sight::new(f64::NAN, 0.5, 0.0, Side::Top).is_err());
    }
}
