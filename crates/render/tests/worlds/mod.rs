//! Worlds made by hand.

#![allow(dead_code, reason = "each test takes what it needs")]

use glam::DVec3;
use std::path::{Path, PathBuf};
use stratiform_artifact::read_csv;
use stratiform_optics::phase::{Norm, PhaseTable};
use stratiform_quantities::ExtinctionConvention;
use stratiform_world::{Camera, Ground, HeightField, Map, Material, Sky, Sun, World};

/// Period of the fields, m.
pub const EXTENT: f64 = 4000.0;

/// Altitude of the base, m.
pub const BASE: f64 = 1000.0;

#[derive(serde::Serialize, serde::Deserialize)]
struct Row {
    theta_deg: f64,
    p: f64,
}

pub fn generated() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fit-configs/appendix-b/generated")
}

fn table(name: &str, tilt: f64) -> PhaseTable {
    let rows: Vec<Row> = read_csv(&generated().join(name)).unwrap();
    let theta: Vec<f64> = rows.iter().map(|row| row.theta_deg).collect();
    // A tilt makes channels differ; the norm is put right again.
    let p = rows.iter().map(|row| row.p * (1.0 + tilt * row.theta_deg / 180.0)).collect();
    PhaseTable::new(theta, p, Norm::Any).unwrap()
}

/// The paper's cloud; `tilt` tells its channels apart.
pub fn material(tilt: f64) -> Material {
    let channels = |name: &str| [-tilt, 0.0, tilt].map(|tilt| table(name, tilt));
    Material {
        generated: generated(),
        extinction_per_m: 0.046_181_412_007_769_956,
        extinction_convention: ExtinctionConvention::Paper,
        single_scattering_albedo: 1.0,
        asymmetry: 0.853_398_439_426_467_2,
        theta_f_deg: 5.0,
        forward_fraction: 0.454_716_219_331_962_55,
        phase: table("phase_full.csv", 0.0),
        colour: channels("phase_full.csv"),
        colour_squared: channels("phase_squared.csv"),
    }
}

/// Rounded hills of up to `most` metres with clear air between them.
pub fn hills(side: usize, most: f64) -> HeightField {
    let at = |index: usize| {
        let turn = |i: usize| std::f64::consts::TAU * (i as f64 + 0.5) / side as f64;
        let (x, y) = (turn(index % side), turn(index / side));
        let waves = libm::sin(2.0 * x + 0.5) * libm::cos(3.0 * y) + 0.4 * libm::sin(5.0 * x + 4.0 * y);
        (most * (0.35 + 0.5 * waves)).clamp(0.0, most)
    };
    HeightField::new(Map::new(side, EXTENT, (0..side * side).map(at).collect()).unwrap()).unwrap()
}

pub fn flat(thickness: f64) -> HeightField {
    HeightField::flat(thickness, EXTENT).unwrap()
}

fn direction(azimuth_deg: f64, elevation_deg: f64) -> DVec3 {
    let (a, e) = (azimuth_deg.to_radians(), elevation_deg.to_radians());
    DVec3::new(libm::cos(e) * libm::sin(a), libm::cos(e) * libm::cos(a), libm::sin(e))
}

/// A camera at a height, 40 by 30 degrees and more or less level.
pub fn camera(height: f64, elevation_deg: f64, [width, pixels]: [usize; 2]) -> Camera {
    let forward = direction(30.0, elevation_deg);
    let right = direction(120.0, 0.0);
    Camera {
        position: DVec3::new(1100.0, 700.0, height),
        forward,
        right,
        up: right.cross(forward),
        tan_half: 0.6,
        width,
        height: pixels,
    }
}

/// Below the cloud, looking up over the horizon.
pub fn below(size: [usize; 2]) -> Camera {
    camera(2.0, 25.0, size)
}

/// Above it, looking down to the horizon.
pub fn above(size: [usize; 2]) -> Camera {
    camera(2500.0, -25.0, size)
}

/// In the clear air of a gap between the hills, 250 m above the base, looking along the layer.
pub fn between(size: [usize; 2]) -> Camera {
    Camera { position: DVec3::new(343.75, 3343.75, BASE + 250.0), ..camera(BASE, 3.0, size) }
}

pub fn world(field: HeightField, camera: Camera, tilt: f64) -> World {
    World {
        camera,
        sun: Sun {
            direction: direction(40.0, 35.0),
            irradiance: [1.0, 0.95, 0.85],
            angular_radius_deg: 0.2666,
        },
        sky: Sky::Uniform([0.06, 0.08, 0.11]),
        ground: Ground { albedo: Map::new(1, EXTENT, vec![[0.2, 0.22, 0.15]]).unwrap() },
        base_m: BASE,
        field,
        material: material(tilt),
    }
}
