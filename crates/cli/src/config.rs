//! The fit-config: one TOML file from droplets to emitted text.
//!
//! Every section belongs to the crate that uses it. Unknown keys are refused. A number outside its domain is
//! reported with the line on which its key stands.
//!
//! **Source.** `transport.source` says what the model is fitted to: `solve`, the deterministic solver, or `trace`,
//! photons. The objective is the same. `solve` is the default: its fluxes have no noise, their error is estimated and far
//! below what photons reach in the same seconds (`convergence.csv`), so that the table does not depend on a seed and a
//! difference between two tables is a difference of media. What it gives up is independence (solver and model share no
//! code, but a fault of the solver would pass into the table); hence with `photons` given the table's incidences are also
//! traced, and both tables must agree.

mod colour;
mod family;

pub use colour::ColourConfig;
pub use family::FamilyConfig;

use crate::CliError;
use crate::check::config::{CheckConfig, Refused};
use serde::{Deserialize, Serialize};
use std::f64::consts::PI;
use std::path::Path;
use stratiform_artifact::{key_line, line_of, read_text};
use stratiform_codegen::Target;
use stratiform_fit::{FitConfig, FitError, RadianceConfig};
use stratiform_optics::{OpticsConfig, OpticsError};
use stratiform_quantities::{
    DomainError, ExtinctionConvention, Medium, OpticalThickness, Range, SingleScatteringAlbedo,
};

/// The whole file.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Config {
    /// `stratiform/config/1`.
    pub schema: String,
    /// One line that says what cloud this is.
    pub title: String,
    /// The published table that the result is printed and drawn beside: only for the cloud it was made for.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub published_table: Option<PublishedTable>,
    /// Droplets, wavelengths, index, θ_f.
    pub optics: OpticsConfig,
    /// Wavelengths of the phase functions in colour.
    #[serde(default)]
    pub colour: ColourConfig,
    /// What is traced, and how long.
    pub transport: TransportConfig,
    /// Grid, bounds and angles of the fit.
    pub fit: FitConfig,
    /// Points that the radiance model is fitted at; absent: it is not fitted.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub radiance: Option<RadianceConfig>,
    /// Accepted artifacts and emitted text.
    pub codegen: CodegenConfig,
    /// Other effective radii that get a table too; absent: none.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub family: Option<FamilyConfig>,
    /// How the convergence figures are made; absent: they are not.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub convergence: Option<ConvergenceConfig>,
    /// How the figures of radiance in the principal plane are made; absent: they are not.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub principal_plane: Option<PrincipalPlaneConfig>,
    /// What `check` accepts.
    pub check: CheckConfig,
}

/// Tables that others published.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum PublishedTable {
    /// Appendix B of Bouthors, Neyret & Lefebvre 2006.
    #[serde(rename = "bouthors-2006")]
    Bouthors2006,
}

/// What computes the fluxes that the model is fitted to.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Source {
    /// Half-space photon tracer.
    Trace,
    /// Discrete ordinates.
    #[default]
    Solve,
}

/// Estimated error of solved fluxes where the config does not say.
const TOLERANCE: f64 = 1e-6;

fn default_tolerance() -> f64 {
    TOLERANCE
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
    /// What the model is fitted to.
    #[serde(default)]
    pub source: Source,
    /// Largest estimated error of a solved flux, absolute.
    #[serde(default = "default_tolerance")]
    pub tolerance: f64,
    /// Photons per incidence of the table and medium. Needed by `trace`; with `solve` they are the witness.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub photons: Option<u64>,
    /// The same at the angles half-way between those of the fit, which tell the table's interpolation error. Needed by
    /// `trace`; `solve` traces nothing there.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub photons_between: Option<u64>,
    /// Seed of the random streams; needed where there are photons.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub seed: Option<u64>,
}

