//! The numbers of an exchange between ground and cloud, worked out once for device and CPU.
//!
//! Printed (Bouthors, Neyret & Lefebvre 2006, section 5.1): shadows displaced by h sinθ_l, source S_C = T_3+ C_sun. Corrected: h tanθ_l, and
//! T_3+ μ_l C_sun, C_sun being normal to the beam.

use super::passes::{MOST_PASSES, kept, passes_for};
use super::texels::Texels;
use super::{RadiosityError, Slab, Weights};
use crate::Radiosity;
use glam::DVec3;
use stratiform_model::Form;
use stratiform_quantities::Range;
use stratiform_world::{Map, World};

/// What an exchange is computed from, but for the thicknesses.
#[derive(Clone, Debug)]
pub struct Plan {
    /// Texels a side of the height field.
    pub field_side: usize,
    /// The texels of the exchange.
    pub texels: Texels,
    /// From a point of the ground to where its sunlight passes the cloud's base, in texels of the height field, each in [0, `field_side`).
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
    /// For a world; `weights` are those of [`Weights::between`].
    ///
    /// # Errors
    /// [`RadiosityError`] for a sun at or below the horizon, a ground that does not repeat with the cloud, or more passes than
    /// [`MOST_PASSES`].
    pub fn new(
        world: &World,
        slab: &Slab,
        radiosity: &Radiosity,
        weights: Weights,
    ) -> Result<Self, RadiosityError> {
        let field = world.field.map();
        let mu_l = Range { min_included: false, ..Range::closed(0.0, 1.0) }
            .check("cosine of the sun's zenith angle", world.sun.direction.z)?;
        let (slope, source_mu) = match radiosity.form {
            Form::Corrected => (1.0 / mu_l, mu_l),
            Form::AsPrinted => (1.0, 1.0),
        };
        let ground_albedo = ground_albedo(&world.ground.albedo, weights.side(), field.extent_m())?;
        let mut plan = Self {
            field_side: field.side(),
            texels: Texels::over(weights.side(), field.side(), field.extent_m()),
            offset: offset(world.sun.direction, slope * world.base_m, field),
            mu_l,
            source_mu,
            extinction_per_m: world.material.extinction_per_m,
            sun: world.sun.irradiance,
            sky: world.sky.irradiance(),
            ground_albedo,
            weights,
            passes: radiosity.passes.unwrap_or(0),
        };
        if radiosity.passes.is_none() {
            plan.passes = passes_for(plan.kept(world, slab)?, radiosity.error)?;
        }
        Range::closed(0.0, f64::from(MOST_PASSES)).check("radiosity.passes", f64::from(plan.passes))?;
        Ok(plan)
    }

    /// q of the world's planes: a texel's albedo is at most that of its mean thickness, R_ms in diffuse light being concave.
    fn kept(&self, world: &World, slab: &Slab) -> Result<f64, RadiosityError> {
        let (field, texels) = (&world.field, &self.texels);
        let bilinear = || texels.means(|x, y| Ok::<_, RadiosityError>([field.thickness(x, y)]));
        let whole = texels.blocks(field.map().side(), |i| [field.map().values()[i]]);
        let thickness = whole.map_or_else(bilinear, Ok)?;
        let albedo = |[mean]: [f64; 1]| Ok([slab.diffuse(self.extinction_per_m * mean)?.r_ms; 3]);
        let cloud = thickness.into_iter().map(albedo).collect::<Result<Vec<_>, RadiosityError>>()?;
        Ok(kept(&self.weights, &self.ground_albedo, &cloud))
    }
}

/// `reach` towards the sun, in texels of the field, within its period.
fn offset(sun: DVec3, reach: f64, field: &Map<f64>) -> [f64; 2] {
    let side = field.side() as f64;
    [sun.x, sun.y].map(|along| {
        let texels = along * reach / field.extent_m() * side;
        let within = texels - libm::floor(texels / side) * side;
        if within < side { within } else { 0.0 }
    })
}

/// Means of the ground's albedo over the texels of the exchange, whose period is `extent_m`.
fn ground_albedo(map: &Map<[f64; 3]>, side: usize, extent_m: f64) -> Result<Vec<[f64; 3]>, RadiosityError> {
    if map.side() == 1 {
        return Ok(vec![map.values()[0]; side * side]);
    }
    let periods = libm::round(extent_m / map.extent_m());
    if !(1.0..1e3).contains(&periods) || (periods * map.extent_m() / extent_m - 1.0).abs() > 1e-9 {
        return Err(RadiosityError::Contents(format!(
            "the ground repeats every {} m, which is no whole part of the cloud's {extent_m} m",
            map.extent_m()
        )));
    }
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "1 to 1000")]
    let across = map.side() * periods as usize;
    let texels = Texels::over(side, across, extent_m);
    let bilinear = || texels.means(|x, y| Ok(map.value(x, y)));
    texels.blocks(map.side(), |i| map.values()[i]).map_or_else(bilinear, Ok)
}
