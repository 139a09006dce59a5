//! The sky of a plane layer of molecules by the deterministic solver, wavelength by wavelength, in linear sRGB.

use glam::DVec3;
use std::sync::Arc;
use stratiform_optics::phase::Rayleigh;
use stratiform_quantities::{Side, SingleScatteringAlbedo};
use stratiform_tables::colour::channel_weights;
use stratiform_transport::solve::{RadianceOrder, RadianceSolver, SolveMedium, View};
use stratiform_world::Air;

/// λ, µm.
const WAVELENGTHS_UM: [f64; 9] = [0.39, 0.43, 0.47, 0.51, 0.55, 0.59, 0.63, 0.67, 0.71];

/// Air that the solver knows: molecules alone, a flat earth, black ground, seen from the ground.
pub fn solvable_air() -> Air {
    Air {
        turbidity: 1.0,
        ground_albedo: 0.0,
        altitude_m: 0.0,
        radius_m: 1e12,
        ozone_cm: 0.0,
        ..Air::default()
    }
}

/// Radiances at (sine of the elevation, azimuth from the sun's in degrees), over the luminance of the sun at the ground.
pub fn solved(sun_sine: f64, views: &[(f64, f64)]) -> Vec<[f64; 3]> {
    let medium = SolveMedium::full(Arc::new(Rayleigh), SingleScatteringAlbedo::CONSERVATIVE);
    let solver = RadianceSolver::new(medium, 1e-3).unwrap();
    let tau = WAVELENGTHS_UM.map(Air::molecules_thickness);
    let asked: Vec<View> =
        views.iter().map(|(mu, phi_deg)| View { side: Side::Bottom, mu: *mu, phi_deg: *phi_deg }).collect();
    let radiances = solver.radiance(&tau, &[sun_sine], &asked).unwrap();
    let weights = channel_weights(&WAVELENGTHS_UM).unwrap();
    let colour = |of: &dyn Fn(usize) -> f64| -> [f64; 3] {
        std::array::from_fn(|c| (0..tau.len()).fold(0.0, |sum, k| sum + weights[k][c] * of(k)))
    };
    let beam = colour(&|k| libm::exp(-tau[k] / sun_sine));
    let luminance = 0.2126 * beam[0] + 0.7152 * beam[1] + 0.0722 * beam[2];
    let factor = sun_sine / std::f64::consts::PI / luminance;
    let of_view = |v: usize| {
        colour(&|k| radiances.estimate(k, 0, v, RadianceOrder::Total).value).map(|value| value * factor)
    };
    (0..views.len()).map(of_view).collect()
}

/// Unit vector at that sine of the elevation, clockwise from the north.
pub fn direction(sine: f64, azimuth_deg: f64) -> DVec3 {
    let across = (1.0 - sine * sine).sqrt();
    let azimuth = azimuth_deg.to_radians();
    DVec3::new(across * libm::sin(azimuth), across * libm::cos(azimuth), sine)
}

/// Sines of the elevation in the middles of equal solid angles, with azimuths; and the zenith.
pub fn hemisphere() -> Vec<(f64, f64)> {
    let sines = (0..8).map(|i| (f64::from(i) + 0.5) / 8.0);
    sines.flat_map(|sine| (0..7).map(move |j| (sine, 30.0 * f64::from(j)))).chain([(1.0, 0.0)]).collect()
}
