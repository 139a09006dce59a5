//! The schema, and how a file becomes a scene.

use crate::fault::Fault;
use crate::{Camera, Clouds, Droplets, Effect, Ground, Interval, Layer, Picture, Radiosity, SceneError, Sky};
use crate::{Sun, check, check_picture};
use serde::de::IgnoredAny;
use serde::{Deserialize, Serialize};
use std::path::Path;
use stratiform_artifact::{line_of, read_text};
use stratiform_quantities::{ExtinctionConvention, Side};

/// The whole file. With a camera and clouds it is a picture too.
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
    /// How thick the cloud is; a picture may leave it to its clouds.
    #[serde(default)]
    pub layer: Layer,
    /// What it consists of.
    pub droplets: Droplets,
    /// Where the sun stands.
    pub sun: Sun,
    /// Where light goes; a picture may leave it to its camera.
    #[serde(default)]
    pub view: View,
    /// What lies below the cloud.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub ground: Option<Ground>,
    /// Where the picture is seen from.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub camera: Option<Camera>,
    /// Its clouds.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub clouds: Option<Clouds>,
    /// Light from above other than the sun's.
    #[serde(default)]
    pub sky: Sky,
    /// How radiance becomes a picture.
    #[serde(default)]
    pub picture: Picture,
    /// Light between ground and cloud.
    #[serde(default)]
    pub radiosity: Radiosity,
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

impl Default for View {
    /// Of nothing: what stands there until the camera says.
    fn default() -> Self {
        Self { theta_deg: Interval::at(0.0), azimuth_deg: Interval::at(0.0), sides: Vec::new() }
    }
}

/// Which tables stand in the file.
#[derive(Deserialize)]
struct Written {
    layer: Option<IgnoredAny>,
    view: Option<IgnoredAny>,
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
        let syntax = |error: toml::de::Error| {
            let line = error.span().map_or(1, |span| line_of(text, span.start));
            SceneError::Syntax { place: format!("{origin}:{line}"), message: error.message().to_owned() }
        };
        let mut scene: Self = toml::from_str(text).map_err(syntax)?;
        let written: Written = toml::from_str(text).map_err(syntax)?;
        scene.complete(&written).map_err(|fault| fault.at(text, origin))?;
        Ok(scene)
    }

    /// The ground of a picture that says nothing about it: that of Bouthors, Neyret & Lefebvre 2006, 20 %.
    pub fn ground_or_default(&self) -> Ground {
        self.ground.clone().unwrap_or_else(|| Ground::grey(0.2))
    }

    /// Checks what is written, then derives what a picture leaves out.
    fn complete(&mut self, written: &Written) -> Result<(), Fault> {
        check_picture::check(self)?;
        if written.view.is_none() {
            self.view = self.derived_view()?;
        }
        if written.layer.is_none() {
            self.layer = self.derived_layer()?;
        }
        check::check(self)
    }

    fn derived_view(&self) -> Result<View, Fault> {
        let (Some(camera), Some(clouds)) = (&self.camera, &self.clouds) else {
            return Err(Fault::contents("view", "view is missing: a scene without camera needs it"));
        };
        camera.view(clouds.base_m, self.sun.azimuth_deg).ok_or_else(|| {
            let message = "the camera does not look at the cloud: write [view] if that is meant";
            Fault::contents("camera.elevation_deg", message)
        })
    }

    fn derived_layer(&self) -> Result<Layer, Fault> {
        let clouds = self
            .clouds
            .as_ref()
            .ok_or_else(|| Fault::contents("layer", "layer is missing: a scene without clouds needs it"))?;
        let range = clouds.thickness_range_m().ok_or_else(|| {
            Fault::contents("clouds.file", "layer is missing: a scene whose clouds come from a file needs it")
        })?;
        Ok(Layer {
            optical_thickness: None,
            thickness_m: Some(range),
            extinction_convention: Some(ExtinctionConvention::Paper),
        })
    }
}
