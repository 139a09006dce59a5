//! A flat layer without sky and ground: the radiance of the crate `model` in f64 at every pixel.
//!
//! The line of sight is the camera's, the phase function that of the generated table's angles, linear between them.

#![allow(
    clippy::unwrap_used,
    clippy::print_stdout,
    reason = "a test may stop where it fails, and says what it measured"
)]

#[path = "../../gpu/tests/device/mod.rs"]
mod device;
mod worlds;

use stratiform_artifact::{ParametersDocument, RadianceParametersDocument, read_json};
use stratiform_model::angular::{Angular, Emission, PhaseLookup, Sight};
use stratiform_model::radiance::{Coefficients, Slab};
use stratiform_optics::phase::PhaseTable;
use stratiform_quantities::Side;
use stratiform_render::{Contributions, Model, Renderer, Settings, radiosity};
use stratiform_world::{Camera, Contribution, Material, World};

const SIZE: [usize; 2] = [64, 36];

/// One channel.
struct Channel<'a> {
    material: &'a Material,
    full: &'a PhaseTable,
    squared: &'a PhaseTable,
}

fn angle(v: f64) -> f64 {
    2.0 * libm::asin((0.5 * v).sqrt())
}

impl PhaseLookup<f64> for Channel<'_> {
    fn full(&self, v: f64) -> f64 {
        self.full.at(angle(v))
    }

    fn wide(&self, v: f64) -> f64 {
        let theta_f = self.material.theta_f_deg.to_radians();
        if angle(v) < theta_f { 0.0 } else { self.full(v) / (1.0 - self.full.cumulative_at(theta_f)) }
    }

    fn wide_squared(&self, v: f64) -> f64 {
        self.squared.at(angle(v))
    }
}

/// What the models know of a cloud.
struct Cloud {
    coefficients: Coefficients<f64>,
    fluxes: radiosity::Slab,
}

fn cloud(material: &Material) -> Cloud {
    Cloud {
        coefficients: coefficients(material),
        fluxes: radiosity::Slab::load(&material.generated).unwrap(),
    }
}

fn coefficients(material: &Material) -> Coefficients<f64> {
    let folder = material.generated.join("../accepted");
    let document: RadianceParametersDocument = read_json(&folder.join("radiance_parameters.json")).unwrap();
    let parameters: ParametersDocument = read_json(&folder.join("parameters.json")).unwrap();
    Coefficients {
        similarity: 1.0 - parameters.medium.asymmetry,
        kept: 1.0 - parameters.medium.forward_fraction,
        top: document.table(Side::Top).unwrap(),
        bottom: document.table(Side::Bottom).unwrap(),
    }
}

/// L/F0 of light that met wide events.
fn expected(world: &World, cloud: &Cloud, model: Model, x: usize, y: usize, c: usize) -> f64 {
    let d = world.camera.ray(x as f64 + 0.5, y as f64 + 0.5);
    let sun = world.sun.direction;
    let side = if d.z < 0.0 { Side::Top } else { Side::Bottom };
    let sight = Sight { mu_l: sun.z, mu_v: d.z.abs(), v: 0.5 * (sun - d).length_squared(), side };
    let material = &world.material;
    let channel = Channel { material, full: &material.colour[c], squared: &material.colour_squared[c] };
    let tau = material.extinction_per_m * world.field.most();
    let kept = 1.0 - channel.full.cumulative_at(material.theta_f_deg.to_radians());
    let slab = Angular::new(kept * tau, sight).unwrap();
    let factor = match model {
        Model::Fitted => slab.one(&channel) + Slab::new(&cloud.coefficients, tau, sight).unwrap().more(),
        Model::Angular => {
            let fluxes = cloud.fluxes.beam(sun.z, tau).unwrap();
            let emission = if side == Side::Top { Emission::Lambertian } else { Emission::Escape };
            slab.orders(&channel, &fluxes, emission).total()
        }
    };
    world.sun.irradiance[c] * factor * sun.z / std::f64::consts::PI
}

fn worst(gpu: &stratiform_gpu::Gpu, model: Model, camera: Camera, thickness: f64) -> f64 {
    let world = worlds::world(worlds::flat(thickness), camera, 0.4);
    let contributions = [Contribution::Single, Contribution::Double, Contribution::Multiple]
        .into_iter()
        .fold(Contributions::none(), Contributions::with);
    let settings = Settings { model, contributions, ..Settings::default() };
    let image = Renderer::new(gpu, &world, &settings).unwrap().draw().unwrap();
    let cloud = cloud(&world.material);
    let mut worst = 0.0_f64;
    for (index, pixel) in image.pixels().iter().enumerate() {
        for (c, value) in pixel.iter().enumerate() {
            let expected = expected(&world, &cloud, model, index % SIZE[0], index / SIZE[0], c);
            worst = worst.max((f64::from(*value) / expected - 1.0).abs());
        }
    }
    worst
}

#[test]
fn every_pixel_of_a_flat_layer_has_the_models_radiance() {
    let Some(gpu) = device::device() else { return };
    for model in [Model::Fitted, Model::Angular] {
        for thickness in [2.0, 40.0, 400.0] {
            for camera in [worlds::camera(2.0, 45.0, SIZE), worlds::camera(3000.0, -45.0, SIZE)] {
                let error = worst(&gpu, model, camera, thickness);
                println!("{model:?}, {thickness} m, from {} m: {error:.1e}", camera.position.z);
                assert!(error < 1e-3, "{model:?} {thickness} {error}");
            }
        }
    }
}
