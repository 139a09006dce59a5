//! The path tracer on a flat layer against the deterministic solver: same droplets, same slab, no ground, no sky.

#![allow(clippy::unwrap_used, reason = "a test may stop where it fails")]

use glam::DVec3;
use std::f64::consts::PI;
use std::path::PathBuf;
use stratiform_cli::pipeline::reference::Media;
use stratiform_optics::phase::PhaseTable;
use stratiform_pathtrace::{Request, Stop, trace};
use stratiform_quantities::{ExtinctionConvention, Medium, Order, Side};
use stratiform_stats::{Estimate, family_threshold, z_score};
use stratiform_tests::{accepted_cloud, paper_config};
use stratiform_transport::solve::{RadianceOrder, RadianceSolver, View};
use stratiform_world::{Camera, Ground, HeightField, Map, Material, Sky, Sun, World};

const KAPPA: f64 = 0.046_18;

/// Side, degrees from the normal, azimuth: the nadir, the glory, the fogbow, forward and grazing views; the sun's aureole.
fn views(theta_l: f64) -> Vec<(Side, f64, f64)> {
    vec![
        (Side::Top, 0.0, 0.0),
        (Side::Top, theta_l - 2.0, 180.0),
        (Side::Top, 142.0 - 90.0 - theta_l.min(50.0), 180.0),
        (Side::Top, 60.0, 0.0),
        (Side::Top, 75.0, 90.0),
        (Side::Bottom, 0.0, 0.0),
        (Side::Bottom, theta_l + 2.0, 0.0),
        (Side::Bottom, theta_l - 4.0, 0.0),
        (Side::Bottom, theta_l + 12.0, 0.0),
        (Side::Bottom, 60.0, 90.0),
        (Side::Bottom, 40.0, 180.0),
    ]
}

fn material(phase: &PhaseTable) -> Material {
    let colour = [phase.clone(), phase.clone(), phase.clone()];
    Material {
        generated: PathBuf::new(),
        extinction_per_m: KAPPA,
        extinction_convention: ExtinctionConvention::Paper,
        single_scattering_albedo: 1.0,
        asymmetry: 0.85,
        theta_f_deg: 5.0,
        forward_fraction: phase.forward_fraction(5.0).unwrap(),
        phase: phase.clone(),
        colour_squared: colour.clone(),
        colour,
    }
}

/// Looks along the light that leaves `side` at `theta` and `phi`; the sun's light travels towards +x.
fn world(phase: &PhaseTable, tau: f64, theta_l: f64, (side, theta, phi): (Side, f64, f64)) -> World {
    let (sine, cosine) = libm::sincos(theta.to_radians());
    let (y, x) = libm::sincos(phi.to_radians());
    let up = if side == Side::Top { 1.0 } else { -1.0 };
    let travel = DVec3::new(sine * x, sine * y, up * cosine);
    let forward = -travel;
    let (right, above) = forward.any_orthonormal_pair();
    let position = DVec3::new(0.0, 0.0, if side == Side::Top { 5000.0 } else { 500.0 });
    let (sine, cosine) = libm::sincos(theta_l.to_radians());
    World {
        camera: Camera { position, forward, right, up: above, tan_half: 1e-7, width: 16, height: 16 },
        sun: Sun {
            direction: DVec3::new(-sine, 0.0, cosine),
            irradiance: [1.0; 3],
            angular_radius_deg: 0.266,
        },
        sky: Sky::Uniform([0.0; 3]),
        ground: Ground { albedo: Map::new(1, 1000.0, vec![[0.0; 3]]).unwrap() },
        base_m: 1000.0,
        field: HeightField::flat(tau / KAPPA, 1000.0).unwrap(),
        material: material(phase),
    }
}

/// Mean of all pixels, as a reflectance factor.
fn factor(world: &World, samples: u64, seed: u64) -> Estimate {
    let truth = trace(world, &Request { stop: Stop::Samples(samples), crop: None, seed }).unwrap();
    let n = truth.mean.pixels().len() as f64;
    let value = truth.mean.pixels().iter().fold(0.0, |sum, p| sum + f64::from(p[1])) / n;
    let variance = truth.std_error.pixels().iter().fold(0.0, |sum, p| sum + f64::from(p[1] * p[1]));
    let scale = PI / world.sun.direction.z;
    Estimate { value: scale * value, std_error: scale * variance.sqrt() / n }
}

#[test]
fn radiance_of_a_flat_layer_is_the_solvers() {
    let config = paper_config();
    let (_, cloud) = accepted_cloud(&config);
    let media = Media::new(&config, &cloud).unwrap();
    let solver = RadianceSolver::new(media.get(Medium::Full).into(), 1e-3).unwrap();
    let samples = std::env::var("SAMPLES").map_or(40, |s| s.parse().unwrap());
    for theta_l in [30.0_f64, 60.0] {
        let mu0 = libm::cos(theta_l.to_radians());
        for tau in [2.0, 16.0] {
            let list = views(theta_l);
            let asked: Vec<View> = list
                .iter()
                .map(|&(side, theta, phi_deg)| View { side, mu: libm::cos(theta.to_radians()), phi_deg })
                .collect();
            let solved = solver.radiance_as_reached(RadianceOrder::Total, &[tau], &[mu0], &asked).unwrap();
            for (i, view) in list.iter().enumerate() {
                let expected = solved.estimate(0, 0, i, RadianceOrder::Total);
                let found = factor(&world(&cloud.phase, tau, theta_l, *view), samples, 1);
                println!(
                    "{theta_l} {tau} {view:?}: {:.5} +- {:.5} solver {:.5} +- {:.5} ratio {:.4} z {:.2}",
                    found.value,
                    found.std_error,
                    expected.value,
                    expected.std_error,
                    found.value / expected.value,
                    z_score(found, expected)
                );
            }
        }
    }
    let _ = (family_threshold(1e-3, 44), Order::Total);
}
