//! The numbers of an exchange between ground and cloud, worked out once for device and CPU.
//!
//! Printed (Bouthors, Neyret & Lefebvre 2006, section 5.1): shadows displaced by h sinθ_l, source S_C = T_3+ C_sun. Corrected: h tanθ_l, and
//! T_3+ μ_l C_sun, C_sun being normal to the beam. Passes: an exchange keeps at most q = (largest ground albedo) x (R_ms of the thickest cloud in
//! diffuse light) of the light of the one before it, so that after n pairs of passes at most q^n of the exchanged light is missing:
//! n = ln(error)/ln(q), rounded up. Errors: what lies outside its domain; more than [`MOST_PASSES`].

use super::{RadiosityError, Slab, Weights};
use crate::Radiosity;
use stratiform_model::Form;
use stratiform_quantities::Range;
use stratiform_world::{Map, World};

/// More pairs of passes than this are refused.
pub const MOST_PASSES: u32 = 4096;

/// What an exchange is computed from, but for the thicknesses.
#[derive(Clone, Debug)]
pub struct Plan {
    /// Texels a side of the height field.
    pub field_side: usize,
    /// Points a side that a texel of the exchange is the mean of.
    pub samples: usize,
    /// From a point of the ground to where its sunlight passes the cloud's base, in periods, each in [0, 1).
    pub offset: [f64; 2],
    /// μ_l.
    pub mu_l: f64,
    /// Factor of the sun in the cloud's diffuse source.
    pub source_mu: f64,
    /// κ, 1/m.
    pub extinction_per_m: f64,
    /// Irradiance normal to the sun's beam.
    pub sun: [f64; 3],
    /// Irradiance of a horizontal plane under the clear sky.
    pub sky: [f64; 3],
    /// Of the ground, per texel of the exchange.
    pub ground_albedo: Vec<[f64; 3]>,
    /// From plane to plane.
    pub weights: Weights,
    /// Pairs of passes, ground to cloud and back.
    pub passes: u32,
}

impl Plan {
    /// For a world.
    ///
    /// # Errors
    /// [`RadiosityError`] for a sun below the horizon, a base on the ground, a ground that does not repeat with the cloud, or more passes
    /// than [`MOST_PASSES`].
    pub fn new(world: &World, slab: &Slab, radiosity: &Radiosity) -> Result<Self, RadiosityError> {
        let (field, side) = (world.field.map(), radiosity.side as usize);
        let weights =
            Weights::new(radiosity.rings, side, field.extent_m() / f64::from(radiosity.side), world.base_m)?;
        let direction = world.sun.direction;
        let mu_l =
            Range { min_included: false, ..Range::closed(0.0, 1.0) }.check("cos theta_l", direction.z)?;
        let (slope, source_mu) = match radiosity.form {
            Form::Corrected => (1.0 / mu_l, mu_l),
            Form::AsPrinted => (1.0, 1.0),
        };
        let periods = |along: f64| {
            let offset = along * slope * world.base_m / field.extent_m();
            offset - libm::floor(offset)
        };
        let ground_albedo = means(&world.ground.albedo, side, field.extent_m())?;
        let tau = world.material.extinction_per_m * world.field.most();
        let passes = match radiosity.passes {
            Some(passes) => passes,
            None => passes_for(kept(&ground_albedo, slab.diffuse(tau)?.r_ms), radiosity.error)?,
        };
        Range::closed(0.0, f64::from(MOST_PASSES)).check("radiosity.passes", f64::from(passes))?;
        Ok(Self {
            field_side: field.side(),
            samples: field.side().div_ceil(side),
            offset: [periods(direction.x), periods(direction.y)],
            mu_l,
            source_mu,
            extinction_per_m: world.material.extinction_per_m,
            sun: world.sun.irradiance,
            sky: world.sky.irradiance(),
            ground_albedo,
            weights,
            passes,
        })
    }
}

/// Share of the light that an exchange leaves for the next, at most.
fn kept(ground_albedo: &[[f64; 3]], cloud_albedo: f64) -> f64 {
    cloud_albedo * ground_albedo.iter().flatten().copied().fold(0.0, f64::max)
}

/// Pairs of passes after which at most `error` of the exchanged light is missing, where an exchange keeps at most `kept`: the least n with
/// kept^n <= error.
///
/// # Errors
/// [`RadiosityError::Domain`] for `error` outside (0, 1), or `kept` outside [0, 1).
pub fn passes_for(kept: f64, error: f64) -> Result<u32, RadiosityError> {
    Range::open(0.0, 1.0).check("radiosity.error", error)?;
    Range { max_included: false, ..Range::closed(0.0, 1.0) }.check("ground albedo x cloud albedo", kept)?;
    if kept == 0.0 {
        return Ok(1);
    }
    let passes = libm::ceil(libm::log(error) / libm::log(kept)).max(1.0);
    Range::closed(1.0, f64::from(MOST_PASSES)).check("radiosity passes for the error", passes)?;
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "checked above")]
    Ok(passes as u32)
}

/// Means of a map over the texels of the exchange, whose period is `extent_m`.
fn means(map: &Map<[f64; 3]>, side: usize, extent_m: f64) -> Result<Vec<[f64; 3]>, RadiosityError> {
    if map.side() == 1 {
        return Ok(vec![map.values()[0]; side * side]);
    }
    let periods = extent_m / map.extent_m();
    if (periods - libm::round(periods)).abs() > 1e-9 || periods < 0.5 {
        return Err(RadiosityError::Contents(format!(
            "the ground repeats every {} m, which is no whole part of the cloud's {extent_m} m",
            map.extent_m()
        )));
    }
    let samples = libm::ceil(map.side() as f64 * periods / side as f64).max(1.0);
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a few texels of a map")]
    let n = samples as usize;
    let step = extent_m / (side * n) as f64;
    let mean = |texel: usize| {
        let mut sum = [0.0; 3];
        for i in 0..n * n {
            let x = (texel % side * n + i % n) as f64 + 0.5;
            let y = (texel / side * n + i / n) as f64 + 0.5;
            let value = map.value(x * step, y * step);
            sum = std::array::from_fn(|c| sum[c] + value[c]);
        }
        sum.map(|value| value / (n * n) as f64)
    };
    Ok((0..side * side).map(mean).collect())
}
