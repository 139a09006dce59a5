//! Pictures as means over pixels.

use crate::CliError;
use crate::pipeline::input_error;
use stratiform_gpu::Gpu;
use stratiform_imaging::Image;
use stratiform_render::{Model, Renderer, Settings};
use stratiform_world::World;

/// A model's name in files and on the command line.
pub fn model_name(model: Model) -> &'static str {
    match model {
        Model::Angular => "angular",
        Model::Fitted => "fitted",
    }
}

/// A renderer at several times the size, whose pictures are brought down again: the truth is a mean over each pixel's square.
pub struct Draw {
    world: World,
    renderer: Renderer,
    oversample: usize,
}

impl Draw {
    /// Of `world`, `oversample` rays a pixel each way.
    ///
    /// # Errors
    /// [`CliError::Input`] for a world or settings that cannot be drawn.
    pub fn new(gpu: &Gpu, world: &World, settings: &Settings, oversample: usize) -> Result<Self, CliError> {
        let mut world = world.clone();
        world.camera.width *= oversample;
        world.camera.height *= oversample;
        let renderer = Renderer::new(gpu, &world, settings).map_err(input_error)?;
        Ok(Self { world, renderer, oversample })
    }

    /// Columns and rows that are drawn.
    pub fn size(&self) -> (usize, usize) {
        (self.world.camera.width, self.world.camera.height)
    }

    /// The picture at the size of the truth.
    ///
    /// # Errors
    /// [`CliError::Input`] if the device fails or a pixel is no number.
    pub fn picture(&mut self, settings: &Settings) -> Result<Image, CliError> {
        self.renderer.update(&self.world, settings).map_err(input_error)?;
        let fine = self.renderer.draw().map_err(input_error)?;
        fine.downsample(self.oversample).map_err(input_error)
    }

    /// Milliseconds of each pass: medians over `frames` frames. Empty where the device has no clock.
    ///
    /// # Errors
    /// As [`picture`](Self::picture).
    pub fn times(&mut self, settings: &Settings, frames: usize) -> Result<Vec<(String, f64)>, CliError> {
        self.renderer.update(&self.world, settings).map_err(input_error)?;
        // The first frame sets up what is made once.
        self.renderer.draw().map_err(input_error)?;
        let mut runs = Vec::new();
        for _ in 0..frames {
            self.renderer.draw().map_err(input_error)?;
            runs.push(self.renderer.timings());
        }
        let Some(first) = runs.first() else { return Ok(Vec::new()) };
        let median = |pass: usize| {
            let mut times: Vec<f64> = runs.iter().filter_map(|run| Some(run.get(pass)?.seconds)).collect();
            times.sort_by(f64::total_cmp);
            1e3 * times[times.len() / 2]
        };
        Ok(first.iter().enumerate().map(|(i, pass)| (pass.name.clone(), median(i))).collect())
    }
}
