//! The fit-config: one TOML file from droplets to emitted text.
//!
//! Every section belongs to the crate that uses it. Unknown keys are refused. A number outside its domain is
//! reported with the line on which its key stands.

use crate::CliError;
use serde::{Deserialize, Serialize};
use std::path::Path;
use stratiform_artifact::{hash_of, read_text};
use stratiform_fit::{FitConfig, FitError, RegressionBounds};
use stratiform_optics::{OpticsConfig, OpticsError};
use stratiform_quantities::{DomainError, ExtinctionConvention, Medium, Range, SingleScatteringAlbedo};

/// The whole file.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Config {
    /// `stratiform/config/1`.
    pub schema: String,
    /// One line that says what cloud this is.
    pub title: String,
    /// Droplets, wavelengths, index, θ_f.
    pub optics: OpticsConfig,
    /// What is traced, and how long.
    pub transport: TransportConfig,
    /// Grid, bounds and angles of the fit.
    pub fit: FitConfig,
    /// Accepted artifacts and emitted text.
    pub codegen: CodegenConfig,
    /// How the convergence figure is made.
    pub convergence: ConvergenceConfig,
    /// Bounds of the regression test.
    pub regression: RegressionConfig,
}

/// `[transport]`.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct TransportConfig {
    /// Wavelength of the transport, one of `optics.wavelengths_um`.
    pub wavelength_um: f64,
    /// Which κ turns metres into optical thickness.
    pub extinction_convention: ExtinctionConvention,
    /// ω; absent: as Mie theory gives it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub single_scattering_albedo: Option<SingleScatteringAlbedo>,
    /// Medium of the totals that β, b and c are fitted to.
    pub totals_medium: Medium,
    /// Medium of the orders that κ_c, t and r are fitted to.
    pub orders_medium: Medium,
    /// Photons per incidence and medium.
    pub photons: u64,
    /// The same at the angles half-way between those of the fit, which tell the table's interpolation error.
    pub photons_between: u64,
    /// Seed of the random streams.
    pub seed: u64,
}

/// `[codegen]`: paths are relative to the config file.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct CodegenConfig {
    /// Folder with the accepted `parameters.json` and phase tables.
    pub accepted: String,
    /// Folder of the emitted text.
    pub output: String,
}

/// `[convergence]`.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ConvergenceConfig {
    /// Angle of the curve, degrees: one of `fit.theta_l_deg`, whose reference it is held against.
    pub theta_l_deg: f64,
    /// Thicknesses of the curve, metres: the nearest of the fit's grid are taken.
    pub thickness_m: Vec<f64>,
    /// Radii up to which the size average is refined for its own curve.
    pub most_radii: u64,
    /// Photons of each point, plain tracer.
    pub plain_photons: Vec<u64>,
    /// Photons of each point, half-space tracer.
    pub half_space_photons: Vec<u64>,
}

/// `[regression]`: a fresh run that the accepted table is held against.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RegressionConfig {
    /// Photons per incidence and medium of the fresh run.
    pub photons: u64,
    /// Seed of the fresh run; another than the transport's.
    pub seed: u64,
    /// Probability that a correct table fails.
    pub false_alarm_rate: f64,
    /// What is accepted.
    pub bounds: RegressionBounds,
}

impl Config {
    /// The schema's name and version.
    pub const SCHEMA: &'static str = "stratiform/config/1";

    /// Reads and checks a file.
    ///
    /// # Errors
    /// [`CliError::Input`] with file and line for anything unreadable, misspelt or out of domain.
    pub fn load(path: &Path) -> Result<Self, CliError> {
        let text = read_text(path)?;
        let config: Self = toml::from_str(&text).map_err(|error| {
            let line = error.span().map_or(1, |span| line_of(&text, span.start));
            CliError::Input(format!("{}:{line}: {}", path.display(), error.message()))
        })?;
        config.validate().map_err(|fault| {
            let line = fault.key.and_then(|key| key_line(&text, &key));
            let place = line.map_or(String::new(), |line| format!(":{line}"));
            CliError::Input(format!("{}{place}: {}", path.display(), fault.message))
        })?;
        if config.schema != Self::SCHEMA {
            let message = format!("schema `{}` is not `{}`", config.schema, Self::SCHEMA);
            return Err(CliError::Input(message).at(&format!(
                "{}:{}",
                path.display(),
                key_line(&text, "schema").unwrap_or(1)
            )));
        }
        Ok(config)
    }

    /// Hash of every setting.
    pub fn hash(&self) -> String {
        hash_of(self)
    }

    fn validate(&self) -> Result<(), Fault> {
        self.optics.resolve()?;
        self.fit.check()?;
        let counts = Range::closed(1.0, 9_007_199_254_740_992.0);
        let count = |name: &str, value: u64| counts.check(name, value as f64).map(|_| ());
        count("photons", self.transport.photons)?;
        count("photons_between", self.transport.photons_between)?;
        count("photons", self.regression.photons)?;
        self.convergence.plain_photons.iter().try_for_each(|n| count("plain_photons", *n))?;
        self.convergence.half_space_photons.iter().try_for_each(|n| count("half_space_photons", *n))?;
        self.convergence
            .thickness_m
            .iter()
            .try_for_each(|h| Range::above(0.0).check("convergence.thickness_m", *h).map(|_| ()))?;
        Range::closed(64.0, 1e6).check("most_radii", self.convergence.most_radii as f64)?;
        Range::closed(0.0, 90.0).check("theta_l_deg", self.convergence.theta_l_deg)?;
        Range::open(0.0, 1.0).check("false_alarm_rate", self.regression.false_alarm_rate)?;
        self.regression.bounds.check()?;
        if !self.optics.wavelengths_um.contains(&self.transport.wavelength_um) {
            let nearest = self.optics.wavelengths_um.first().copied().unwrap_or(0.0);
            let range = Range::closed(nearest, nearest);
            range.check("wavelength_um", self.transport.wavelength_um)?;
        }
        Ok(())
    }
}

/// What is wrong with a value, and under which key it stands, where that is known.
struct Fault {
    key: Option<String>,
    message: String,
}

impl From<DomainError> for Fault {
    fn from(error: DomainError) -> Self {
        Self { message: error.to_string(), key: Some(error.quantity) }
    }
}

impl From<OpticsError> for Fault {
    fn from(error: OpticsError) -> Self {
        match error {
            OpticsError::Domain(error) => error.into(),
            other => Self { key: None, message: other.to_string() },
        }
    }
}

impl From<FitError> for Fault {
    fn from(error: FitError) -> Self {
        match error {
            FitError::Domain(error) => error.into(),
            other => Self { key: None, message: other.to_string() },
        }
    }
}

fn line_of(text: &str, offset: usize) -> usize {
    text.as_bytes().iter().take(offset).filter(|byte| **byte == b'\n').count() + 1
}

/// The first line that assigns `key` (a dotted quantity's last part).
fn key_line(text: &str, key: &str) -> Option<usize> {
    let key = key.rsplit('.').next().unwrap_or(key);
    text.lines()
        .position(|line| {
            line.trim_start().strip_prefix(key).is_some_and(|rest| rest.trim_start().starts_with('='))
        })
        .map(|index| index + 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_are_counted_from_one() {
        let text = "a = 1\n[b]\n  photons = 0\n";
        assert_eq!(key_line(text, "photons"), Some(3));
        assert_eq!(key_line(text, "transport.photons"), Some(3));
        assert_eq!(key_line(text, "photon"), None);
        assert_eq!(line_of(text, 7), 2);
    }
}
