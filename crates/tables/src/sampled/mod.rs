//! A phase function at N equal steps of the angle map's coordinate, as textures hold it.
//!
//! Texel i stands at u = i/(N-1) of [`angle_map`]; a look-up is linear in u between texels. The values are those
//! whose look-up is nearest to the table: ½∫(look-up - P)² sinΘ dΘ is least (see `projection.rs`), so the look-up
//! keeps the integral, and g to about 1e-7. Of point samples the integral is 3 % off at 64 texels; scaled to 1
//! they are 3 times further from the table. The values are then divided by the look-up's integral, which is 1 up to
//! quadrature and jumps; [`Sampled::scaled_by`] says by what.
//!
//! At a jump (θ_f of the modified function) a look-up is a ramp two texels wide. An exact edge needs the full
//! function and P_S = P/(1 - P_f) for Θ ≥ θ_f, as emitted code has it.
//!
//! Domain: N ∈ \[64, 1024\]. How well N texels hold a function is told by [`Card`](crate::card::Card).

mod lookup;
mod projection;
mod quadrature;

pub use lookup::look_up;
pub(crate) use quadrature::Quadrature;

use crate::TablesError;
use stratiform_optics::phase::PhaseTable;
use stratiform_quantities::{Range, angle_map};

/// Numbers of texels that tables may have.
pub const TEXELS: Range = Range::closed(64.0, 1024.0);

/// A phase function at equal steps of the angle map's coordinate.
#[derive(Clone, Debug, PartialEq)]
pub struct Sampled {
    /// P at u = i/(N-1).
    pub values: Vec<f64>,
    /// What the fitted values were multiplied by to make the look-up's integral 1.
    pub scaled_by: f64,
}

impl Sampled {
    /// `table` with `texels` values.
    ///
    /// # Errors
    /// [`TablesError::Domain`] unless 64 ≤ `texels` ≤ 1024.
    pub fn new(table: &PhaseTable, texels: usize) -> Result<Self, TablesError> {
        TEXELS.check("texels", texels as f64)?;
        let quadrature = Quadrature::new(table, texels);
        let mut values = projection::nearest(table, &quadrature, texels);
        let integral = quadrature.integral(|theta_deg| look_up(&values, theta_deg));
        values.iter_mut().for_each(|value| *value /= integral);
        Ok(Self { values, scaled_by: 1.0 / integral })
    }
}

/// u of texel `i` of `texels`.
pub fn coordinate(i: usize, texels: usize) -> f64 {
    i as f64 / (texels - 1) as f64
}

/// Θ in degrees of texel `i` of `texels`.
pub fn theta_deg(i: usize, texels: usize) -> f64 {
    angle_map::angle_deg(coordinate(i, texels))
}
