//! The self-test that every library carries: a few vectors with the f64 model's values, and a function that counts how
//! many values are wrong.

use crate::shader::{FIELDS, cases};
use crate::text::{fill, literal};
use crate::{CodegenError, Inputs, self_test};
use stratiform_quantities::Incidence;

/// Every so many of the vectors of self_test.json is embedded: thin, thick, grazing, at and between the table's angles.
const STRIDE: usize = 29;

/// The functions of the embedded self-test.
pub(crate) fn text(inputs: &Inputs) -> Result<String, CodegenError> {
    let vectors = self_test::vectors(inputs)?;
    let chosen: Vec<_> = vectors.iter().step_by(STRIDE).chain(vectors.last()).collect();
    let column = |value: &dyn Fn(&self_test::SelfTestVector) -> String| {
        cases(&chosen.iter().map(|vector| value(vector)).collect::<Vec<_>>())
    };
    let cosine = |incidence: Incidence| match incidence {
        Incidence::Beam(mu) => literal(mu.get()),
        Incidence::Diffuse => "-1.0".to_owned(),
    };
    let fluxes = |vector: &self_test::SelfTestVector| {
        format!("StratiformFluxes({})", vector.fluxes.map(literal).join(", "))
    };
    let compare = |field: &&str| format!("wrong += stratiform_wrong(f.{field}, e.{field});");
    let places = [
        ("COUNT", chosen.len().to_string()),
        ("MUS", column(&|vector| cosine(vector.mu_l))),
        ("TAUS", column(&|vector| literal(vector.tau))),
        ("FLUXES", column(&fluxes)),
        ("COMPARE", FIELDS.iter().map(compare).collect::<Vec<_>>().join("\n        ")),
    ];
    Ok(fill(include_str!("wgsl/embedded_test.wgsl"), &places))
}
