//! Energy: over a lossless layer on white ground all sunlight returns, π mean L = μ0 F0 with rays by the cosine law from all over a period.

#[path = "../tests/worlds/mod.rs"]
mod worlds;

use crate::layer::Ray;
use crate::path;
use crate::random::{cosine, uniform};
use crate::scene::Scene;
use glam::DVec3;
use rayon::prelude::*;
use std::f64::consts::PI;
use stratiform_imaging::srgb::luminance;
use stratiform_optics::phase::PhaseTable;
use stratiform_stats::{Estimate, Purpose, key, photon_stream};
use stratiform_world::{HeightField, World};

/// Light that returns over light that came, from `paths` paths.
fn returned(scene: &Scene<'_>, paths: u64) -> Estimate {
    let key = key(17, Purpose::Picture);
    let shares: Vec<f64> = (0..paths)
        .into_par_iter()
        .map(|i| {
            let mut rng = photon_stream(key, i);
            let down = cosine(&mut rng) * DVec3::new(1.0, 1.0, -1.0);
            let origin = DVec3::new(2000.0 * uniform(&mut rng), 2000.0 * uniform(&mut rng), 2500.0);
            let light = path::trace(scene, Ray { origin, direction: down }, &mut rng);
            PI * luminance(light.total()) / scene.world.sun.direction.z
        })
        .collect();
    let n = paths as f64;
    let mean = shares.iter().fold(0.0, |sum, x| sum + x) / n;
    let square = shares.iter().fold(0.0, |sum, x| sum + (x - mean) * (x - mean));
    Estimate { value: mean, std_error: square.sqrt() / n }
}

fn white(field: HeightField, colour: [PhaseTable; 3]) -> World {
    let mut world = worlds::world(field, colour);
    world.ground.albedo = worlds::ground([1.0; 3]);
    world
}

/// Within 4 standard errors of at most 1 %: one false alarm in 16 000 each.
#[test]
fn all_sunlight_returns() {
    let paper = || [worlds::paper(), worlds::paper(), worlds::paper()];
    let coloured = [0.83, 0.85, 0.87].map(worlds::henyey_greenstein);
    let flat = HeightField::flat(200.0, 2000.0).unwrap();
    for world in [white(flat, paper()), white(worlds::bumpy(32), paper()), white(worlds::bumpy(32), coloured)]
    {
        let share = returned(&Scene::new(&world).unwrap(), 40_000);
        assert!((share.value - 1.0).abs() < 4.0 * share.std_error && share.std_error < 0.012, "{share:?}");
    }
}

/// Light that is scattered alike in all directions, by less than 80° called forward: 2 % more of that in the extinction of the last leg
/// are 1.4 % more light, which 4 standard errors see and without which they see nothing.
#[test]
fn a_planted_error_of_the_forward_share_is_rejected() {
    let isotropic = || worlds::isotropic();
    let mut world = white(HeightField::flat(100.0, 2000.0).unwrap(), [isotropic(), isotropic(), isotropic()]);
    world.material.theta_f_deg = 80.0;
    let mut scene = Scene::new(&world).unwrap();
    let honest = returned(&scene, 300_000);
    assert!((honest.value - 1.0).abs() < 4.0 * honest.std_error, "{honest:?}");
    scene.forward = scene.forward.map(|forward| 1.02 * forward);
    let planted = returned(&scene, 300_000);
    assert!(planted.value - 1.0 > 4.0 * planted.std_error, "{planted:?}");
}
