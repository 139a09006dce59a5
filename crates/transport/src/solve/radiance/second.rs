//! Order 2 between a sun and a view: rules fine enough for every thickness, and the errors that they leave.

use super::double::{POINTS, Pairing};
use super::phase::Phase;
use super::scaled::Scaled;
use super::view::Geometry;
use crate::TransportError;
use stratiform_stats::Estimate;

/// Share of the tolerance that the angular rule should take.
const SHARE: f64 = 0.4;

/// Three rules, each finer than the one before.
#[derive(Clone)]
pub(super) struct Rules([Pairing; 3]);

impl Rules {
    /// Rules that agree to a share of the tolerance, or the finest if they meet the tolerance itself; with order 2 at
    /// every thickness.
    ///
    /// # Errors
    /// [`TransportError::Rule`] if the finest do not.
    pub(super) fn new(
        medium: &Scaled,
        phase: &Phase,
        tau: &[f64],
        geometry: &Geometry,
        tolerance: f64,
    ) -> Result<(Self, Vec<Estimate>), TransportError> {
        let rule = |points| Pairing::new(phase, geometry, points);
        let twice = |rules: &Self| -> (Vec<Estimate>, f64) {
            let each: Vec<Estimate> =
                tau.iter().map(|tau| rules.twice(medium, phase, *tau, geometry)).collect();
            let worst = each.iter().fold(0.0_f64, |worst, estimate| worst.max(excess(estimate)));
            (each, worst)
        };
        let mut rules = Self([POINTS[0], POINTS[1], POINTS[2]].map(rule));
        let (mut each, mut worst) = twice(&rules);
        for points in &POINTS[3..] {
            if worst <= SHARE * tolerance {
                break;
            }
            let Self([_, coarse, middle]) = rules;
            rules = Self([coarse, middle, rule(*points)]);
            (each, worst) = twice(&rules);
        }
        if worst > tolerance {
            return Err(TransportError::Rule { wanted: tolerance, reached: worst });
        }
        Ok((rules, each))
    }

    /// By the finest rule; no error.
    pub(super) fn finest(&self, medium: &Scaled, phase: &Phase, tau: f64, geometry: &Geometry) -> Estimate {
        Estimate { value: self.0[2].twice(medium, phase, tau, geometry), std_error: 0.0 }
    }

    /// By the finest rule with its error: four times the last step, or the one before lest two rules agree by chance.
    pub(super) fn twice(&self, medium: &Scaled, phase: &Phase, tau: f64, geometry: &Geometry) -> Estimate {
        let [coarse, middle, fine] = [0, 1, 2].map(|i| self.0[i].twice(medium, phase, tau, geometry));
        let step = (fine - middle).abs().max(0.25 * (middle - coarse).abs());
        Estimate { value: fine, std_error: 4.0 * step + f64::EPSILON * fine.abs() }
    }
}

/// Error in units of the tolerance's scale: absolute below 1, relative above.
pub(super) fn excess(estimate: &Estimate) -> f64 {
    let excess = estimate.std_error / estimate.value.abs().max(1.0);
    if excess.is_finite() { excess } else { f64::INFINITY }
}
