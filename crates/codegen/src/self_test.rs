//! Inputs on which emitted code is held against the f64 model, and the entry point that evaluates them.

use crate::text::banner;
use crate::{CodegenError, Files, Inputs, diffuse_parameters, parameter_grid, tables::angles};
use serde::{Deserialize, Serialize};
use stratiform_artifact::to_json;
use stratiform_model::table::{ParameterGrid, cos_degrees};
use stratiform_model::{Form, Parameters, Thickness};
use stratiform_quantities::Incidence;

/// Optical thicknesses: limits, thin, the fit's range, thick.
const TAUS: [f64; 12] = [0.0, 1e-8, 1e-6, 1e-4, 1e-2, 0.1, 0.5, 2.0, 8.0, 40.0, 200.0, 1e4];

/// Grazing cosines that lie between the table's last rows.
pub(crate) const GRAZING: [f64; 3] = [1e-3, 1e-2, 0.1];

/// One input and what the f64 model gives for it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SelfTestVector {
    /// μ_l or `diffuse`. Exactly an f32.
    pub mu_l: Incidence,
    /// Optical thickness of the full medium. Exactly an f32.
    pub tau: f64,
    /// Fluxes in the order of [`crate::QUANTITIES`].
    pub fluxes: [f64; 9],
}

/// The document `self_test.json`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SelfTest {
    /// `stratiform/self-test/1`.
    pub schema: String,
    /// Hash of the inputs of generation.
    pub inputs_hash: String,
    /// Names of the fluxes.
    pub quantities: Vec<String>,
    /// Inputs and outputs.
    pub vectors: Vec<SelfTestVector>,
}

/// Rounds to the nearest number that a shader can be given exactly.
#[expect(clippy::cast_possible_truncation, reason = "inputs must be the same numbers in f32 and f64")]
pub(crate) fn single(value: f64) -> f64 {
    f64::from(value as f32)
}

/// Cosines of the table's rows.
pub(crate) fn at_rows(inputs: &Inputs) -> Vec<f64> {
    angles(&inputs.parameters.optical).iter().map(|a| cos_degrees(a.theta_l_deg)).collect()
}

/// The middle in μ_l between each two rows.
pub(crate) fn between_rows(inputs: &Inputs) -> Vec<f64> {
    at_rows(inputs).windows(2).map(|pair| 0.5 * (pair[0] + pair[1])).collect()
}

fn vector(parameters: &Parameters<f64>, mu_l: Incidence, tau: f64) -> Result<SelfTestVector, CodegenError> {
    let fluxes = parameters.fluxes(Form::Corrected, Thickness::new(tau)?);
    Ok(SelfTestVector { mu_l, tau, fluxes: fluxes.named().map(|(_, value)| value) })
}

/// Every vector: all thicknesses at every cosine, then in diffuse light.
fn vectors(inputs: &Inputs) -> Result<Vec<SelfTestVector>, CodegenError> {
    let cosines = [at_rows(inputs), between_rows(inputs), GRAZING.to_vec()].concat();
    let beams = cosines.into_iter().map(Some);
    evaluate(inputs, beams.chain([None]).flat_map(|mu| TAUS.map(|tau| (mu, tau))))
}

/// The vectors at pairs of μ_l, none for diffuse light, and τ.
pub(crate) fn evaluate(
    inputs: &Inputs,
    points: impl Iterator<Item = (Option<f64>, f64)>,
) -> Result<Vec<SelfTestVector>, CodegenError> {
    let grid: ParameterGrid<f64> = parameter_grid(&inputs.parameters.optical)?;
    let diffuse = diffuse_parameters(&inputs.parameters.optical)?;
    let one = |(mu, tau): (Option<f64>, f64)| match mu.map(single) {
        Some(mu) => vector(&grid.at(mu)?, Incidence::beam(mu)?, single(tau)),
        None => vector(&diffuse, Incidence::Diffuse, single(tau)),
    };
    points.map(one).collect()
}

/// self_test.json.
pub(crate) fn document(inputs: &Inputs) -> Result<String, CodegenError> {
    let document = SelfTest {
        schema: "stratiform/self-test/1".to_owned(),
        inputs_hash: inputs.hash(),
        quantities: crate::QUANTITIES.map(str::to_owned).to_vec(),
        vectors: vectors(inputs)?,
    };
    Ok(to_json(&document)?)
}

/// stratiform_self_test.wgsl.
pub(crate) fn kernel(inputs: &Inputs) -> String {
    let head = banner(inputs, "Entry point that evaluates stratiform.wgsl over a buffer.");
    head + "\n" + include_str!("wgsl/self_test.wgsl")
}

/// The model and the self-test's entry point as one module, ready to compile; none if it was not emitted.
pub fn self_test_module(files: &Files) -> Option<String> {
    Some(format!("{}\n{}", files.text("stratiform.wgsl")?, files.text("stratiform_self_test.wgsl")?))
}
