//! Brightening of the layer's top towards a low sun, as if it mirrored.

use crate::device::device;
use glam::DVec3;
use stratiform_gpu::Gpu;
use stratiform_render::Settings;
use stratiform_tests::effects::{
    draw, flat, luminance, ray, seen, solved, sunlight, towards, without, world,
};
use stratiform_world::{Contribution, World};

const SUNLIGHT: [Contribution; 4] =
    [Contribution::Halo, Contribution::Single, Contribution::Double, Contribution::Multiple];
const ROWS: [usize; 2] = [4, 28];

/// A strip of the scene: from 3 to 15 degrees below the horizon, ahead towards the sun.
fn strip() -> World {
    let world = seen(&world("pseudo-specular").unwrap(), [5, 33], 12.0);
    let (sine, cosine) = libm::sincos(9_f64.to_radians());
    let level = DVec3::new(world.sun.direction.x, world.sun.direction.y, 0.0).normalize();
    towards(&world, cosine * level - sine * DVec3::Z)
}

fn turned(world: &World) -> World {
    let DVec3 { x, y, z } = world.camera.forward;
    towards(world, DVec3::new(-x, -y, z))
}

/// Mean luminance of each row ahead over that behind.
fn ratios(gpu: &Gpu, world: &World, settings: &Settings) -> Vec<f64> {
    let rows = |world: &World| {
        let image = draw(gpu, world, settings).unwrap();
        let row = |y: usize| (0..5).map(|x| luminance(image.at(x, y))).sum::<f64>();
        (0..33).map(row).collect::<Vec<_>>()
    };
    rows(world).iter().zip(rows(&turned(world))).map(|(ahead, behind)| ahead / behind).collect()
}

#[test]
fn the_top_is_brighter_towards_the_sun_as_the_solved_layer_is() {
    let Some(gpu) = device() else { return };
    let world = flat(&strip(), 200.0).unwrap();
    let found = ratios(&gpu, &world, &sunlight());
    let back = turned(&world);
    let rays: Vec<DVec3> = ROWS.into_iter().flat_map(|y| [ray(&world, (2, y)), ray(&back, (2, y))]).collect();
    let tau = 200.0 * world.material.extinction_per_m;
    let solved = solved::radiance(&world, &world.material.phase, tau, &rays).unwrap();
    for (y, pair) in ROWS.iter().zip(solved.chunks(2)) {
        let expected = pair[0] / pair[1];
        println!("pseudo-specular, row {y}: {:.2}, solved {expected:.2}", found[*y]);
        assert!(expected > 5.0 && (found[*y] / expected - 1.0).abs() < 0.12, "{} {expected}", found[*y]);
    }
}

#[test]
fn every_row_of_the_scene_shows_it_and_none_without_the_suns_light() {
    let Some(gpu) = device() else { return };
    let least = |ratios: Vec<f64>| ratios.into_iter().fold(f64::INFINITY, f64::min);
    let world = strip();
    assert!(least(ratios(&gpu, &world, &Settings::default())) > 1.5);
    for ratio in ratios(&gpu, &flat(&world, 200.0).unwrap(), &without(&SUNLIGHT)) {
        assert!((ratio - 1.0).abs() < 1e-3, "{ratio}");
    }
}
