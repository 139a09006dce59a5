//! `[fit]` of a fit-config: angles, thickness grid, bounds. Unknown keys are refused.

use crate::FitError;
use serde::{Deserialize, Serialize};
use stratiform_quantities::Range;

/// What is fitted, on which grid, within which bounds.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct FitConfig {
    /// Incidence angles in degrees, rising; the row of diffuse light is added to them.
    pub theta_l_deg: Vec<f64>,
    /// Thicknesses in metres at which model and reference are compared with equal weight.
    #[serde(default)]
    pub thickness_m: ThicknessGrid,
    /// One β is fitted to all angles up to this one; the rows beyond it, and the diffuse row, take it over.
    #[serde(default = "default_shared_beta_up_to_deg")]
    pub shared_beta_up_to_deg: f64,
    /// Allowed parameters.
    #[serde(default)]
    pub bounds: ParameterBounds,
}

/// Thicknesses in geometric progression.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct ThicknessGrid {
    /// Smallest, metres.
    pub min: f64,
    /// Largest, metres.
    pub max: f64,
    /// How many.
    pub count: usize,
}

/// \[lower, upper\] of each parameter, per unit of optical thickness of the full medium.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
#[expect(missing_docs, reason = "the names are those of the model")]
pub struct ParameterBounds {
    pub beta: [f64; 2],
    pub b: [f64; 2],
    pub c: [f64; 2],
    pub kappa_c: [f64; 2],
    pub t: [f64; 2],
    pub r: [f64; 2],
}

fn default_shared_beta_up_to_deg() -> f64 {
    80.0
}

impl Default for ThicknessGrid {
    fn default() -> Self {
        Self { min: 1.0, max: 1000.0, count: 20 }
    }
}

impl Default for ParameterBounds {
    fn default() -> Self {
        Self {
            beta: [0.01, 1.0],
            b: [1e-3, 5.0],
            c: [1e-4, 20.0],
            kappa_c: [1e-2, 20.0],
            t: [0.0, 1.0],
            r: [1e-6, 1.0],
        }
    }
}

impl ThicknessGrid {
    /// The thicknesses in metres, rising; the ends are exact.
    pub fn metres(&self) -> Vec<f64> {
        let last = self.count.saturating_sub(1).max(1);
        let step = libm::log(self.max / self.min) / last as f64;
        let inner = |i: usize| self.min * libm::exp(step * i as f64);
        (0..self.count)
            .map(|i| {
                if i == 0 {
                    self.min
                } else if i == last {
                    self.max
                } else {
                    inner(i)
                }
            })
            .collect()
    }

    fn check(&self) -> Result<(), FitError> {
        Range::closed(1e-6, 1e9).check("fit.thickness_m.min", self.min)?;
        let above = Range { min_included: false, ..Range::closed(self.min, 1e9) };
        above.check("fit.thickness_m.max", self.max)?;
        Range::closed(4.0, 1000.0).check("fit.thickness_m.count", self.count as f64)?;
        Ok(())
    }
}

impl ParameterBounds {
    fn check(&self) -> Result<(), FitError> {
        let unit = Range::closed(0.0, 1.0);
        let positive = |max| Range { min_included: false, ..Range::closed(0.0, max) };
        let all = [
            ("beta", self.beta, positive(1.0)),
            ("b", self.b, positive(100.0)),
            ("c", self.c, positive(1e3)),
            ("kappa_c", self.kappa_c, positive(1e3)),
            ("t", self.t, unit),
            ("r", self.r, positive(1.0)),
        ];
        for (name, [lower, upper], range) in all {
            let key = format!("fit.bounds.{name}");
            range.check(&key, lower)?;
            Range { min: lower, min_included: false, ..range }.check(&key, upper)?;
        }
        Ok(())
    }
}

impl FitConfig {
    /// Checks every number.
    ///
    /// # Errors
    /// [`FitError`] naming key, value and range.
    pub fn check(&self) -> Result<(), FitError> {
        self.thickness_m.check()?;
        self.bounds.check()?;
        Range::closed(0.0, 90.0).check("fit.shared_beta_up_to_deg", self.shared_beta_up_to_deg)?;
        let mut allowed = Range::closed(0.0, 90.0);
        for &angle in &self.theta_l_deg {
            allowed.check("fit.theta_l_deg", angle)?;
            allowed = Range { min: angle, min_included: false, ..allowed };
        }
        if self.theta_l_deg.first().is_none_or(|first| *first > self.shared_beta_up_to_deg) {
            let limit = self.shared_beta_up_to_deg;
            return Err(FitError::Inconsistent(format!(
                "fit.theta_l_deg has no angle up to shared_beta_up_to_deg = {limit}, so that nothing determines beta"
            )));
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn parse(text: &str) -> Result<FitConfig, String> {
        let config: FitConfig = serde_json::from_str(text).map_err(|error| error.to_string())?;
        config.check().map_err(|error| error.to_string())?;
        Ok(config)
    }

    #[test]
    fn defaults_are_those_documented() {
        let config = parse(r#"{"theta_l_deg": [0, 45, 90]}"#).unwrap();
        assert_eq!(config.shared_beta_up_to_deg, 80.0);
        let grid = config.thickness_m.metres();
        assert_eq!((grid.len(), grid[0], grid[19]), (20, 1.0, 1000.0));
        assert!(grid.windows(2).all(|pair| (pair[1] / pair[0] / grid[1] - 1.0).abs() < 1e-13));
    }

    #[test]
    fn bad_numbers_are_named_with_value_and_range() {
        for (text, message) in [
            (r#"{"theta_l_deg": [0, 91]}"#, "fit.theta_l_deg = 91 is outside (0, 90]"),
            (r#"{"theta_l_deg": [10, 10]}"#, "fit.theta_l_deg = 10 is outside (10, 90]"),
            (r#"{"theta_l_deg": [85]}"#, "no angle up to shared_beta_up_to_deg = 80"),
            (r#"{"theta_l_deg": []}"#, "no angle"),
            (r#"{"theta_l_deg": [0], "thickness_m": {"min": -1}}"#, "fit.thickness_m.min = -1 is outside"),
            (r#"{"theta_l_deg": [0], "thickness_m": {"max": 1}}"#, "fit.thickness_m.max = 1 is outside (1, "),
            (r#"{"theta_l_deg": [0], "thickness_m": {"count": 2}}"#, "count = 2 is outside [4, 1000]"),
            (r#"{"theta_l_deg": [0], "bounds": {"t": [0, 1.1]}}"#, "fit.bounds.t = 1.1 is outside (0, 1]"),
            (r#"{"theta_l_deg": [0], "bounds": {"tt": [0, 1]}}"#, "unknown field `tt`"),
            (r#"{"theta_l_deg": [0], "theta": 1}"#, "unknown field `theta`"),
        ] {
            let error = parse(text).unwrap_err();
            assert!(error.contains(message), "{text}: {error}");
        }
    }
}
