//! The self-test that every library carries: a few vectors with the f64 model's values, and a function that counts how
//! many values are wrong. They are chosen so that a thousandth of any number of the parameter table is seen.

use crate::self_test::{GRAZING, SelfTestVector, at_rows, between_rows, evaluate};
use crate::shader::{FIELDS, cases};
use crate::text::{fill, literal};
use crate::{CodegenError, Inputs};
use stratiform_quantities::Incidence;

/// At every row of the table.
const AT_ROWS: [f64; 1] = [2.0];
/// At the horizon's row: thin enough for its large c.
const AT_HORIZON: [f64; 1] = [0.1];
/// Between each two rows.
const BETWEEN_ROWS: [f64; 1] = [0.5];
/// Near the horizon.
const NEAR_HORIZON: [f64; 1] = [1e-2];
/// At the zenith: thin, thick.
const LIMITS: [f64; 2] = [1e-4, 200.0];
/// In diffuse light: on both sides of where its exponential integral changes its form, and far from it.
const DIFFUSE: [f64; 3] = [0.5, 2.0, 200.0];

/// μ_l, none for diffuse light, and τ of every vector; all of them are in self_test.json too.
fn points(inputs: &Inputs) -> Vec<(Option<f64>, f64)> {
    let groups = [
        (at_rows(inputs), &AT_ROWS[..]),
        (between_rows(inputs), &BETWEEN_ROWS),
        (GRAZING.to_vec(), &NEAR_HORIZON),
        (vec![1.0], &LIMITS),
        (vec![0.0], &AT_HORIZON),
    ];
    let beams = groups
        .iter()
        .flat_map(|(cosines, taus)| cosines.iter().flat_map(|mu| taus.iter().map(|tau| (Some(*mu), *tau))));
    beams.chain(DIFFUSE.map(|tau| (None, tau))).collect()
}

/// The functions of the embedded self-test.
pub(crate) fn text(inputs: &Inputs) -> Result<String, CodegenError> {
    let vectors = evaluate(inputs, points(inputs).into_iter())?;
    let column =
        |value: &dyn Fn(&SelfTestVector) -> String| cases(&vectors.iter().map(value).collect::<Vec<_>>());
    let cosine = |incidence: Incidence| match incidence {
        Incidence::Beam(mu) => literal(mu.get()),
        Incidence::Diffuse => "-1.0".to_owned(),
    };
    let fluxes =
        |vector: &SelfTestVector| format!("StratiformFluxes({})", vector.fluxes.map(literal).join(", "));
    let compare = |field: &&str| format!("wrong += stratiform_wrong(f.{field}, e.{field});");
    let medium = &inputs.parameters.medium;
    let places = [
        ("COUNT", vectors.len().to_string()),
        ("MUS", column(&|vector| cosine(vector.mu_l))),
        ("TAUS", column(&|vector| literal(vector.tau))),
        ("FLUXES", column(&fluxes)),
        ("CONVENTION", medium.extinction_convention.to_string()),
        ("MEAN_FREE_PATH", literal(1.0 / medium.extinction_per_m)),
        ("COMPARE", FIELDS.iter().map(compare).collect::<Vec<_>>().join("\n        ")),
    ];
    Ok(fill(include_str!("wgsl/embedded_test.wgsl"), &places))
}
