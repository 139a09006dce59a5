//! The error of the radius quadrature: asked for, and reached.

use crate::OpticsError;
use crate::phase::{PhaseFunction, PhaseTable};
use serde::{Deserialize, Serialize};
use stratiform_artifact::ReachedError;
use stratiform_quantities::{DomainError, Range};

/// What two successive refinements may differ by.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct QuadratureTolerance {
    /// Absolute, in g.
    pub asymmetry: f64,
    /// Absolute, in P_f.
    pub forward_fraction: f64,
    /// Absolute, in every Legendre moment compared.
    pub moments: f64,
    /// Relative, of P below 60°.
    pub phase_below_60_deg: f64,
    /// Relative, of P from 60° on.
    pub phase_beyond_60_deg: f64,
    /// Radii after which to give up.
    pub most_radii: u64,
}

impl Default for QuadratureTolerance {
    fn default() -> Self {
        Self {
            asymmetry: 1e-4,
            forward_fraction: 1e-4,
            moments: 1e-4,
            phase_below_60_deg: 3e-3,
            phase_beyond_60_deg: 1e-2,
            most_radii: 1 << 18,
        }
    }
}

impl QuadratureTolerance {
    /// Checks every number.
    ///
    /// # Errors
    /// [`DomainError`] naming the key that is out of domain.
    pub fn check(&self) -> Result<(), DomainError> {
        let range = Range::closed(1e-9, 1.0);
        range.check("tolerance.asymmetry", self.asymmetry)?;
        range.check("tolerance.forward_fraction", self.forward_fraction)?;
        range.check("tolerance.moments", self.moments)?;
        range.check("tolerance.phase_below_60_deg", self.phase_below_60_deg)?;
        range.check("tolerance.phase_beyond_60_deg", self.phase_beyond_60_deg)?;
        Range::closed(1024.0, 1e9).check("tolerance.most_radii", self.most_radii as f64)?;
        Ok(())
    }

    /// Whether `reached` is good enough.
    pub(super) fn met_by(&self, reached: &ReachedError) -> bool {
        reached.asymmetry <= self.asymmetry
            && reached.forward_fraction <= self.forward_fraction
            && reached.moments <= self.moments
            && reached.phase_below_60_deg <= self.phase_below_60_deg
            && reached.phase_beyond_60_deg <= self.phase_beyond_60_deg
    }
}

/// No error.
pub(super) const ZERO: ReachedError = ReachedError {
    radii: 0,
    asymmetry: 0.0,
    forward_fraction: 0.0,
    moments: 0.0,
    phase_below_60_deg: 0.0,
    phase_beyond_60_deg: 0.0,
};

/// What successive refinements are compared by.
pub(super) struct Summary {
    asymmetry: f64,
    pub(super) forward_fraction: f64,
    moments: Vec<f64>,
    theta_deg: Vec<f64>,
    p: Vec<f64>,
}

impl Summary {
    /// Moments compared: errors of the quadrature fall with l, because they are those of single orders' widths.
    const MOMENTS: usize = 128;

    pub(super) fn new(phase: &PhaseTable, asymmetry: f64, theta_f_deg: f64) -> Result<Self, OpticsError> {
        Ok(Self {
            asymmetry,
            forward_fraction: phase.forward_fraction(theta_f_deg)?,
            moments: phase.moments(Self::MOMENTS),
            theta_deg: phase.theta_deg().to_vec(),
            p: phase.values().to_vec(),
        })
    }

    /// The differences from `last`, whose own error was `before`. Two refinements may agree by chance: none counts as
    /// less than a quarter of the difference before.
    pub(super) fn error(&self, last: &Self, before: &ReachedError, radii: u64) -> ReachedError {
        let now = self.differences(last, radii);
        let guard = |now: f64, before: f64| now.max(0.25 * before);
        ReachedError {
            radii,
            asymmetry: guard(now.asymmetry, before.asymmetry),
            forward_fraction: guard(now.forward_fraction, before.forward_fraction),
            moments: guard(now.moments, before.moments),
            phase_below_60_deg: guard(now.phase_below_60_deg, before.phase_below_60_deg),
            phase_beyond_60_deg: guard(now.phase_beyond_60_deg, before.phase_beyond_60_deg),
        }
    }

    fn differences(&self, last: &Self, radii: u64) -> ReachedError {
        let moments = self.moments.iter().zip(&last.moments).map(|(a, b)| (a - b).abs());
        ReachedError {
            radii,
            asymmetry: (self.asymmetry - last.asymmetry).abs(),
            forward_fraction: (self.forward_fraction - last.forward_fraction).abs(),
            moments: moments.fold(0.0, f64::max),
            phase_below_60_deg: self.phase_error(last, |theta| theta < 60.0),
            phase_beyond_60_deg: self.phase_error(last, |theta| theta >= 60.0),
        }
    }

    /// The largest relative difference of P where `within` says.
    fn phase_error(&self, last: &Self, within: impl Fn(f64) -> bool) -> f64 {
        let pairs = self.p.iter().zip(&last.p).zip(&self.theta_deg);
        let errors = pairs.filter(|(_, theta)| within(**theta)).map(|((a, b), _)| (a / b - 1.0).abs());
        errors.fold(0.0, f64::max)
    }
}
