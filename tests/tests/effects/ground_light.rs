//! Water sky and ice blink: the base of an overcast layer shows from afar what lies below it.

use crate::device::device;
use glam::DVec3;
use std::f64::consts::PI;
use stratiform_gpu::Gpu;
use stratiform_imaging::profile::contrast;
use stratiform_render::Settings;
use stratiform_tests::effects::{draw, flat, over, ray, solved, without, world, world_over};
use stratiform_world::{Camera, Contribution, World};

/// Water and ice of both scenes.
const ALBEDO: [f64; 2] = [0.06, 0.75];
/// Thickness of the layer, m.
const THICK: f64 = 450.0;

/// Straight up from the ground, `width` pixels from west to east.
fn upwards(world: &World, east_m: f64, width: usize, tan_half: f64) -> World {
    let camera = Camera {
        position: DVec3::new(east_m, 0.0, 1.0),
        forward: DVec3::Z,
        right: DVec3::X,
        up: -DVec3::Y,
        tan_half,
        width,
        height: 1,
    };
    World { camera, ..world.clone() }
}

/// Radiance of the base right above the middle of the water and the middle of the ice.
fn above(gpu: &Gpu, world: &World, settings: &Settings) -> [f64; 2] {
    [0.25, 0.75].map(|share| {
        let world = upwards(world, share * world.field.map().extent_m(), 1, 1e-3);
        f64::from(draw(gpu, &world, settings).unwrap().at(0, 0)[1])
    })
}

/// The same between two planes without end: E = ρ F/(1 - ρ R) falls on the base, F the light that comes through it.
fn between_planes(world: &World) -> [f64; 2] {
    let (phase, tau) = (&world.material.phase, THICK * world.material.extinction_per_m);
    let (sun, sky) = (world.sun.direction.z, world.sky.irradiance()[1]);
    let shares = solved::shares(phase, tau, &[sun, 1.0]).unwrap();
    let [(_, through_slant), (back, through), (diffuse_back, diffuse_through)] = shares[..] else { panic!() };
    let own = solved::radiance(world, phase, tau, &[DVec3::Z]).unwrap()[0] + through * sky / PI;
    let falls = sun * through_slant + diffuse_through * sky;
    ALBEDO.map(|albedo| own + back / PI * albedo * falls / (1.0 - albedo * diffuse_back))
}

#[test]
fn the_base_over_water_is_darker_than_over_ice_as_between_two_planes() {
    let Some(gpu) = device() else { return };
    let world = flat(&world("water-sky").unwrap(), THICK).unwrap();
    let drawn = above(&gpu, &world, &Settings::default());
    let expected = between_planes(&world);
    let (found, expected) = (contrast(drawn).unwrap(), contrast(expected).unwrap());
    assert!(drawn[0] < drawn[1] && expected > 0.2);
    println!("water sky, contrast {found:.4}, expected {expected:.4}");
    assert!((found / expected - 1.0).abs() < 0.05, "{found} {expected}");
}

#[test]
fn without_exchange_the_base_does_not_know_the_ground() {
    let Some(gpu) = device() else { return };
    let world = flat(&world("water-sky").unwrap(), THICK).unwrap();
    let mut settings = Settings::default();
    settings.radiosity.passes = Some(0);
    assert_eq!(contrast(above(&gpu, &world, &settings)), Some(0.0));
    assert_eq!(contrast(above(&gpu, &world, &without(&[Contribution::Ground]))), Some(0.0));
}

/// After one exchange the base at a distance d inside the edge of the ice sees a share (1 + d/√(d² + h²))/2 of ice.
#[test]
fn the_blink_begins_as_the_view_of_a_half_plane_does() {
    let Some(gpu) = device() else { return };
    let world = flat(&world_over("ice-blink", Some(25_600.0)).unwrap(), THICK).unwrap();
    let world = upwards(&world, 12_800.0, 25, 2.5 / 25.0);
    let mut settings = Settings::default();
    settings.radiosity.side = 64;
    settings.radiosity.passes = Some(1);
    let light = |world: &World| draw(&gpu, world, &settings).unwrap();
    let [both, water, ice] =
        [light(&world), light(&over(&world, ALBEDO[0]).unwrap()), light(&over(&world, ALBEDO[1]).unwrap())];
    for x in 0..25 {
        let ray = ray(&world, (x, 0));
        let height = world.base_m;
        let inside = ray.x / ray.z * (height - world.camera.position.z);
        let [both, water, ice] = [&both, &water, &ice].map(|image| f64::from(image.at(x, 0)[1]));
        let found = (both - water) / (ice - water);
        let expected = 0.5 * (1.0 + inside / libm::hypot(inside, height));
        println!("ice blink, {inside:?}: {found:.4}, expected {expected:.4}");
        assert!((found - expected).abs() < 0.03, "{inside} {found} {expected}");
    }
}
