//! A scene turned into points with their truth.

use crate::ChartError;
use crate::clouds::{SceneCloud, clouds};
use crate::grid::{Density, Grid};
use crate::truth::Truth;
use std::path::Path;
use std::sync::atomic::{AtomicBool, Ordering};
use stratiform_methods::Cloud;
use stratiform_scene::Scene;

/// A scene's points.
pub struct Sample {
    /// Name of the scene.
    pub name: String,
    /// What it says.
    pub scene: Scene,
    /// Its clouds, the main one first.
    pub clouds: Vec<CloudSample>,
}

/// One cloud's points.
pub struct CloudSample {
    /// r_e.
    pub effective_radius_um: f64,
    /// λ.
    pub wavelength_um: f64,
    /// Ready for methods.
    pub cloud: Cloud,
    /// Where it is sampled.
    pub grid: Grid,
    /// What is true there.
    pub truth: Truth,
}

/// How samples are made.
#[derive(Clone, Copy)]
pub struct Source<'a> {
    /// One cloud and few points.
    pub quick: bool,
    /// Where optics and truth are kept between runs.
    pub cache: Option<&'a Path>,
    /// Is called after each cloud.
    pub progress: &'a dyn Fn(),
    /// Set to true to stop.
    pub cancel: &'a AtomicBool,
}

impl Sample {
    /// Points and truth of a scene.
    ///
    /// # Errors
    /// [`ChartError`] of the optics or the solver, or [`ChartError::Cancelled`].
    pub fn of_scene(name: &str, scene: &Scene, source: &Source<'_>) -> Result<Self, ChartError> {
        let mut samples = Vec::new();
        for (place, one) in clouds(scene, source.quick, source.cache)?.into_iter().enumerate() {
            if source.cancel.load(Ordering::Relaxed) {
                return Err(ChartError::Cancelled);
            }
            let density = match (source.quick, place) {
                (true, _) => Density::QUICK,
                (false, 0) => Density::FULL,
                (false, _) => Density::THIN,
            };
            samples.push(CloudSample::new(scene, one, density, source.cache)?);
            (source.progress)();
        }
        Ok(Self { name: name.to_owned(), scene: scene.clone(), clouds: samples })
    }
}

impl CloudSample {
    fn new(
        scene: &Scene,
        one: SceneCloud,
        density: Density,
        cache: Option<&Path>,
    ) -> Result<Self, ChartError> {
        let SceneCloud { effective_radius_um, wavelength_um, cloud, tau } = one;
        let grid = Grid::new(scene, tau, density);
        let truth = Truth::load_or_solve(&cloud, &grid, cache)?;
        Ok(Self { effective_radius_um, wavelength_um, cloud, grid, truth })
    }
}
