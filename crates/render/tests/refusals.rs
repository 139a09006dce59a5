//! What the renderer refuses, in words that name the fault; and that pictures do not depend on the run.

#![allow(clippy::unwrap_used, reason = "a test may stop where it fails")]

#[path = "../../gpu/tests/device/mod.rs"]
mod device;
mod worlds;

use stratiform_gpu::GpuError;
use stratiform_render::{RenderError, Renderer, Settings};
use stratiform_world::{HeightField, Map, World};

const SIZE: [usize; 2] = [40, 24];

fn hills() -> World {
    worlds::world(worlds::hills(32, 300.0), worlds::below(SIZE), 0.0)
}

#[test]
fn worlds_that_cannot_be_drawn_are_named() {
    let Some(gpu) = device::device() else { return };
    let refused = |change: &dyn Fn(&mut World), says: &str| {
        let mut world = hills();
        change(&mut world);
        let error = Renderer::new(&gpu, &world, &Settings::default()).unwrap_err().to_string();
        assert!(error.contains(says), "`{says}` is not in `{error}`");
    };
    refused(&|w| w.sun.direction.z = -0.1, "cosine of the sun's zenith angle = -0.1");
    refused(&|w| w.sun.direction.z = f64::NAN, "cosine of the sun's zenith angle = NaN");
    refused(&|w| w.camera.width = 0, "columns of the picture = 0");
    refused(&|w| w.camera.position.z = -1.0, "altitude of the camera, m = -1");
    refused(&|w| w.material.extinction_per_m = 1e5, "greatest optical thickness");
    refused(&|w| w.material.generated = "nowhere".into(), "nowhere");
    refused(
        &|w| (w.field, w.camera.position.z) = (worlds::flat(300.0), worlds::BASE + 100.0),
        "inside the cloud: 100 m above its base, where it is 300 m thick",
    );
}

#[test]
fn what_the_device_has_no_room_for_is_refused() {
    let Some(gpu) = device::device() else { return };
    let mut world = hills();
    (world.camera.width, world.camera.height) = (65_536, 65_536);
    let error = Renderer::new(&gpu, &world, &Settings::default()).unwrap_err();
    assert!(matches!(error, RenderError::Gpu(GpuError::OutOfMemory { .. })), "{error}");
    let most = HeightField::new(Map::new(8193, 1e6, vec![1.0; 8193 * 8193]).unwrap()).unwrap();
    let error = Renderer::new(&gpu, &World { field: most, ..hills() }, &Settings::default()).unwrap_err();
    assert!(matches!(error, RenderError::Domain(_)), "{error}");
}

#[test]
fn a_pixel_that_is_no_number_is_named() {
    let Some(gpu) = device::device() else { return };
    let mut world = hills();
    world.sun.irradiance = [1.0, f64::NAN, 1.0];
    let error = Renderer::new(&gpu, &world, &Settings::default()).and_then(|mut r| r.draw()).unwrap_err();
    assert!(matches!(error, RenderError::NotFinite { .. } | RenderError::Radiosity(_)), "{error}");
}

#[test]
fn a_lost_device_is_said_to_be_lost() {
    let Some(gpu) = device::device() else { return };
    let mut renderer = Renderer::new(&gpu, &hills(), &Settings::default()).unwrap();
    gpu.lose();
    let error = renderer.draw().unwrap_err();
    assert!(matches!(error, RenderError::Gpu(GpuError::Lost { .. })), "{error}");
}

#[test]
fn a_world_without_light_is_black_and_no_error() {
    let Some(gpu) = device::device() else { return };
    let mut world = hills();
    world.sun.irradiance = [0.0; 3];
    world.sky = stratiform_world::Sky::Uniform([0.0; 3]);
    let image = Renderer::new(&gpu, &world, &Settings::default()).unwrap().draw().unwrap();
    assert!(image.pixels().iter().flatten().all(|v| *v == 0.0));
}

#[test]
fn the_same_world_is_the_same_picture_however_it_came_about() {
    let Some(gpu) = device::device() else { return };
    let (first, other) = (hills(), worlds::world(worlds::hills(48, 200.0), worlds::above([64, 30]), 0.2));
    let settings = Settings::default();
    let angular = Settings { model: stratiform_render::Model::Angular, ..settings };
    let mut renderer = Renderer::new(&gpu, &first, &settings).unwrap();
    let drawn = renderer.draw().unwrap();
    assert_eq!(renderer.draw().unwrap(), drawn);
    renderer.update(&other, &angular).unwrap();
    assert_eq!(renderer.draw().unwrap(), Renderer::new(&gpu, &other, &angular).unwrap().draw().unwrap());
    renderer.update(&first, &settings).unwrap();
    assert_eq!(renderer.draw().unwrap(), drawn);
    let names: Vec<String> = renderer.timings().into_iter().map(|time| time.name).collect();
    assert!(names.is_empty() || names.iter().any(|name| name == "picture"), "{names:?}");
}
