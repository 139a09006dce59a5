//! What must be true of a traced picture, whatever the cloud.

#![allow(clippy::unwrap_used, reason = "a test may stop where it fails")]

mod worlds;

use glam::DVec3;
use stratiform_imaging::Image;
use stratiform_optics::phase::{Norm, PhaseTable};
use stratiform_pathtrace::{Crop, PathtraceError, Request, Stop, Truth, trace};
use stratiform_stats::family_threshold;
use stratiform_world::{Contribution, HeightField, Map, Sky, Sun, World};

fn samples(world: &World, samples: u64) -> Truth {
    trace(world, &Request { stop: Stop::Samples(samples), crop: None, seed: 7 }).unwrap()
}

fn grey() -> [PhaseTable; 3] {
    [worlds::paper(), worlds::paper(), worlds::paper()]
}

/// Three functions that differ as those of clouds do in the forward peak, and more elsewhere.
fn coloured() -> [PhaseTable; 3] {
    [0.83, 0.85, 0.87].map(worlds::henyey_greenstein)
}

fn furnace(colour: [PhaseTable; 3]) -> World {
    let mut world = worlds::world(worlds::bumpy(32), colour);
    world.sun.irradiance = [0.0; 3];
    world.sky = Sky::Uniform([1.0; 3]);
    world.ground.albedo = worlds::ground([1.0; 3]);
    world
}

/// Every path ends in the sky with all its light.
#[test]
fn a_white_furnace_is_white_to_rounding() {
    let truth = samples(&furnace(grey()), 20);
    for pixel in truth.mean.pixels().iter().flatten() {
        assert!((pixel - 1.0).abs() < 1e-6, "{pixel}");
    }
    for error in truth.std_error.pixels().iter().flatten() {
        assert!(*error < 1e-6, "{error}");
    }
}

/// The channels' weights are fair: 48 pixels of three channels at a false-alarm rate of 1e-3 in all (normal theory).
#[test]
fn a_white_furnace_is_white_in_each_channel() {
    let truth = samples(&furnace(coloured()), 200);
    let bound = family_threshold(1e-3, 3 * 48).unwrap();
    let z = |(mean, error): (&[f32; 3], &[f32; 3])| {
        (0..3).map(|c| ((mean[c] - 1.0) / error[c]).abs()).fold(0.0, f32::max)
    };
    let worst = truth.mean.pixels().iter().zip(truth.std_error.pixels()).map(z).fold(0.0, f32::max);
    assert!(f64::from(worst) < bound, "{worst} of {bound}");
    // 3 % more light would be seen in the mean of all pixels.
    let n = truth.mean.pixels().len() as f64;
    let mean = truth.mean.pixels().iter().fold(0.0, |sum, p| sum + f64::from(p[0])) / n;
    let error = truth.std_error.pixels().iter().fold(0.0, |sum, p| sum + f64::from(p[0] * p[0])).sqrt() / n;
    assert!((mean - 1.0).abs() < 4.5 * error && error < 0.03 / 4.5, "{mean} {error}");
}

/// Without cloud the ground is lit by the whole sun and half a sphere of sky, and seen as it is.
#[test]
fn a_layer_without_thickness_leaves_sky_and_ground() {
    let mut world = worlds::world(HeightField::flat(0.0, 1000.0).unwrap(), grey());
    world.sky = Sky::Uniform([0.08, 0.1, 0.2]);
    world.ground.albedo = worlds::ground([0.2, 0.2, 0.1]);
    for theta in [60.0, 120.0] {
        world.camera = worlds::camera(DVec3::new(0.0, 0.0, 100.0), worlds::towards(theta, 33.0), 0.3, 4, 3);
        let truth = samples(&world, 4000);
        let sun = world.sun.direction.z / std::f64::consts::PI;
        let expected = if theta < 90.0 {
            [0.08, 0.1, 0.2]
        } else {
            [0.2 * (sun + 0.08), 0.2 * (sun + 0.1), 0.1 * (sun + 0.2)]
        };
        for (mean, error) in truth.mean.pixels().iter().zip(truth.std_error.pixels()) {
            for c in 0..3 {
                let off = (f64::from(mean[c]) - expected[c]).abs();
                // 36 numbers of each view within 4.5 standard errors: one false alarm in 4000.
                assert!(off <= 4.5 * f64::from(error[c]) + 1e-6, "{theta} {mean:?} {error:?} {expected:?}");
            }
        }
        assert_eq!(truth.parts[Contribution::Background.index()].1, truth.mean);
    }
}

/// The sun's disc as it is, and through a cloud of known thickness.
#[test]
fn the_disc_is_seen_through_the_cloud() {
    for tau in [0.0, 1.5] {
        let mut world = worlds::world(HeightField::flat(tau / 0.046_18, 1000.0).unwrap(), grey());
        let sun: Sun = world.sun;
        world.camera = worlds::camera(DVec3::new(0.0, 0.0, 100.0), sun.direction, 1e-4, 2, 2);
        let truth = samples(&world, 2);
        let edge = libm::sin(sun.angular_radius_deg.to_radians());
        let expected = libm::exp(-tau / sun.direction.z) / (std::f64::consts::PI * edge * edge);
        let background = truth.parts[Contribution::Background.index()].1.at(0, 0)[0];
        assert!((f64::from(background) / expected - 1.0).abs() < 1e-3, "{background} {expected}");
    }
}

fn bytes(image: &Image) -> Vec<u32> {
    image.pixels().iter().flatten().map(|x| x.to_bits()).collect()
}

fn lit() -> World {
    let mut world = worlds::world(worlds::bumpy(32), coloured());
    world.sky = Sky::Uniform([0.05, 0.08, 0.1]);
    world.ground.albedo = worlds::ground([0.3, 0.2, 0.1]);
    world
}

