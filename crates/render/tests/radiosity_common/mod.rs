//! Small worlds for the tests of the light between ground and cloud.

#![allow(dead_code, reason = "every test binary uses its part")]

use glam::DVec3;
use std::path::PathBuf;
use stratiform_optics::phase::{Norm, PhaseTable};
use stratiform_quantities::ExtinctionConvention;
use stratiform_world::{Camera, Ground, HeightField, Map, Material, Sky, Sun, World};

/// The paper's: base, extent.
pub const BASE_M: f64 = 2000.0;
pub const EXTENT_M: f64 = 16000.0;

/// The folder of the paper's cloud.
pub fn folder() -> PathBuf {
    PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/../../fit-configs/appendix-b/generated"))
}

pub fn material() -> Material {
    let phase = || PhaseTable::new(vec![0.0, 90.0, 180.0], vec![1.0; 3], Norm::Any).unwrap();
    Material {
        generated: folder(),
        extinction_per_m: 0.046181412007769956,
        extinction_convention: ExtinctionConvention::Paper,
        single_scattering_albedo: 1.0,
        asymmetry: 0.8533984394264672,
        theta_f_deg: 5.0,
        forward_fraction: 0.45471621933196255,
        phase: phase(),
        colour: [phase(), phase(), phase()],
        colour_squared: [phase(), phase(), phase()],
    }
}

/// Towards the sun, degrees from the zenith and clockwise from north.
pub fn towards(theta_deg: f64, azimuth_deg: f64) -> DVec3 {
    let (theta, azimuth) = (theta_deg.to_radians(), azimuth_deg.to_radians());
    let across = libm::sin(theta);
    DVec3::new(across * libm::sin(azimuth), across * libm::cos(azimuth), libm::cos(theta))
}

/// A broken layer over patches of land and ice, under the paper's sky.
pub fn world(field: Map<f64>, albedo: Map<[f64; 3]>) -> World {
    let camera = Camera {
        position: DVec3::new(0.0, 0.0, 2.0),
        forward: DVec3::Y,
        right: DVec3::X,
        up: DVec3::Z,
        tan_half: 0.5,
        width: 32,
        height: 18,
    };
    World {
        camera,
        sun: Sun {
            direction: towards(50.0, 120.0),
            irradiance: [1.02, 1.0, 0.94],
            angular_radius_deg: 0.265,
        },
        sky: Sky::Uniform([0.06, 0.08, 0.11]),
        ground: Ground { albedo },
        base_m: BASE_M,
        field: HeightField::new(field).unwrap(),
        material: material(),
    }
}

/// 0..1 from a count, the same everywhere.
pub fn uniform(seed: u64, i: u64) -> f64 {
    let mut z = (seed << 32 | i).wrapping_add(0x9E37_79B9_7F4A_7C15).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    z = (z ^ (z >> 31)).wrapping_mul(0x94D0_49BB_1331_11EB);
    (z ^ (z >> 29)) as f64 / u64::MAX as f64
}

/// A smooth periodic field of mean 0 and spread near 1, `side` x `side` values: 24 waves of 1 to `finest` periods each way.
pub fn waves(seed: u64, side: usize, finest: i32) -> Vec<f64> {
    let draw = |i: u64| uniform(seed, i);
    let wave = |k: u64| {
        let span = f64::from(2 * finest + 1);
        let number = |i| libm::floor(draw(i) * span) - f64::from(finest);
        (number(3 * k), number(3 * k + 1), std::f64::consts::TAU * draw(3 * k + 2))
    };
    let waves: Vec<_> = (0..24).map(wave).collect();
    let turn = std::f64::consts::TAU / side as f64;
    let at = |i: usize| {
        let (x, y) = ((i % side) as f64 + 0.5, (i / side) as f64 + 0.5);
        waves.iter().map(|(u, v, phase)| libm::cos(turn * (u * x + v * y) + phase)).sum::<f64>()
            / 12.0_f64.sqrt()
    };
    (0..side * side).map(at).collect()
}

/// Thickness 0 to 500 m, with gaps.
pub fn clouds(seed: u64, side: usize) -> Map<f64> {
    let thickness = waves(seed, side, 6).iter().map(|h| (120.0 + 150.0 * h).clamp(0.0, 500.0)).collect();
    Map::new(side, EXTENT_M, thickness).unwrap()
}

/// Ice of albedo 0.8 in land of 0.15, 0.2, 0.1.
pub fn ice_in_land(seed: u64, side: usize) -> Map<[f64; 3]> {
    let albedo = |h: &f64| if *h > 0.8 { [0.8, 0.82, 0.85] } else { [0.15, 0.2, 0.1] };
    Map::new(side, EXTENT_M, waves(seed, side, 3).iter().map(albedo).collect()).unwrap()
}

/// Largest difference of two maps, and the largest value of the second.
pub fn difference(found: &[[f64; 3]], expected: &[[f64; 3]]) -> (f64, f64) {
    assert_eq!(found.len(), expected.len());
    let pairs = found.iter().flatten().zip(expected.iter().flatten());
    pairs.fold((0.0, 0.0), |(off, most), (a, b)| (f64::max(off, (a - b).abs()), f64::max(most, b.abs())))
}
