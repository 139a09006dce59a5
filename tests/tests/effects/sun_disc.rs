//! The sun's disc, sharp through thin parts and gone behind thick ones.

use crate::device::device;
use glam::DVec3;
use std::f64::consts::PI;
use stratiform_imaging::Image;
use stratiform_render::Settings;
use stratiform_tests::effects::{
    draw, flat, from, luminance, path, places, ray, scattering_deg, seen, without, world,
};
use stratiform_world::{Contribution, World};

const SIDE: usize = 48;

/// Two degrees round the sun.
fn near() -> World {
    seen(&world("sun-disc").unwrap(), [SIDE, SIDE], 2.0)
}

/// Radiance of the sky with the disc before it.
fn behind(world: &World) -> f64 {
    let sine = libm::sin(world.sun.angular_radius_deg.to_radians());
    (world.sun.irradiance[1] / (sine * sine) + world.sky.irradiance()[1]) / PI
}

/// What is seen sharply: the picture less that without what is behind the cloud.
fn sharp(world: &World) -> Image {
    let gpu = device().unwrap();
    let all = draw(&gpu, world, &Settings::default()).unwrap();
    let rest = draw(&gpu, world, &without(&[Contribution::Background])).unwrap();
    all.zip(&rest, |all, rest| std::array::from_fn(|c| all[c] - rest[c])).unwrap()
}

#[test]
fn the_disc_is_as_bright_and_as_large_as_the_air_leaves_it() {
    if device().is_none() {
        return;
    }
    let world = near();
    let vertical = |path: f64| path * world.sun.direction.z / world.material.extinction_per_m;
    for thickness in [1.0, 4.0].map(vertical) {
        let world = flat(&world, thickness).unwrap();
        let image = sharp(&world);
        for place in places(&image) {
            let inside = scattering_deg(&world, place) < world.sun.angular_radius_deg;
            let found = f64::from(image.at(place.0, place.1)[1]);
            let expected = libm::exp(-path(&world, ray(&world, place))) * behind(&world);
            assert!(
                if inside { (found / expected - 1.0).abs() < 1e-4 } else { found < 1e-3 * expected },
                "{place:?} {found} {expected}"
            );
        }
    }
}

#[test]
fn the_disc_shows_where_transparency_says_and_is_gone_behind_thick_parts() {
    let Some(gpu) = device() else { return };
    let world = near();
    for (path, seen) in [(2.0, true), (6.0, true), (20.0, false)] {
        let thickness = path * world.sun.direction.z / world.material.extinction_per_m;
        let image = draw(&gpu, &flat(&world, thickness).unwrap(), &Settings::default()).unwrap();
        let [disc, beside] = [SIDE / 2, SIDE / 4].map(|x| luminance(image.at(x, SIDE / 2)));
        println!("sun's disc over 0.5 degrees beside it, optical thickness {path}: {:.4}", disc / beside);
        assert!(if seen { disc > 3.0 * beside } else { disc < 1.01 * beside }, "{path}: {disc} {beside}");
    }
}

#[test]
fn under_moving_cloud_the_disc_dims_as_its_path_says() {
    if device().is_none() {
        return;
    }
    let world = near();
    let mut paths = Vec::new();
    for east in [0.0, 120.0, 240.0] {
        let world = from(&world, world.camera.position + east * DVec3::X);
        let place = (SIDE / 2, SIDE / 2);
        let path = path(&world, ray(&world, place));
        let found = f64::from(sharp(&world).at(place.0, place.1)[1]);
        let expected = libm::exp(-path) * behind(&world);
        assert!((found / expected - 1.0).abs() < 0.01 || expected < 1e-3, "{path} {found} {expected}");
        paths.push(path);
    }
    let spread = paths.iter().copied().fold(0.0, f64::max) - paths.iter().copied().fold(1e9, f64::min);
    assert!(spread > 1.0, "{paths:?}");
}
