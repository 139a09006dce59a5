//! Pixels of the device against the same functions on the CPU, around the crate `model` in f32.
//!
//! On Mesa's llvmpipe 99.5 % of the pixels differed by 2.2e-5 at most; a pixel's difference is relative to the brighter of it and the
//! picture's mean. Where a ray grazes a hill, rounding may decide otherwise whether it is met: few pixels may differ by any amount.

#![allow(
    clippy::unwrap_used,
    clippy::print_stdout,
    reason = "a test may stop where it fails, and says what it measured"
)]

#[path = "../../gpu/tests/device/mod.rs"]
mod device;
mod worlds;

use stratiform_gpu::Gpu;
use stratiform_imaging::Image;
use stratiform_render::twin::Twin;
use stratiform_render::{Depth, Model, Normals, Renderer, Settings};
use stratiform_world::{Air, Camera, ClearSky, HeightField, Sky, World};

const SIZE: [usize; 2] = [96, 54];

/// Relative differences of pixels, rising.
fn differences(a: &Image, b: &Image) -> Vec<f32> {
    let mean = a.pixels().iter().flatten().sum::<f32>() / (3 * a.pixels().len()) as f32;
    let pixel = |(a, b): (&[f32; 3], &[f32; 3])| {
        a.iter().zip(b).map(|(a, b)| (a - b).abs() / a.abs().max(mean)).fold(0.0_f32, f32::max)
    };
    let mut all: Vec<f32> = a.pixels().iter().zip(b.pixels()).map(pixel).collect();
    all.sort_by(f32::total_cmp);
    all
}

/// What 99.5 % of the pixels keep, and the mean difference.
fn parity(gpu: &Gpu, world: &World, settings: &Settings) -> [f32; 2] {
    let mut renderer = Renderer::new(gpu, world, settings).unwrap();
    let drawn = renderer.draw().unwrap();
    let twin = Twin::new(world, settings, renderer.ground_light().unwrap()).unwrap();
    let all = differences(&drawn, &twin.draw().unwrap());
    [all[all.len() * 995 / 1000], all.iter().sum::<f32>() / all.len() as f32]
}

fn fields() -> [(&'static str, HeightField); 2] {
    [("flat", worlds::flat(150.0)), ("hills", worlds::hills(64, 400.0))]
}

fn cameras() -> [(&'static str, Camera); 3] {
    [("below", worlds::below(SIZE)), ("above", worlds::above(SIZE)), ("between", worlds::between(SIZE))]
}

#[test]
fn the_device_draws_what_the_cpu_computes() {
    let Some(gpu) = device::device() else { return };
    for (field_name, field) in fields() {
        for (name, camera) in cameras() {
            if (field_name, name) == ("flat", "between") {
                continue;
            }
            let world = worlds::world(field.clone(), camera, 0.4);
            for model in [Model::Fitted, Model::Angular] {
                let [most, mean] = parity(&gpu, &world, &Settings { model, ..Settings::default() });
                println!("{field_name} {name} {model:?}: 99.5 % {most:.1e}, mean {mean:.1e}");
                assert!(most < 1e-4 && mean < 1e-4, "{field_name} {name} {model:?}: {most} {mean}");
            }
        }
    }
}

#[test]
fn chords_and_vertical_normals_too() {
    let Some(gpu) = device::device() else { return };
    for (name, camera) in cameras() {
        let world = worlds::world(worlds::hills(63, 400.0), camera, 0.4);
        let settings = Settings { depth: Depth::Chord, normals: Normals::Vertical, ..Settings::default() };
        let [most, mean] = parity(&gpu, &world, &settings);
        println!("{name}: 99.5 % {most:.1e}, mean {mean:.1e}");
        assert!(most < 1e-4 && mean < 1e-4, "{name}: {most} {mean}");
    }
}

#[test]
fn a_clear_sky_is_looked_up_alike() {
    let Some(gpu) = device::device() else { return };
    let mut world = worlds::world(worlds::hills(64, 250.0), worlds::below(SIZE), 0.4);
    world.sky = Sky::Clear(ClearSky::new(world.sun.direction, &Air::default()).unwrap());
    let [most, mean] = parity(&gpu, &world, &Settings::default());
    println!("99.5 % {most:.1e}, mean {mean:.1e}");
    assert!(most < 1e-4 && mean < 1e-4, "{most} {mean}");
}

#[test]
fn the_comparison_sees_a_sun_half_a_degree_off() {
    let Some(gpu) = device::device() else { return };
    let world = worlds::world(worlds::hills(64, 400.0), worlds::below(SIZE), 0.4);
    let settings = Settings::default();
    let mut renderer = Renderer::new(&gpu, &world, &settings).unwrap();
    let drawn = renderer.draw().unwrap();
    let mut other = world.clone();
    other.sun.direction = glam::DQuat::from_rotation_x(0.5_f64.to_radians()) * other.sun.direction;
    let twin = Twin::new(&other, &settings, renderer.ground_light().unwrap()).unwrap();
    let all = differences(&drawn, &twin.draw().unwrap());
    assert!(all[all.len() * 995 / 1000] > 3e-3);
}
