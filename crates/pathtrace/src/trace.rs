//! All pixels, in rounds of samples.

use crate::layer::Ray;
use crate::random::uniform;
use crate::request::{Crop, SAMPLES};
use crate::scene::Scene;
use crate::tally::Tally;
use crate::truth::median_error;
use crate::{PathtraceError, Request, Stop, Truth, path};
use rayon::prelude::*;
use std::time::Instant;
use stratiform_stats::{Purpose, key, photon_stream};
use stratiform_world::World;

/// Samples after which a target is first looked at.
const FIRST: u64 = 32;

/// Traces `request`.
///
/// # Errors
/// [`PathtraceError`] for a world or a request out of domain.
pub fn trace(world: &World, request: &Request) -> Result<Truth, PathtraceError> {
    let crop = request.pixels(&world.camera)?;
    let mut work = Work {
        scene: Scene::new(world)?,
        crop,
        key: key(request.seed, Purpose::Picture),
        tallies: vec![Tally::default(); crop.width * crop.height],
        samples: 0,
    };
    match request.stop {
        Stop::Samples(samples) => work.go_on(samples),
        Stop::Target { error, at_most } => work.until_error(error, at_most),
        Stop::Seconds(seconds) => work.until_time(seconds),
    }
    Truth::new(&work.tallies, crop, work.samples)
}

struct Work<'a> {
    scene: Scene<'a>,
    crop: Crop,
    key: u64,
    tallies: Vec<Tally>,
    /// Of each pixel.
    samples: u64,
}

impl Work<'_> {
    /// `more` samples in each pixel.
    fn go_on(&mut self, more: u64) {
        let (scene, crop, key, from) = (&self.scene, self.crop, self.key, self.samples);
        self.tallies.par_iter_mut().enumerate().for_each(|(i, tally)| {
            let pixel = [crop.x + i % crop.width, crop.y + i / crop.width];
            (from..from + more).for_each(|sample| tally.add(&one(scene, key, pixel, sample)));
        });
        self.samples += more;
    }

    /// The error falls with the root of the samples, which tells how many are wanted.
    fn until_error(&mut self, error: f64, at_most: u64) {
        self.go_on(FIRST.min(at_most));
        loop {
            let excess = median_error(&self.tallies) / error;
            if excess <= 1.0 || self.samples >= at_most {
                return;
            }
            let wanted = (self.samples as f64 * (1.02 * excess * excess).min(16.0)).ceil() as u64;
            self.go_on(wanted.clamp(self.samples + 1, at_most) - self.samples);
        }
    }

    /// Rounds grow with the time that is left by the pace so far.
    fn until_time(&mut self, seconds: f64) {
        let start = Instant::now();
        self.go_on(2);
        loop {
            let spent = start.elapsed().as_secs_f64();
            let pace = self.samples as f64 / spent.max(1e-9);
            let room = (SAMPLES.max as u64 - self.samples) as f64;
            let more = (0.5 * (seconds - spent) * pace).min(room).min(4.0 * self.samples as f64) as u64;
            if more == 0 {
                return;
            }
            self.go_on(more);
        }
    }
}

/// One path through a random point of a pixel.
fn one(scene: &Scene<'_>, key: u64, [x, y]: [usize; 2], sample: u64) -> crate::light::Light {
    let camera = &scene.world.camera;
    let pixel = (y * camera.width + x) as u64;
    let mut rng = photon_stream(key, (pixel << 32) | sample);
    let (dx, dy) = (uniform(&mut rng), uniform(&mut rng));
    let direction = camera.ray(x as f64 + dx, y as f64 + dy);
    path::trace(scene, Ray { origin: camera.position, direction }, &mut rng)
}
