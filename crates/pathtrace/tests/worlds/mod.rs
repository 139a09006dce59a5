//! Small worlds of tests.

#![allow(dead_code, reason = "each test file uses some of them")]
#![allow(clippy::unwrap_used, reason = "a test may stop where it fails")]

use glam::DVec3;
use std::path::{Path, PathBuf};
use stratiform_optics::phase::{HenyeyGreenstein, Norm, PhaseFunction, PhaseTable, versine};
use stratiform_quantities::{Asymmetry, ExtinctionConvention};
use stratiform_world::{Camera, Ground, HeightField, Map, Material, Sky, Sun, World};

/// The paper's cloud at 0.55 µm.
pub fn paper() -> PhaseTable {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../fit-configs/appendix-b/accepted/phase_full.csv");
    PhaseTable::read(Path::new(path), Norm::Strict).unwrap()
}

pub fn isotropic() -> PhaseTable {
    PhaseTable::new(vec![0.0, 180.0], vec![1.0, 1.0], Norm::Strict).unwrap()
}

pub fn henyey_greenstein(g: f64) -> PhaseTable {
    let phase = HenyeyGreenstein::new(Asymmetry::new(g).unwrap());
    let theta: Vec<f64> = (0..=1440).map(|i| 180.0 * libm::pow(f64::from(i) / 1440.0, 2.0)).collect();
    let p = theta.iter().map(|t| phase.value(versine(t.to_radians()))).collect();
    PhaseTable::new(theta, p, Norm::Any).unwrap()
}

/// A lossless material; κ of the paper's cloud.
pub fn material(colour: [PhaseTable; 3]) -> Material {
    let phase = colour[1].clone();
    Material {
        generated: PathBuf::new(),
        extinction_per_m: 0.046_18,
        extinction_convention: ExtinctionConvention::Paper,
        single_scattering_albedo: 1.0,
        asymmetry: phase.asymmetry(),
        theta_f_deg: 5.0,
        forward_fraction: phase.forward_fraction(5.0).unwrap(),
        phase,
        colour_squared: colour.clone(),
        colour,
    }
}

/// The direction at `theta_deg` from the zenith and `azimuth_deg` clockwise from north.
pub fn towards(theta_deg: f64, azimuth_deg: f64) -> DVec3 {
    let (sine, cosine) = libm::sincos(theta_deg.to_radians());
    let (east, north) = libm::sincos(azimuth_deg.to_radians());
    DVec3::new(sine * east, sine * north, cosine)
}

/// A camera of `width` by `height` pixels, `tan_half` wide.
pub fn camera(position: DVec3, forward: DVec3, tan_half: f64, width: usize, height: usize) -> Camera {
    let (right, up) = forward.any_orthonormal_pair();
    Camera { position, forward, right, up, tan_half, width, height }
}

/// A layer at 1000 m, the sun at 40 degrees, no sky, black ground, seen from below.
pub fn world(field: HeightField, colour: [PhaseTable; 3]) -> World {
    World {
        camera: camera(DVec3::new(10.0, 20.0, 2.0), towards(30.0, 70.0), 0.5, 8, 6),
        sun: Sun { direction: towards(40.0, 200.0), irradiance: [1.0; 3], angular_radius_deg: 0.266 },
        sky: Sky::Uniform([0.0; 3]),
        ground: Ground { albedo: ground([0.0; 3]) },
        base_m: 1000.0,
        field,
        material: material(colour),
    }
}

pub fn ground(albedo: [f64; 3]) -> Map<[f64; 3]> {
    Map::new(1, 1000.0, vec![albedo]).unwrap()
}

/// Bumps 0 to 500 m high over 2 km, with gaps.
pub fn bumpy(side: usize) -> HeightField {
    let wave = |x: f64, y: f64| {
        let at = |k: f64, phase: f64| libm::sin(2.0 * std::f64::consts::PI * k + phase);
        at(x, 0.3) * at(2.0 * y, 1.0) + 0.5 * at(3.0 * x + y, 2.0) + 0.4 * at(5.0 * y - 2.0 * x, 0.7)
    };
    let of = |i: usize| {
        let (x, y) = ((i % side) as f64 / side as f64, (i / side) as f64 / side as f64);
        (220.0 + 200.0 * wave(x, y)).clamp(0.0, 500.0)
    };
    HeightField::new(Map::new(side, 2000.0, (0..side * side).map(of).collect()).unwrap()).unwrap()
}
