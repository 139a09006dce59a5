//! The rows that closed forms give.

use super::{LAST, Plane, angles, view};
use crate::CliError;
use crate::config::Config;
use crate::pipeline::curves::{emitted, fluxes};
use crate::pipeline::cut::Cut;
use crate::pipeline::optics::Cloud;
use crate::pipeline::{input_error, radiance};
use std::path::Path;
use stratiform_artifact::{
    ParametersDocument, PlaneOrder, PlaneSource, PrincipalPlaneRow, RadianceParametersDocument, read_json,
};
use stratiform_fit::radiance_coefficients;
use stratiform_model::angular::{Angular, Emission, PhaseLookup, Sight};
use stratiform_model::radiance::{Coefficients, Slab};
use stratiform_optics::phase::{PhaseFunction, PhaseTable};
use stratiform_quantities::{Medium, Side};
use stratiform_stats::Estimate;

/// What the closed forms need of one cloud.
pub(super) struct Models<'a> {
    parameters: &'a ParametersDocument,
    /// Of the fitted radiance model, where the config asks for one.
    coefficients: Option<Coefficients<f64>>,
    tables: Tables<'a>,
}

impl<'a> Models<'a> {
    /// Reads the coefficients that an earlier stage left in `dir`.
    pub(super) fn new(
        config: &Config,
        cloud: &'a Cloud,
        cut: &'a Cut,
        parameters: &'a ParametersDocument,
        dir: &Path,
    ) -> Result<Self, CliError> {
        let read = |_| -> Result<Coefficients<f64>, CliError> {
            let document: RadianceParametersDocument = read_json(&dir.join(radiance::FILE))?;
            radiance_coefficients(&document).map_err(input_error)
        };
        let coefficients = config.radiance.as_ref().map(read).transpose()?;
        Ok(Self { parameters, coefficients, tables: Tables { full: &cloud.phase, cut } })
    }

    /// Both models' rows of one scene.
    pub(super) fn rows(&self, plane: &Plane) -> Result<Vec<PrincipalPlaneRow>, CliError> {
        let mut rows = self.angular(plane)?;
        rows.extend(self.radiance(plane)?);
        Ok(rows)
    }

    /// The paper's model, where the table has the sun's angle.
    fn angular(&self, plane: &Plane) -> Result<Vec<PrincipalPlaneRow>, CliError> {
        let (theta_l, thickness) = (plane.scene.theta_l_deg, plane.scene.thickness_m);
        let metres = &self.parameters.metres;
        let Some(row) = metres.rows.iter().find(|row| row.theta_l_deg.degrees() == Some(theta_l)) else {
            return Ok(Vec::new());
        };
        let fluxes = fluxes(&emitted(metres, row), theta_l, thickness)?;
        let depth = metres.kappa_s * thickness;
        let mut rows = Vec::new();
        for theta in angles(LAST, 2, 0) {
            let angular = Angular::new(depth, plane.sight(theta)?)?;
            let orders = angular.orders(&self.tables, &fluxes, Emission::Isotropic);
            let values = [
                (PlaneOrder::Exactly(1), orders.one),
                (PlaneOrder::Exactly(2), orders.two),
                (PlaneOrder::From(3), orders.three_plus),
                (PlaneOrder::Total, orders.total()),
            ];
            rows.extend(values.map(|(order, value)| {
                plane.row(PlaneSource::Model, Medium::Modified, theta, order, exactly(value))
            }));
        }
        Ok(rows)
    }

    /// The fitted radiance model.
    fn radiance(&self, plane: &Plane) -> Result<Vec<PrincipalPlaneRow>, CliError> {
        let Some(coefficients) = &self.coefficients else { return Ok(Vec::new()) };
        let row = |theta| {
            let value = Slab::new(coefficients, plane.tau, plane.sight(theta)?)?.radiance(&self.tables);
            Ok(plane.row(PlaneSource::Radiance, Medium::Full, theta, PlaneOrder::Total, exactly(value)))
        };
        angles(LAST, 2, 0).into_iter().map(row).collect()
    }
}

impl Plane {
    fn sight(&self, theta_v_deg: f64) -> Result<Sight<f64>, CliError> {
        let view = view(theta_v_deg);
        Ok(Sight::new(self.mu0, view.mu, view.phi_deg, Side::Top)?)
    }
}

/// A closed form has no error of its own.
fn exactly(value: f64) -> Estimate {
    Estimate { value, std_error: 0.0 }
}

/// The model's phase functions.
struct Tables<'a> {
    full: &'a PhaseTable,
    cut: &'a Cut,
}

impl PhaseLookup<f64> for Tables<'_> {
    fn full(&self, v: f64) -> f64 {
        self.full.value(v)
    }

    fn wide(&self, v: f64) -> f64 {
        self.cut.wide.value(v)
    }

    fn wide_squared(&self, v: f64) -> f64 {
        self.cut.squared.value(v)
    }
}
