//! The schema and its checks.

use crate::{Droplets, Effect, Interval, Layer, SceneError};
use serde::{Deserialize, Serialize};
use std::path::Path;
use stratiform_artifact::{key_line, line_of, read_text};
use stratiform_quantities::{DomainError, Range, Side};

/// The whole file.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Scene {
    /// `stratiform/scene/1`.
    pub schema: String,
    /// One line that says what is seen.
    pub title: String,
    /// λ of the channels, red first.
    pub wavelengths_um: Vec<f64>,
    /// What the picture shows.
    #[serde(default)]
    pub visible: Vec<Effect>,
    /// How thick the cloud is.
    pub layer: Layer,
    /// What it consists of.
    pub droplets: Droplets,
    /// Where the sun stands.
    pub sun: Sun,
    /// Where light goes.
    pub view: View,
    /// What lies below the cloud.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub ground: Option<Ground>,
}

/// `[ground]`.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Ground {
    /// Share of the light that it gives back, the same in all directions.
    pub albedo: f64,
}

/// `[sun]`.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Sun {
    /// Angle to the normal.
    pub theta_deg: Interval,
}

/// `[view]`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct View {
    /// Angle of the leaving light to the normal.
    pub theta_deg: Interval,
    /// Azimuth; at 0 light keeps the sun's.
    pub azimuth_deg: Interval,
    /// The faces that are seen: `top` from above, `bottom` from below.
    pub sides: Vec<Side>,
}

impl Scene {
    /// The schema's name and version.
    pub const SCHEMA: &'static str = "stratiform/scene/1";

    /// Reads and checks a file.
    ///
    /// # Errors
    /// [`SceneError`] with file and line.
    pub fn load(path: &Path) -> Result<Self, SceneError> {
        Self::parse(&read_text(path)?, &path.display().to_string())
    }

    /// Reads and checks a text; `origin` stands in messages.
    ///
    /// # Errors
    /// [`SceneError`] with `origin` and line.
    pub fn parse(text: &str, origin: &str) -> Result<Self, SceneError> {
        let scene: Self = toml::from_str(text).map_err(|error| {
            let line = error.span().map_or(1, |span| line_of(text, span.start));
            SceneError::Syntax { place: format!("{origin}:{line}"), message: error.message().to_owned() }
        })?;
        scene.check().map_err(|fault| fault.at(text, origin))?;
        Ok(scene)
    }

    fn check(&self) -> Result<(), Fault> {
        if self.schema != Self::SCHEMA {
            return Err(Fault::contents(
                "schema",
                format!("schema `{}` is not `{}`", self.schema, Self::SCHEMA),
            ));
        }
        self.check_layer()?;
        self.check_droplets()?;
        let below_horizon = Range { max_included: false, ..Range::closed(0.0, 90.0) };
        check_interval("sun.theta_deg", &self.sun.theta_deg, below_horizon)?;
        check_interval("view.theta_deg", &self.view.theta_deg, below_horizon)?;
        check_interval("view.azimuth_deg", &self.view.azimuth_deg, Range::closed(0.0, 180.0))?;
        for wavelength in &self.wavelengths_um {
            Range::closed(0.2, 4.0).check("wavelengths_um", *wavelength)?;
        }
        if let Some(ground) = &self.ground {
            Range::closed(0.0, 1.0).check("ground.albedo", ground.albedo)?;
        }
        listed_once("wavelengths_um", &self.wavelengths_um)?;
        listed_once("view.sides", &self.view.sides)?;
        if self.visible.is_empty() { Ok(()) } else { listed_once("visible", &self.visible) }
    }

    fn check_layer(&self) -> Result<(), Fault> {
        let Layer { optical_thickness, thickness_m, extinction_convention } = &self.layer;
        match (optical_thickness, thickness_m) {
            (Some(tau), None) => check_interval(
                "layer.optical_thickness",
                tau,
                Range { min_included: false, ..Range::closed(0.0, 1e4) },
            ),
            (None, Some(metres)) => {
                let missing = |key: &str| {
                    Fault::contents(
                        "layer.thickness_m",
                        format!("{key} is missing: a thickness in metres needs it"),
                    )
                };
                extinction_convention.ok_or_else(|| missing("layer.extinction_convention"))?;
                self.droplets
                    .number_density_per_cm3
                    .ok_or_else(|| missing("droplets.number_density_per_cm3"))?;
                check_interval(
                    "layer.thickness_m",
                    metres,
                    Range { min_included: false, ..Range::closed(0.0, 1e5) },
                )
            }
            _ => {
                let message = "layer needs one of optical_thickness and thickness_m, not both";
                Err(Fault::contents("layer.thickness_m", message.to_owned()))
            }
        }
    }

    fn check_droplets(&self) -> Result<(), Fault> {
        let droplets = &self.droplets;
        check_interval(
            "droplets.effective_radius_um",
            &droplets.effective_radius_um,
            Range::closed(0.1, 100.0),
        )?;
        // γ = 1/v_e - 2 must be positive.
        Range::open(0.0, 0.5).check("droplets.effective_variance", droplets.effective_variance)?;
        Range::open(0.0, 90.0).check("droplets.theta_f_deg", droplets.theta_f_deg)?;
        if let Some(number) = droplets.number_density_per_cm3 {
            Range::closed(1e-6, 1e9).check("droplets.number_density_per_cm3", number)?;
        }
        Ok(())
    }
}

/// What is wrong, and under which key.
enum Fault {
    Domain(DomainError),
    Inverted(String, Interval),
    Contents(String, String),
}

impl Fault {
    fn contents(key: &str, message: String) -> Self {
        Self::Contents(key.to_owned(), message)
    }

    fn at(self, text: &str, origin: &str) -> SceneError {
        let place = |key: &str| format!("{origin}:{}", key_line(text, key).unwrap_or(1));
        match self {
            Self::Domain(source) => SceneError::Domain { place: place(&source.quantity), source },
            Self::Inverted(key, Interval { min, max }) => {
                SceneError::Inverted { place: place(&key), key, min, max }
            }
            Self::Contents(key, message) => SceneError::Contents { place: place(&key), message },
        }
    }
}

impl From<DomainError> for Fault {
    fn from(error: DomainError) -> Self {
        Self::Domain(error)
    }
}

fn check_interval(key: &str, interval: &Interval, range: Range) -> Result<(), Fault> {
    range.check(&format!("{key}.min"), interval.min)?;
    range.check(&format!("{key}.max"), interval.max)?;
    if interval.max < interval.min { Err(Fault::Inverted(key.to_owned(), *interval)) } else { Ok(()) }
}

fn listed_once<T: PartialEq + std::fmt::Debug>(key: &str, list: &[T]) -> Result<(), Fault> {
    if list.is_empty() {
        return Err(Fault::contents(key, format!("{key} is empty: list at least one")));
    }
    match list.iter().enumerate().find(|(i, item)| list[..*i].contains(item)) {
        Some((_, item)) => Err(Fault::contents(key, format!("{key} lists {item:?} twice"))),
        None => Ok(()),
    }
}