/// `[codegen]`: paths are relative to the config file.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct CodegenConfig {
    /// Folder with the accepted `parameters.json` and phase tables.
    pub accepted: String,
    /// Folder of the emitted text.
    pub output: String,
    /// Languages to emit: wgsl, glsl-450, glsl-330, glsl-300es, hlsl, msl, c, rust, spirv. Default: all.
    #[serde(default = "all_targets")]
    pub targets: Vec<Target>,
}

impl CodegenConfig {
    fn validate(&self) -> Result<(), Fault> {
        let twice = |(i, target): (usize, &Target)| self.targets[..i].contains(target);
        let message = if self.targets.is_empty() {
            "targets is empty: name at least one language, or leave the key out for all"
        } else if self.targets.iter().enumerate().any(twice) {
            "targets names a language twice"
        } else {
            return Ok(());
        };
        Err(Fault { key: Some("codegen.targets".to_owned()), message: message.to_owned() })
    }
}

fn all_targets() -> Vec<Target> {
    Target::ALL.to_vec()
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

/// `[principal_plane]`.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PrincipalPlaneConfig {
    /// Slabs and suns.
    pub scenes: Vec<PlaneScene>,
    /// Photons of each scene in the full medium, counted in angular bins.
    pub full_photons: u64,
    /// Photons of each scene for local estimates.
    pub view_photons: u64,
}

/// A slab and its sun.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PlaneScene {
    /// The sun's zenith angle, degrees, below 90.
    pub theta_l_deg: f64,
    /// Thickness, metres.
    pub thickness_m: f64,
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
        let mut config: Self = toml::from_str(&text).map_err(|error| {
            let line = error.span().map_or(1, |span| line_of(&text, span.start));
            CliError::Input(format!("{}:{line}: {}", path.display(), error.message()))
        })?;
        config.optics.droplets = config.optics.droplets.relative_to(path.parent().unwrap_or(Path::new("")));
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

    /// Checks every number again, after settings were overridden.
    ///
    /// # Errors
    /// [`CliError::Input`] naming value and range.
    pub fn check_again(&self) -> Result<(), CliError> {
        self.validate().map_err(|fault| CliError::Input(fault.message))
    }

    fn validate(&self) -> Result<(), Fault> {
        self.optics.resolve()?;
        self.colour.validate(&self.optics)?;
        self.fit.check()?;
        self.radiance.iter().try_for_each(RadianceConfig::check)?;
        self.transport.validate(&self.optics)?;
        self.convergence.iter().try_for_each(|convergence| convergence.validate(&self.fit))?;
        self.principal_plane.iter().try_for_each(PrincipalPlaneConfig::validate)?;
        self.family.iter().try_for_each(|family| family.validate(&self.optics, &self.transport))?;
        self.check.validate()?;
        self.codegen.validate()?;
        let kappa = 1e6
            * self.optics.number_density_per_cm3
            * PI
            * squared(self.optics.resolve()?.effective_radius() * 1e-6);
        let tallest = Range::closed(0.0, OpticalThickness::RANGE.max / kappa);
        tallest.check("fit.thickness_m.max", self.fit.thickness_m.max)?;
        Ok(())
    }

    /// Whether the fit's angles span what emitted code must cover.
    ///
    /// # Errors
    /// [`CliError::Input`] unless they run from 0 to 90.
    pub fn check_span(&self) -> Result<(), CliError> {
        match self.fit.theta_l_deg[..] {
            [0.0, .., 90.0] => Ok(()),
            _ => Err(CliError::Input(format!(
                "fit.theta_l_deg = {:?} does not run from 0 to 90, which the emitted code must cover",
                self.fit.theta_l_deg
            ))),
        }
    }
}

fn squared(x: f64) -> f64 {
    x * x
}

/// As many photons as a tracer takes.
fn photons(key: &str, count: u64) -> Result<(), DomainError> {
    stratiform_transport::PHOTONS.check(key, count as f64).map(|_| ())
}

