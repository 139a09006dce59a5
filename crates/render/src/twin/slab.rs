//! The cloud at a point as a slab: the crate `model` in f32 where the device has the emitted text.

use crate::generated::{PHASE_COUNT, halo};
use crate::parameters::angles;
use crate::phase_table::{kept, phase_table};
use crate::{Model, RenderError, Settings};
use stratiform_artifact::{ParametersDocument, RadianceParametersDocument, read_json};
use stratiform_model::angular::halo::{Halo, Peak};
use stratiform_model::angular::{Angular, PhaseLookup, Sight};
use stratiform_model::radiance::{Coefficients, POWERS, TERMS};
use stratiform_model::table::ParameterGrid;
use stratiform_model::{Fluxes, Form, Thickness, radiance};
use stratiform_quantities::{Side, angle_map};
use stratiform_world::World;

/// Fluxes, radiances and phase functions of one cloud.
#[derive(Debug)]
pub struct Slab {
    settings: Settings,
    grid: ParameterGrid<f32>,
    coefficients: Coefficients<f32>,
    phase: Vec<f32>,
    halo: Vec<f32>,
    kept: [f32; 3],
    edge: f32,
    forward_fraction: f32,
}

/// Radiances per irradiance of the sun, by events.
#[derive(Debug)]
pub struct Orders {
    pub one: [f32; 3],
    pub two: [f32; 3],
    pub more: f32,
}

/// The phase function of one row of the table, for the halo.
struct Row<'a>(&'a Slab);

impl PhaseLookup<f32> for Row<'_> {
    fn full(&self, v: f32) -> f32 {
        self.0.phase(0, v)
    }

    fn wide(&self, _: f32) -> f32 {
        0.0
    }

    fn wide_squared(&self, _: f32) -> f32 {
        0.0
    }
}

impl Slab {
    pub fn load(world: &World, settings: &Settings) -> Result<Self, RenderError> {
        let material = &world.material;
        let folder = &material.generated;
        let half = libm::sin(0.5 * material.theta_f_deg.to_radians());
        let parameters: ParametersDocument = read_json(&folder.join("parameters.json"))?;
        Ok(Self {
            settings: *settings,
            grid: ParameterGrid::new(&angles(&parameters.optical))?,
            coefficients: coefficients(&read_json(&folder.join("../accepted/radiance_parameters.json"))?)?,
            phase: phase_table(material)?,
            halo: halo(folder)?,
            kept: kept(material).map(|share| share as f32),
            edge: (2.0 * half * half) as f32,
            forward_fraction: material.forward_fraction as f32,
        })
    }

    /// Fluxes of a beam.
    pub fn fluxes(&self, mu: f32, tau: f32) -> Result<Fluxes<f32>, RenderError> {
        Ok(self.grid.at(mu)?.fluxes(Form::Corrected, Thickness::new(tau)?))
    }

    /// Light of one and two events at `near`, of more at `far`.
    pub fn orders(&self, near: &Sight<f32>, far: &Sight<f32>, tau: f32) -> Result<Orders, RenderError> {
        let unit = near.mu_l * std::f32::consts::FRAC_1_PI;
        let weights = self.kept.map(|kept| Angular::unchecked(kept * tau, *near).weights());
        let wide =
            |c: usize| if near.v >= self.edge { self.phase(2 + c, near.v) / self.kept[c] } else { 0.0 };
        let one = std::array::from_fn(|c| 0.25 * unit * wide(c) * weights[c].0);
        let two = std::array::from_fn(|c| 0.125 * unit * self.phase(5 + c, near.v) * weights[c].1);
        let more = far.mu_l * std::f32::consts::FRAC_1_PI;
        Ok(match self.settings.model {
            Model::Angular => Orders { one, two, more: more * self.three_plus(far, tau)? },
            Model::Fitted => {
                let slab = radiance::Slab::unchecked(&self.coefficients, tau, *far);
                Orders { one, two: [0.0; 3], more: more * slab.more() }
            }
        })
    }

    fn three_plus(&self, sight: &Sight<f32>, tau: f32) -> Result<f32, RenderError> {
        let emission = match sight.side {
            Side::Top => self.settings.emission.top,
            Side::Bottom => self.settings.emission.bottom,
        };
        let slab = Angular::unchecked((1.0 - self.forward_fraction) * tau, *sight);
        Ok(slab.three_plus(&self.fluxes(sight.mu_l, tau)?, emission))
    }

    /// Radiance per irradiance of the sun of light that met forward events only.
    pub fn halo(&self, sight: &Sight<f32>, tau: f32) -> f32 {
        let slab = Angular::unchecked((1.0 - self.forward_fraction) * tau, *sight);
        let peak = Peak { forward_fraction: self.forward_fraction, edge: self.edge };
        let total = Halo::new(&slab, tau, peak).total(&Row(self), &|v, q| self.halo_shape(v, q));
        sight.mu_l * std::f32::consts::FRAC_1_PI * total
    }

    /// A row of the phase table at v, linear in the angle map's coordinate.
    fn phase(&self, row: usize, v: f32) -> f32 {
        let theta = 2.0 * libm::asin((0.5 * f64::from(v)).sqrt().min(1.0)).to_degrees();
        let (cell, share) = angle_map::place(theta, PHASE_COUNT);
        let at = row * PHASE_COUNT + cell;
        self.phase[at] + (self.phase[at + 1] - self.phase[at]) * share as f32
    }

    /// Columns of sin(Θ/2) to 10°, rows of the path to 24.
    fn halo_shape(&self, v: f32, q: f32) -> f32 {
        let across = (0.5 * f64::from(v)).sqrt() / libm::sin(10.0_f64.to_radians()) * 127.0;
        if across >= 127.0 {
            return 0.0;
        }
        let along = (f64::from(q) * 15.0 / 24.0).min(15.0);
        let (column, row) = (across as usize, (along as usize).min(14));
        let (u, w) = ((across - column as f64) as f32, (along - row as f64) as f32);
        let at = |row: usize, column: usize| self.halo[row * 128 + column];
        let line = |row: usize| at(row, column) + (at(row, column + 1) - at(row, column)) * u;
        line(row) + (line(row + 1) - line(row)) * w
    }
}

fn coefficients(document: &RadianceParametersDocument) -> Result<Coefficients<f32>, RenderError> {
    let table = |side| document.table::<TERMS, POWERS>(side).ok_or(RenderError::Shape);
    let coefficients = Coefficients {
        similarity: 1.0 - document.medium.asymmetry,
        kept: 1.0 - document.medium.forward_fraction,
        top: table(Side::Top)?,
        bottom: table(Side::Bottom)?,
    };
    coefficients.check()?;
    Ok(coefficients.cast())
}
