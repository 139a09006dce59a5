//! The clear sky against the deterministic solver, where both know the air; and what must hold of any sky.
#![allow(clippy::unwrap_used, reason = "a test may stop where it fails")]

mod solved_sky;

use solved_sky::{direction, hemisphere, solvable_air, solved};
use stratiform_world::{Air, ClearSky, Sky};

/// Root mean square and largest difference of a channel over the mean of the sky, at a sun's elevation.
fn difference(air: &Air, elevation_deg: f64) -> (f64, f64) {
    let sine = libm::sin(elevation_deg.to_radians());
    let views = hemisphere();
    let truth = solved(sine, &views);
    let sky = Sky::Clear(ClearSky::new(direction(sine, 0.0), air).unwrap());
    let mean = truth.iter().flatten().sum::<f64>() / (3 * truth.len()) as f64;
    let mut squares = 0.0;
    let mut most: f64 = 0.0;
    for ((sine, azimuth), expected) in views.iter().zip(&truth) {
        let found = sky.radiance(direction(*sine, *azimuth));
        for c in 0..3 {
            let off = (found[c] - expected[c]) / mean;
            squares += off * off;
            most = most.max(off.abs());
        }
    }
    ((squares / (3 * truth.len()) as f64).sqrt(), most)
}

#[test]
fn a_flat_sky_of_molecules_is_the_solvers() {
    for elevation in [10.0, 30.0, 60.0, 85.0] {
        let (rms, most) = difference(&solvable_air(), elevation);
        println!("{elevation} {rms:.5} {most:.5}");
        assert!(rms < 2e-3 && most < 1e-2, "{elevation}: {rms} {most}");
    }
}

/// The comparison sees 3 % of aerosol, or light from the ground.
#[test]
fn other_air_is_told_apart() {
    for air in [Air { turbidity: 1.03, ..solvable_air() }, Air { ground_albedo: 0.1, ..solvable_air() }] {
        let (rms, _) = difference(&air, 30.0);
        assert!(rms > 1e-2, "{rms}");
    }
}