impl TransportConfig {
    fn validate(&self, optics: &OpticsConfig) -> Result<(), Fault> {
        self.photons.iter().try_for_each(|n| photons("transport.photons", *n))?;
        self.photons_between.iter().try_for_each(|n| photons("transport.photons_between", *n))?;
        // As the solver allows, said with the key's line.
        let tolerances = Range { max_included: false, ..Range::closed(1e-12, 1.0) };
        tolerances.check("transport.tolerance", self.tolerance)?;
        self.validate_presence()?;
        if optics.wavelengths_um.contains(&self.wavelength_um) {
            return Ok(());
        }
        let message = format!(
            "transport.wavelength_um = {} is none of optics.wavelengths_um = {:?}",
            self.wavelength_um, optics.wavelengths_um
        );
        Err(Fault { key: Some("transport.wavelength_um".to_owned()), message })
    }

    /// Keys that others need: `trace` all that photons need, photons a seed.
    fn validate_presence(&self) -> Result<(), Fault> {
        match (self.source, self.photons, self.seed) {
            (Source::Trace, _, _) => self.tracing().map(|_| ()),
            (Source::Solve, Some(_), None) => Err(missing("seed", "photons", "photons")),
            (Source::Solve, _, _) => Ok(()),
        }
    }

    /// Photons at the table's incidences and half-way, and the seed.
    fn tracing(&self) -> Result<[u64; 3], Fault> {
        let key =
            |name, value: Option<u64>| value.ok_or_else(|| missing(name, "source = \"trace\"", "source"));
        let photons = key("photons", self.photons)?;
        Ok([photons, key("photons_between", self.photons_between)?, key("seed", self.seed)?])
    }

    /// What `source = "trace"` needs: photons at the table's incidences and half-way, and the seed.
    ///
    /// # Errors
    /// [`CliError::Input`] naming the key that is missing.
    pub fn photons_and_seed_of_trace(&self) -> Result<[u64; 3], CliError> {
        self.tracing().map_err(|fault| CliError::Input(fault.message))
    }

    /// The section without what the fluxes of `source` do not depend on.
    #[must_use]
    pub fn that_counts(&self, source: Source) -> Self {
        match source {
            Source::Trace => Self { source, tolerance: TOLERANCE, ..self.clone() },
            Source::Solve => {
                Self { source, photons: None, photons_between: None, seed: None, ..self.clone() }
            }
        }
    }
}

fn missing(key: &str, needed_by: &str, place: &str) -> Fault {
    let message = format!("transport.{key} is missing: {needed_by} needs it");
    Fault { key: Some(format!("transport.{place}")), message }
}

impl ConvergenceConfig {
    fn validate(&self, fit: &FitConfig) -> Result<(), Fault> {
        self.plain_photons.iter().try_for_each(|n| photons("convergence.plain_photons", *n))?;
        self.half_space_photons.iter().try_for_each(|n| photons("convergence.half_space_photons", *n))?;
        let heights = Range::above(0.0);
        self.thickness_m.iter().try_for_each(|h| heights.check("convergence.thickness_m", *h).map(|_| ()))?;
        Range::closed(64.0, 1e6).check("convergence.most_radii", self.most_radii as f64)?;
        if fit.theta_l_deg.contains(&self.theta_l_deg) {
            return Ok(());
        }
        let message = format!(
            "convergence.theta_l_deg = {} is none of fit.theta_l_deg = {:?}",
            self.theta_l_deg, fit.theta_l_deg
        );
        Err(Fault { key: Some("convergence.theta_l_deg".to_owned()), message })
    }
}

impl PrincipalPlaneConfig {
    fn validate(&self) -> Result<(), Fault> {
        photons("principal_plane.full_photons", self.full_photons)?;
        photons("principal_plane.view_photons", self.view_photons)?;
        let below_horizon = Range { max_included: false, ..Range::closed(0.0, 90.0) };
        for scene in &self.scenes {
            below_horizon.check("principal_plane.scenes.theta_l_deg", scene.theta_l_deg)?;
            Range::above(0.0).check("principal_plane.scenes.thickness_m", scene.thickness_m)?;
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

impl From<Refused> for Fault {
    fn from(refused: Refused) -> Self {
        Self { key: Some(refused.key), message: refused.message }
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
