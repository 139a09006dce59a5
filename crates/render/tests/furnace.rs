//! White furnace: sky and ground of radiance 1 and no sun make every pixel 1.
//!
//! The ground has albedo 1 and is lit by sky and cloud through as many exchanges as 1e-5 needs, so that the light between ground and cloud is
//! tested with the picture. T_ms + R_ms = 1 in the generated text.

#![allow(
    clippy::unwrap_used,
    clippy::print_stdout,
    reason = "a test may stop where it fails, and says what it measured"
)]

#[path = "../../gpu/tests/device/mod.rs"]
mod device;
mod worlds;

use stratiform_render::{Depth, Model, Radiosity, Renderer, Settings};
use stratiform_world::{Camera, Ground, HeightField, Map, Sky, World};

const SIZE: [usize; 2] = [64, 36];

fn furnace(field: HeightField, camera: Camera) -> World {
    let mut world = worlds::world(field, camera, 0.3);
    world.sun.irradiance = [0.0; 3];
    world.sky = Sky::Uniform([1.0; 3]);
    world.ground = Ground { albedo: Map::new(1, worlds::EXTENT, vec![[1.0; 3]]).unwrap() };
    world
}

/// Farthest from 1.
fn worst(gpu: &stratiform_gpu::Gpu, world: &World, settings: &Settings) -> f32 {
    let image = Renderer::new(gpu, world, settings).unwrap().draw().unwrap();
    image.pixels().iter().flatten().map(|v| (v - 1.0).abs()).fold(0.0, f32::max)
}

#[test]
fn every_pixel_is_one() {
    let Some(gpu) = device::device() else { return };
    let usual = Settings::default();
    let settings = Settings { radiosity: Radiosity { error: 1e-5, ..usual.radiosity }, ..usual };
    let cameras = [worlds::below(SIZE), worlds::above(SIZE), worlds::between(SIZE)];
    for camera in cameras {
        for (model, depth) in [(Model::Fitted, Depth::Local), (Model::Angular, Depth::Chord)] {
            let world = furnace(worlds::hills(64, 400.0), camera);
            let error = worst(&gpu, &world, &Settings { model, depth, ..settings });
            println!("{:.0} m, {model:?}, {depth:?}: {error:.1e}", camera.position.z);
            assert!(error < 1e-3, "{error}");
        }
    }
}

#[test]
fn a_ground_a_hundredth_darker_is_seen() {
    let Some(gpu) = device::device() else { return };
    let mut world = furnace(worlds::hills(64, 400.0), worlds::above(SIZE));
    world.ground = Ground { albedo: Map::new(1, worlds::EXTENT, vec![[0.99; 3]]).unwrap() };
    assert!(worst(&gpu, &world, &Settings::default()) > 3e-3);
}