#[test]
fn the_same_seed_gives_the_same_bytes_for_any_number_of_threads_and_any_crop() {
    let world = lit();
    let with = |threads: usize, crop: Option<Crop>, seed: u64| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| trace(&world, &Request { stop: Stop::Samples(30), crop, seed }).unwrap())
    };
    let (one, two) = (with(1, None, 3), with(2, None, 3));
    assert_eq!(one, two);
    assert_eq!(bytes(&one.std_error), bytes(&two.std_error));
    assert_ne!(bytes(&one.mean), bytes(&with(2, None, 4).mean));
    let crop = with(2, Some(Crop { x: 3, y: 2, width: 4, height: 3 }), 3);
    assert_eq!(crop.mean.at(1, 2), one.mean.at(4, 4));
}

#[test]
fn contributions_add_up_to_the_whole() {
    let truth = samples(&lit(), 60);
    for (i, pixel) in truth.mean.pixels().iter().enumerate() {
        for c in 0..3 {
            let sum = truth.parts.iter().fold(0.0, |sum, (_, mean, _)| sum + mean.pixels()[i][c]);
            assert!((sum - pixel[c]).abs() < 1e-5 * pixel[c], "{sum} {pixel:?}");
        }
    }
    for (part, mean, _) in &truth.parts[1..] {
        assert!(mean.pixels().iter().any(|p| p[0] > 0.0) || *part == Contribution::Halo, "{part:?} is dark");
    }
}

#[test]
fn a_target_is_met_or_the_limit_kept() {
    let world = lit();
    let run = |error, at_most| {
        trace(&world, &Request { stop: Stop::Target { error, at_most }, crop: None, seed: 1 }).unwrap()
    };
    let met = run(0.2, 100_000);
    assert!(met.median_error <= 0.2 && met.samples < 5000, "{} {}", met.median_error, met.samples);
    assert_eq!(run(1e-4, 50).samples, 50);
}

#[test]
fn what_is_out_of_domain_is_refused() {
    let good = lit();
    let request = Request { stop: Stop::Samples(2), crop: None, seed: 1 };
    let refused = |change: &dyn Fn(&mut World)| {
        let mut world = good.clone();
        change(&mut world);
        matches!(trace(&world, &request), Err(PathtraceError::Domain(_)))
    };
    assert!(!refused(&|_| ()));
    assert!(refused(&|w| w.sun.direction.z = -w.sun.direction.z));
    assert!(refused(&|w| w.sun.direction = DVec3::new(f64::NAN, 0.0, 1.0)));
    assert!(refused(&|w| w.sun.irradiance[1] = -1.0));
    assert!(refused(&|w| w.material.extinction_per_m = 0.0));
    assert!(refused(&|w| w.material.single_scattering_albedo = 1.1));
    assert!(refused(&|w| w.material.theta_f_deg = f64::NAN));
    assert!(refused(&|w| w.camera.position.z = 0.0));
    assert!(refused(&|w| w.camera.position.x = f64::INFINITY));
    assert!(refused(&|w| w.camera.forward *= 2.0));
    assert!(refused(&|w| w.sky = Sky::Uniform([0.0, f64::NAN, 0.0])));
    assert!(refused(&|w| w.ground.albedo = worlds::ground([0.0, 0.0, 1.5])));
    assert!(refused(&|w| w.base_m = -1.0));
    for stop in [
        Stop::Samples(0),
        Stop::Samples(1),
        Stop::Target { error: 0.0, at_most: 9 },
        Stop::Target { error: f64::NAN, at_most: 9 },
        Stop::Seconds(f64::NAN),
        Stop::Seconds(-1.0),
    ] {
        let request = Request { stop, ..request };
        assert!(matches!(trace(&good, &request), Err(PathtraceError::Domain(_))), "{stop:?}");
    }
    for (x, y, width, height) in
        [(0, 0, 0, 1), (8, 0, 1, 1), (5, 0, 4, 1), (0, 0, 1, 7), (usize::MAX, 0, 2, 1)]
    {
        let request = Request { crop: Some(Crop { x, y, width, height }), ..request };
        assert!(matches!(trace(&good, &request), Err(PathtraceError::Crop { .. })));
    }
    assert!(HeightField::new(Map::new(1, 1.0, vec![f64::NAN]).unwrap()).is_err());
}

/// Towards the sun just over the horizon, through tens of kilometres of cloud.
#[test]
fn long_ways_through_the_cloud_are_numbers() {
    let mut world = lit();
    world.sun.direction = worlds::towards(89.5, 90.0);
    world.camera = worlds::camera(DVec3::new(0.0, 0.0, 900.0), worlds::towards(89.0, 92.0), 0.05, 8, 6);
    world.field = HeightField::flat(500.0, 1000.0).unwrap();
    let truth = samples(&world, 20);
    assert!(truth.mean.pixels().iter().flatten().all(|x| x.is_finite() && *x >= 0.0));
}

/// A function without any light below θ_f, and one that is the same everywhere, are no special cases.
#[test]
fn phase_functions_without_a_peak_are_traced() {
    let cut = worlds::paper().modified(5.0).unwrap();
    let flat = PhaseTable::new(vec![0.0, 180.0], vec![1.0, 1.0], Norm::Strict).unwrap();
    for phase in [cut, flat] {
        let mut world = lit();
        world.material = worlds::material([phase.clone(), phase.clone(), phase]);
        world.material.single_scattering_albedo = 0.9;
        let truth = samples(&world, 8);
        assert!(truth.mean.pixels().iter().flatten().all(|x| x.is_finite() && *x >= 0.0));
    }
}
