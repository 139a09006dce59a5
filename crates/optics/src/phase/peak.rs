//! The forward peak cut off at θ_f (Bouthors, Neyret & Lefebvre 2006, section 4.1), and P*P on the sphere.
//!
//! P_f = ½∫_0^{θ_f} P sinΘ dΘ. P_S = P/(1-P_f) for Θ ≥ θ_f and 0 below (the paper prints the inequality the wrong
//! way round); P_F = P/P_f below θ_f and 0 from there on. The convolution of P with itself on the sphere has the
//! moments χ_l².

use super::linear::Moments;
use super::table::Norm;
use super::{PhaseTable, legendre};
use crate::OpticsError;
use stratiform_quantities::Range;

/// θ_f that leave something on both sides.
const THETA_F_DEG: Range = Range::open(0.0, 180.0);

impl PhaseTable {
    /// P_f, the probability of scattering by less than `theta_f_deg`.
    ///
    /// # Errors
    /// [`OpticsError::Domain`] unless 0 < `theta_f_deg` < 180.
    pub fn forward_fraction(&self, theta_f_deg: f64) -> Result<f64, OpticsError> {
        Ok(self.cumulative_at(THETA_F_DEG.check("theta_f_deg", theta_f_deg)?.to_radians()))
    }

    /// P_S.
    ///
    /// # Errors
    /// [`OpticsError::Domain`] for `theta_f_deg`; [`OpticsError::NotNormalised`] if nothing is left beyond it.
    pub fn modified(&self, theta_f_deg: f64) -> Result<Self, OpticsError> {
        self.cut(theta_f_deg, 0.0, 1.0)
    }

    /// P_F.
    ///
    /// # Errors
    /// [`OpticsError::Domain`] for `theta_f_deg`; [`OpticsError::NotNormalised`] if nothing is scattered below it.
    pub fn forward_part(&self, theta_f_deg: f64) -> Result<Self, OpticsError> {
        self.cut(theta_f_deg, 1.0, 0.0)
    }

    /// P times `below` for Θ < θ_f and times `beyond` from there on, normalised.
    fn cut(&self, theta_f_deg: f64, below: f64, beyond: f64) -> Result<Self, OpticsError> {
        let at = THETA_F_DEG.check("theta_f_deg", theta_f_deg)?;
        // A jump of the table at θ_f itself keeps its outer values.
        let left = self.left_limit(at);
        let right = self.at(at.to_radians());
        let rows = self.theta_deg().iter().copied().zip(self.values().iter().copied());
        let mut cut: Vec<(f64, f64)> =
            rows.clone().filter(|(t, _)| *t < at).map(|(t, p)| (t, below * p)).collect();
        cut.extend([(at, below * left), (at, beyond * right)]);
        cut.extend(rows.filter(|(t, _)| *t > at).map(|(t, p)| (t, beyond * p)));
        let (theta, p) = cut.into_iter().unzip();
        Self::new(theta, p, Norm::Any)
    }

    /// P just below `theta_deg`.
    fn left_limit(&self, theta_deg: f64) -> f64 {
        let first = self.theta_deg().iter().position(|t| *t == theta_deg);
        first.map_or_else(|| self.at(theta_deg.to_radians()), |i| self.values()[i])
    }

    /// P*P on the sphere, at the same nodes.
    ///
    /// # Errors
    /// [`OpticsError::NegativeSum`] if the truncated sum swings below zero, [`OpticsError::NotNormalised`] if the
    /// nodes cannot hold the result.
    pub fn squared(&self) -> Result<Self, OpticsError> {
        let squares: Vec<f64> = self.moments_to_square().iter().map(|chi| chi * chi).collect();
        // A jump of P is none of P*P, whose sum is the same on both sides.
        let theta: Vec<f64> = self.theta_rad().to_vec();
        let p = legendre::sum(&squares, &theta);
        let p = super::expand::not_negative(self.theta_deg(), p)?;
        Self::new(self.theta_deg().to_vec(), p, Norm::Any)
    }

    /// The moments whose squares matter: the rest of Σ(2l+1)χ_l² is below 1e-4 of the sum.
    pub(super) fn moments_to_square(&self) -> Vec<f64> {
        const MOST: usize = 1 << 13;
        let mut all = Moments::new(self);
        let mut count = 256;
        loop {
            let moments = all.first(count);
            let term = |l: usize| (2 * l + 1) as f64 * moments[l] * moments[l];
            let total = (0..count).fold(0.0, |sum, l| sum + term(l));
            let tail = (count - count / 4..count).fold(0.0, |sum, l| sum + term(l));
            if tail < 1e-4 * total || count >= MOST {
                return moments.to_vec();
            }
            count *= 2;
        }
    }
}
