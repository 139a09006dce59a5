//! Inputs on which the emitted radiance is held against the f64 model.

use crate::phase::warped;
use crate::phase_library::{looked_up, versine};
use crate::self_test::single;
use crate::{CodegenError, HaloTable, Inputs, parameter_grid};
use serde::{Deserialize, Serialize};
use stratiform_artifact::to_csv;
use stratiform_model::angular::halo::{Halo, Peak};
use stratiform_model::angular::{Angular, Emission, PhaseLookup, Sight};
use stratiform_model::table::ParameterGrid;
use stratiform_model::{Form, Thickness};
use stratiform_quantities::Side;

/// Cosines of the sun: at and between the table's rows, grazing.
const MU_L: [f64; 5] = [1.0, 0.7, 0.3, 0.05, 1e-3];
/// Cosines of the viewer: one equal to one of the sun's, one a rounding beside it.
const MU_V: [f64; 6] = [1.0, 0.7, 0.699_999_9, 0.3, 0.05, 1e-3];
/// Θ in degrees: below and above θ_f, side, fogbow, glory.
const THETA_DEG: [f64; 5] = [1.0, 8.0, 60.0, 142.0, 180.0];
/// Optical thicknesses: limits, thin, thick.
const TAUS: [f64; 7] = [0.0, 1e-6, 1e-2, 0.3, 2.0, 20.0, 1e3];

/// One sight and what the f64 model gives for it: a row of `radiance_test.csv`. Inputs are f32 exactly.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RadianceVector {
    /// Cosine of the sun's angle.
    pub mu_l: f64,
    /// Cosine of the viewer's.
    pub mu_v: f64,
    /// 1 - cosΘ.
    pub v: f64,
    /// Optical thickness of the full medium.
    pub tau: f64,
    /// Shape of I3+: 0 isotropic, 1 Lambertian, 2 escape.
    pub shape: u32,
    /// Reflectance factor of I1 at the lit face.
    pub top_one: f64,
    /// I2 there.
    pub top_two: f64,
    /// I3+ there.
    pub top_three_plus: f64,
    /// I1 at the other face.
    pub bottom_one: f64,
    /// I2 there.
    pub bottom_two: f64,
    /// I3+ there.
    pub bottom_three_plus: f64,
    /// The halo there: light that met forward events only. 0 without its table.
    pub halo: f64,
}

impl RadianceVector {
    /// I1, I2, I3+ at the lit face, then at the other.
    pub fn orders(&self) -> [[f64; 3]; 2] {
        [
            [self.top_one, self.top_two, self.top_three_plus],
            [self.bottom_one, self.bottom_two, self.bottom_three_plus],
        ]
    }
}

/// The emitted tables in double precision.
pub(crate) struct Tables {
    p: Vec<f64>,
    squared: Vec<f64>,
    forward_fraction: f64,
    edge: f64,
}

impl Tables {
    pub fn new(inputs: &Inputs) -> Self {
        let (p, squared) = warped(inputs).iter().map(|row| (row.p, row.p_squared)).unzip();
        let medium = &inputs.parameters.medium;
        Self { p, squared, forward_fraction: medium.forward_fraction, edge: versine(medium.theta_f_deg) }
    }
}

/// Θ in degrees of v.
fn angle_deg(v: f64) -> f64 {
    (2.0 * libm::asin((0.5 * v).sqrt())).to_degrees()
}

impl PhaseLookup<f64> for Tables {
    fn full(&self, v: f64) -> f64 {
        looked_up(&self.p, angle_deg(v))
    }

    fn wide(&self, v: f64) -> f64 {
        if v < self.edge { 0.0 } else { self.full(v) / (1.0 - self.forward_fraction) }
    }

    fn wide_squared(&self, v: f64) -> f64 {
        looked_up(&self.squared, angle_deg(v))
    }
}

/// The f64 twin of the emitted library.
pub(crate) struct Twin {
    grid: ParameterGrid<f64>,
    kappa_s: f64,
    tables: Tables,
    halo: Option<HaloTable>,
}

