//! Coloured rings round the point opposite the sun: where the phase functions have them, red outermost.

use crate::device::device;
use stratiform_gpu::Gpu;
use stratiform_imaging::profile::Profile;
use stratiform_render::Settings;
use stratiform_tests::effects::{draw, pixel_deg, rings, seen, steps, without, world};
use stratiform_world::{Contribution, World};

/// Where the first bright ring is looked for, Θ in degrees.
const LOOK: [f64; 2] = [176.5, 179.3];

/// The scene through a narrow field: 0.08 degrees a pixel.
fn near() -> World {
    seen(&world("glory").unwrap(), [96, 96], 8.0)
}

/// Θ of the first bright ring of each phase function.
fn expected(world: &World) -> [f64; 3] {
    let fine = steps(LOOK[0], LOOK[1], 0.01);
    world.material.colour.each_ref().map(|phase| {
        let angles = (0..fine.count).map(|i| fine.start + (i as f64 + 0.5) * fine.width);
        let profile = Profile::new(&fine, angles.map(|theta| (theta, phase.at(theta.to_radians()))));
        profile.unwrap().maxima()[0].0
    })
}

/// Rings of each channel of the picture.
fn profiles(gpu: &Gpu, world: &World, settings: &Settings) -> [Profile; 3] {
    let image = draw(gpu, world, settings).unwrap();
    [0, 1, 2].map(|channel| rings(world, &image, channel, LOOK[0], LOOK[1]).unwrap())
}

#[test]
fn rings_are_where_the_phase_functions_have_them_red_outermost() {
    let Some(gpu) = device() else { return };
    let world = near();
    let pixel = pixel_deg(&world.camera);
    let profiles = profiles(&gpu, &world, &Settings::default());
    let found = profiles.each_ref().map(|profile| profile.maxima()[0].0);
    for (found, expected) in found.iter().zip(expected(&world)) {
        println!("glory ring at {found:.3} degrees, expected {expected:.3}");
        assert!((found - expected).abs() < pixel, "{found} {expected}");
    }
    assert!(found[0] + 3.0 * pixel < found[1] && found[1] + 3.0 * pixel < found[2], "{found:?}");
    for profile in profiles {
        assert!(profile.contrast().unwrap() > 0.08, "{:?}", profile.contrast());
    }
}

#[test]
fn without_light_of_one_event_there_are_none() {
    let Some(gpu) = device() else { return };
    for profile in profiles(&gpu, &near(), &without(&[Contribution::Single])) {
        assert!(profile.contrast().unwrap() < 0.03, "{:?}", profile.contrast());
    }
}

#[test]
fn a_grey_phase_function_has_no_order_of_colours() {
    let Some(gpu) = device() else { return };
    let mut world = near();
    world.material.colour = std::array::from_fn(|_| world.material.phase.clone());
    let [red, green, blue] =
        profiles(&gpu, &world, &Settings::default()).map(|profile| profile.maxima()[0].0);
    assert!((red - blue).abs() < 0.01 && (green - blue).abs() < 0.01, "{red} {green} {blue}");
}
