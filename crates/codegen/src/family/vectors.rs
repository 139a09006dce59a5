//! Inputs on which the emitted family is held against the f64 model.

use super::tables::parameter_family;
use crate::CodegenError;
use crate::self_test::single;
use serde::{Deserialize, Serialize};
use stratiform_artifact::FamilyDocument;
use stratiform_model::{Form, Thickness};

/// Cosines of the sun, at and between rows; none for diffuse light.
const MU_L: [Option<f64>; 7] = [Some(1.0), Some(0.93), Some(0.5), Some(0.3), Some(0.06), Some(1e-3), None];
/// Optical thicknesses: limits, thin, thick.
const TAUS: [f64; 6] = [0.0, 1e-3, 0.2, 2.0, 20.0, 500.0];

/// One cloud and what the f64 model gives for it: a row of `family_test.csv`. Inputs are f32 exactly.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[expect(missing_docs, reason = "the fluxes' names are those of the model")]
pub struct FamilyVector {
    /// Cosine of the sun's angle; -1 for diffuse light.
    pub mu_l: f64,
    /// r_e, µm.
    pub radius_um: f64,
    /// Optical thickness of the full medium.
    pub tau: f64,
    pub t_ms: f64,
    pub r_ms: f64,
    pub t_zero: f64,
    pub t_one: f64,
    pub t_two: f64,
    pub t_three_plus: f64,
    pub r_one: f64,
    pub r_two: f64,
    pub r_three_plus: f64,
}

impl FamilyVector {
    /// The fluxes, in the order of the emitted structure.
    pub fn fluxes(&self) -> [f64; 9] {
        let Self { t_ms, r_ms, t_zero, t_one, t_two, t_three_plus, .. } = *self;
        [t_ms, r_ms, t_zero, t_one, t_two, t_three_plus, self.r_one, self.r_two, self.r_three_plus]
    }
}

/// Every cosine and thickness at every radius of the family and half-way between.
///
/// # Errors
/// [`CodegenError`] for tables out of domain.
pub(super) fn vectors(family: &FamilyDocument) -> Result<Vec<FamilyVector>, CodegenError> {
    let nodes: Vec<f64> = family.members.iter().map(|one| one.effective_radius_um).collect();
    let between = nodes.windows(2).map(|pair| 0.5 * (pair[0] + pair[1]));
    let radii: Vec<f64> = nodes.iter().copied().chain(between).map(single).collect();
    let mut vectors = Vec::new();
    for radius in radii {
        for mu_l in MU_L {
            for tau in TAUS {
                vectors.push(vector(family, mu_l.map(single), radius, single(tau))?);
            }
        }
    }
    Ok(vectors)
}

/// What the f64 model gives at μ_l, or in diffuse light.
pub(super) fn vector(
    family: &FamilyDocument,
    mu_l: Option<f64>,
    radius_um: f64,
    tau: f64,
) -> Result<FamilyVector, CodegenError> {
    let tables = parameter_family::<f64>(family)?;
    let parameters = mu_l.map_or_else(|| tables.diffuse(radius_um), |mu_l| tables.at(mu_l, radius_um))?;
    let f = parameters.fluxes(Form::Corrected, Thickness::new(tau)?);
    Ok(FamilyVector {
        mu_l: mu_l.unwrap_or(-1.0),
        radius_um,
        tau,
        t_ms: f.t_ms,
        r_ms: f.r_ms,
        t_zero: f.t_0,
        t_one: f.t_1,
        t_two: f.t_2,
        t_three_plus: f.t_3_plus,
        r_one: f.r_1,
        r_two: f.r_2,
        r_three_plus: f.r_3_plus,
    })
}
