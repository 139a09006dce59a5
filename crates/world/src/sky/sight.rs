//! Radiance along a line of sight through the air, at all wavelengths.
//!
//! L = ∫ T(t) [k_m (P_R E'/4π + D) + k_a ω((1-g) J + P_HG E/4π)] dt round the earth. Order 1 of molecules and all further orders
//! D, J ([`diffuse`](super::diffuse)) are seen in air whose aerosol counts with 1 - ωg, order 1 of aerosol in air as it
//! is: what aerosol scatters forwards once is kept, what it does so twice is lost. Ozone takes light from the sun's path, and from
//! what is above it. Left out: refraction, and polarisation.

use super::air::{Air, Columns, Slant, WAVELENGTHS_UM, ozone_mass};
use super::diffuse::{Diffuse, TOP_M, rayleigh};
use std::f64::consts::PI;

/// Steps of a line of sight; their lengths grow with the distance.
const STEPS: usize = 48;

const COUNT: usize = WAVELENGTHS_UM.len();

/// Air, its light, and the sun's cosine.
pub(super) struct Lit<'a> {
    pub(super) air: &'a Air,
    pub(super) columns: [Columns; COUNT],
    pub(super) diffuse: [Diffuse; COUNT],
    pub(super) sun: f64,
}

/// A point on the line of sight.
struct Point {
    altitude_m: f64,
    /// Cosines of view and sun to the vertical there, and of the azimuth between them.
    view: f64,
    sun: f64,
    azimuth: f64,
    step_m: f64,
}

impl<'a> Lit<'a> {
    pub(super) fn new(air: &'a Air, sun: f64) -> Self {
        let columns = air.columns();
        Self { air, columns, diffuse: columns.map(|columns| Diffuse::new(air, &columns, sun)), sun }
    }

    /// What reaches the viewer from the sun itself, per irradiance above the air.
    pub(super) fn beam(&self) -> [f64; COUNT] {
        let slant = Slant::new(self.air, self.air.altitude_m, self.sun);
        self.columns.map(|columns| slant.map_or(0.0, |slant| libm::exp(-slant.thickness(&columns, 1.0))))
    }

    /// Radiance from the direction with that sine of the elevation and cosine of the azimuth from the sun's.
    pub(super) fn radiance(&self, sine: f64, azimuth: f64) -> [f64; COUNT] {
        let across = |mu: f64| (1.0 - mu * mu).max(0.0).sqrt();
        let cos_scattering = sine * self.sun + across(sine) * across(self.sun) * azimuth;
        let mut sum = [0.0; COUNT];
        let mut depth = [[0.0; 2]; COUNT];
        let mut below_ozone = true;
        for i in 0..STEPS {
            let point = self.point(i, sine, cos_scattering);
            if below_ozone && point.altitude_m > self.air.ozone_height_m {
                below_ozone = false;
                let mass = ozone_mass(self.air, self.air.radius_m + self.air.altitude_m, sine);
                (0..COUNT).for_each(|k| depth[k].iter_mut().for_each(|d| *d += self.columns[k].ozone * mass));
            }
            self.add(&point, cos_scattering, &mut depth, &mut sum);
        }
        sum
    }

    fn point(&self, i: usize, sine: f64, cos_scattering: f64) -> Point {
        let radius = self.air.radius_m + self.air.altitude_m;
        let rise = (2.0 * self.air.radius_m + TOP_M + self.air.altitude_m) * (TOP_M - self.air.altitude_m);
        let end = rise / (radius * sine + (radius * radius * sine * sine + rise).sqrt());
        let share = |x: f64| x * x / (STEPS * STEPS) as f64;
        let i = i as f64;
        let t = end * share(i + 0.5);
        let gained = 2.0 * radius * t * sine + t * t;
        let there = (radius * radius + gained).sqrt();
        // Rounding may lead beyond the zenith.
        let view = ((radius * sine + t) / there).min(1.0);
        let sun = ((radius * self.sun + t * cos_scattering) / there).min(1.0);
        let flat = ((1.0 - view * view) * (1.0 - sun * sun)).max(0.0).sqrt();
        let azimuth =
            if flat > 1e-12 { ((cos_scattering - view * sun) / flat).clamp(-1.0, 1.0) } else { 0.0 };
        let altitude_m = self.air.altitude_m + gained / (there + radius);
        Point { altitude_m, view, sun, azimuth, step_m: end * (share(i + 1.0) - share(i)) }
    }

    /// The light of one step; `depth` are the optical thicknesses up to it with all of the aerosol, and with 1 - ωg of it.
    fn add(&self, point: &Point, cos_scattering: f64, depth: &mut [[f64; 2]; COUNT], sum: &mut [f64; COUNT]) {
        let air = self.air;
        let density = |height: f64| libm::exp(-point.altitude_m / height) / height;
        let [molecules, aerosol] = [air.molecules_height_m, air.aerosol_height_m].map(density);
        let slant = Slant::new(air, point.altitude_m, point.sun);
        let p_molecules = 0.75 * (1.0 + cos_scattering * cos_scattering) / (4.0 * PI);
        let p_aerosol = henyey_greenstein(air.aerosol_asymmetry, cos_scattering) / (4.0 * PI);
        let similar = air.similar_share();
        for k in 0..COUNT {
            let columns = &self.columns[k];
            let [k_m, k_a] = [columns.molecules * molecules, columns.aerosol * aerosol];
            let light = |share: f64| slant.map_or(0.0, |slant| libm::exp(-slant.thickness(columns, share)));
            let moments = self.diffuse[k].at(point.altitude_m);
            let many = k_m * (p_molecules * light(similar) + rayleigh(moments, point.view, point.azimuth))
                + k_a * air.aerosol_albedo * (1.0 - air.aerosol_asymmetry) * moments[0];
            let once = k_a * air.aerosol_albedo * p_aerosol * light(1.0);
            for (which, (source, extinction)) in
                [(once, k_m + k_a), (many, k_m + similar * k_a)].into_iter().enumerate()
            {
                let thickness = extinction * point.step_m;
                let seen = if thickness > 0.0 { -libm::expm1(-thickness) / extinction } else { 0.0 };
                sum[k] += libm::exp(-depth[k][which]) * source * seen;
                depth[k][which] += thickness;
            }
        }
    }
}

fn henyey_greenstein(g: f64, cosine: f64) -> f64 {
    let square = 1.0 + g * g - 2.0 * g * cosine;
    (1.0 - g * g) / (square * square.sqrt())
}
