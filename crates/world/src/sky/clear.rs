//! A clear sky.
//!
//! Order 1 round the earth, further orders of scalar Rayleigh scattering exactly in plane layers, nine wavelengths, D65 as the sun
//! above the air. Units: the sun's irradiance normal to its beam has luminance 1 where the sky is seen from.
//!
//! **How good** (`cargo bench -p stratiform-world --bench sky`; relative to the sky's mean). Against the deterministic solver
//! in air that both know (molecules, flat, black ground), table included: rms 6e-4 to 9e-4 with the sun at 85° to 5° above the horizon,
//! 1e-3 to 2e-3 at 1° above it. Left out: the earth's roundness in the further orders (all of it matters 2 to 3 % down to suns of 30°,
//! 5 % at 10°, 29 % at 5°, where order 1 dominates what is left); polarisation, which at τ = 0.5, 1.3 times blue air, changes
//! single directions by 4 to 10 % (`tests/sky.rs`); refraction. Below 5° take it for a picture, not for a measurement.
//!
//! **Why not the model of Hosek & Wilkie (2012)**, crate `hw-skymodel` 0.1.1: fitted to a path tracer, 30 numbers a sky and no table to
//! build. In pure air its shape, level and white taken out, is off by rms 0.15 (sun at 85°) to 0.25 (5°), and its level
//! against the sun's drifts by 28 %; with T = 2, its aerosol being another, half of all values differ from ours by more than 27 to 48 %.
//! And it has no altitude of the viewer, no colour of the sun, no unit shared with it. It needs no table: ours is 48 KiB, built in
//! 0.2 s (two cores, shared) whenever the sun moves.

use super::air::{Air, WAVELENGTHS_UM};
use super::sight::Lit;
use super::table::SkyTable;
use crate::WorldError;
use glam::DVec3;
use std::f64::consts::PI;
use stratiform_quantities::Range;
use stratiform_tables::colour::channel_weights;

/// Columns and rows of the table.
const SIZE: [usize; 2] = [64, 64];

/// Luminance of linear sRGB, IEC 61966-2-1.
const LUMINANCE: [f64; 3] = [0.2126, 0.7152, 0.0722];

/// Less of the sun is no unit to measure a sky in.
const LEAST_SUN: Range = Range::closed(1e-4, 1.0);

/// Radiance of a clear sky, per luminance of the sun's irradiance normal to its beam at the place that it is seen from.
#[derive(Clone, Debug, PartialEq)]
pub struct ClearSky {
    air: Air,
    table: SkyTable,
    sun_irradiance: [f64; 3],
    irradiance: [f64; 3],
    sun_transmittance: f64,
}

impl ClearSky {
    /// With the sun in that direction.
    ///
    /// # Errors
    /// [`WorldError::Domain`] for a sun that is not above the horizon or of which the air leaves less than 1e-4, or numbers of `air` outside
    /// their range.
    pub fn new(sun: DVec3, air: &Air) -> Result<Self, WorldError> {
        air.check()?;
        let sine = Range { max_included: true, ..Range::open(0.0, 1.0) }
            .check("sine of the sun's elevation", sun.normalize().z)?;
        let lit = Lit::new(air, sine);
        let weights = channel_weights(&WAVELENGTHS_UM)
            .map_err(|error| WorldError::Contents(format!("colours of the sky: {error}")))?;
        let colour = |spectrum: [f64; WAVELENGTHS_UM.len()]| {
            let channel = |c: usize| spectrum.iter().zip(&weights).fold(0.0, |sum, (l, w)| sum + l * w[c]);
            std::array::from_fn(channel)
        };
        let beam = in_gamut(colour(lit.beam()));
        let sun_transmittance = LEAST_SUN.check("transmittance of the air for the sun", luminance(beam))?;
        let table = SkyTable::new(SIZE, towards(sun), |sine, cosine| {
            in_gamut(colour(lit.radiance(sine, cosine))).map(|l| l / sun_transmittance)
        });
        let irradiance = irradiance(&table);
        let sun_irradiance = beam.map(|e| e / sun_transmittance);
        Ok(Self { air: *air, table, sun_irradiance, irradiance, sun_transmittance })
    }

    /// The air.
    pub fn air(&self) -> &Air {
        &self.air
    }

    /// Its radiances.
    pub fn table(&self) -> &SkyTable {
        &self.table
    }

    /// Irradiance of the sun normal to its beam: of luminance 1, in the colour that the air above leaves it.
    pub fn sun_irradiance(&self) -> [f64; 3] {
        self.sun_irradiance
    }

    /// The share of the sun's luminance above the air that is left where the sky is seen from.
    pub fn sun_transmittance(&self) -> f64 {
        self.sun_transmittance
    }

    /// Irradiance of a horizontal plane, ∫ L cosθ dω over the table's look-up.
    pub fn irradiance(&self) -> [f64; 3] {
        self.irradiance
    }
}

/// Unit vector of an azimuth; north where the sun is in the zenith.
fn towards(sun: DVec3) -> [f64; 2] {
    let across = (sun.x * sun.x + sun.y * sun.y).sqrt();
    if across > 0.0 { [sun.x / across, sun.y / across] } else { [0.0, 1.0] }
}

fn luminance(rgb: [f64; 3]) -> f64 {
    (0..3).fold(0.0, |sum, c| sum + LUMINANCE[c] * rgb[c])
}

/// A colour outside sRGB's gamut, as low suns have, is mixed with grey of its luminance until no channel is negative.
fn in_gamut(rgb: [f64; 3]) -> [f64; 3] {
    let least = rgb[0].min(rgb[1]).min(rgb[2]);
    if least < 0.0 {
        let grey = luminance(rgb);
        let share = grey / (grey - least);
        return rgb.map(|c| (grey + share * (c - grey)).max(0.0));
    }
    rgb
}

/// By the midpoint rule over squares of sine and azimuth.
fn irradiance(table: &SkyTable) -> [f64; 3] {
    const STEPS: usize = 256;
    let at = |i: usize| (i as f64 + 0.5) / STEPS as f64;
    let mut sum = [0.0; 3];
    for sine in (0..STEPS).map(at) {
        for azimuth in (0..STEPS).map(at) {
            let radiance = table.at(sine, libm::cos(PI * azimuth));
            (0..3).for_each(|c| sum[c] += radiance[c] * sine);
        }
    }
    sum.map(|total| total * 2.0 * PI / (STEPS * STEPS) as f64)
}