impl Twin {
    pub fn new(inputs: &Inputs) -> Result<Self, CodegenError> {
        Ok(Self {
            grid: parameter_grid(&inputs.parameters.optical)?,
            kappa_s: inputs.parameters.optical.kappa_s,
            tables: Tables::new(inputs),
            halo: inputs.halo.clone(),
        })
    }

    /// The vector at (μ_l, μ_v, v, τ), rounded to f32 first.
    pub fn vector(&self, sight: [f64; 4], shape: usize) -> Result<RadianceVector, CodegenError> {
        let [mu_l, mu_v, v, tau] = sight.map(single);
        let fluxes = self.grid.at(mu_l)?.fluxes(Form::Corrected, Thickness::new(tau)?);
        let emission = Emission::ALL[shape];
        let at = |side| {
            let slab = Angular::new(self.kappa_s * tau, Sight { mu_l, mu_v, v, side })?;
            Ok::<_, CodegenError>(slab.orders(&self.tables, &fluxes, emission))
        };
        let (top, bottom) = (at(Side::Top)?, at(Side::Bottom)?);
        Ok(RadianceVector {
            mu_l,
            mu_v,
            v,
            tau,
            shape: shape as u32,
            top_one: top.one,
            top_two: top.two,
            top_three_plus: top.three_plus,
            bottom_one: bottom.one,
            bottom_two: bottom.two,
            bottom_three_plus: bottom.three_plus,
            halo: self.halo.as_ref().map_or(Ok(0.0), |halo| self.halo_at(halo, [mu_l, mu_v, v, tau]))?,
        })
    }
}

impl Twin {
    fn halo_at(&self, table: &HaloTable, [mu_l, mu_v, v, tau]: [f64; 4]) -> Result<f64, CodegenError> {
        let slab = Angular::new(tau, Sight { mu_l, mu_v, v, side: Side::Bottom })?;
        let peak = Peak { forward_fraction: self.tables.forward_fraction, edge: self.tables.edge };
        Ok(Halo::new(&slab, tau, peak).total(&self.tables, &|v, q| shape(table, v, q)))
    }
}

/// The table at v and q: 0 beyond its last column, the last row beyond its last row.
fn shape(table: &HaloTable, v: f64, q: f64) -> f64 {
    let (columns, rows) = (table.angles, table.values.len() / table.angles);
    let across = (0.5 * v).sqrt() / table.reach * (columns - 1) as f64;
    if across >= (columns - 1) as f64 {
        return 0.0;
    }
    let along = (q / table.longest).min(1.0) * (rows - 1) as f64;
    let (column, row) = (across as usize, (along as usize).min(rows - 2));
    let at = |row: usize| {
        let pair = &table.values[row * columns + column..];
        pair[0] + (pair[1] - pair[0]) * (across - column as f64)
    };
    at(row) + (at(row + 1) - at(row)) * (along - row as f64)
}

/// μ_l, μ_v, Θ in degrees and τ: every pair of cosines at every thickness, with angles in turn.
pub(crate) fn sights() -> impl Iterator<Item = [f64; 4]> {
    let pairs = MU_L.iter().flat_map(|mu_l| MU_V.iter().map(move |mu_v| (*mu_l, *mu_v)));
    let sights = pairs.flat_map(|(mu_l, mu_v)| TAUS.iter().map(move |tau| (mu_l, mu_v, *tau)));
    let angle = |i: usize| THETA_DEG[i % THETA_DEG.len()];
    sights.enumerate().map(move |(i, (mu_l, mu_v, tau))| [mu_l, mu_v, angle(i), tau])
}

/// radiance_test.csv: the sights with shapes in turn.
pub(crate) fn document(inputs: &Inputs) -> Result<String, CodegenError> {
    let twin = Twin::new(inputs)?;
    let vector = |(i, [mu_l, mu_v, theta_deg, tau]): (usize, [f64; 4])| {
        twin.vector([mu_l, mu_v, versine(theta_deg), tau], i % Emission::ALL.len())
    };
    let vectors = sights().enumerate().map(vector).collect::<Result<Vec<_>, _>>()?;
    Ok(to_csv(&vectors)?)
}
