//! Inputs on which the emitted fitted radiance is held against the f64 model.

use crate::phase_library::versine;
use crate::radiance_test::{Tables, sights};
use crate::self_test::single;
use crate::{CodegenError, Inputs};
use serde::{Deserialize, Serialize};
use stratiform_artifact::{RadianceParametersDocument, to_csv};
use stratiform_model::angular::Sight;
use stratiform_model::radiance::{Coefficients, EXPONENTS, POWERS, Slab, TERMS};
use stratiform_quantities::Side;

/// One sight and what the f64 model gives for it: a row of `shade_test.csv`. Inputs are f32 exactly.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ShadeVector {
    /// Cosine of the sun's angle.
    pub mu_l: f64,
    /// Cosine of the viewer's.
    pub mu_v: f64,
    /// 1 - cosΘ.
    pub v: f64,
    /// Optical thickness of the full medium.
    pub tau: f64,
    /// Reflectance factor of I1 at the lit face.
    pub top_once: f64,
    /// M there.
    pub top_more: f64,
    /// I1 at the other face.
    pub bottom_once: f64,
    /// M there.
    pub bottom_more: f64,
}

impl ShadeVector {
    /// I1 + M at the lit face, then at the other.
    pub fn sums(&self) -> [f64; 2] {
        [self.top_once + self.top_more, self.bottom_once + self.bottom_more]
    }
}

/// The coefficients of `document`, in the order of the model's terms.
pub(crate) fn coefficients(document: &RadianceParametersDocument) -> Result<Coefficients<f64>, CodegenError> {
    let table = |side| match document.exponents == EXPONENTS {
        true => document.table::<TERMS, POWERS>(side).ok_or(CodegenError::RadianceTerms),
        false => Err(CodegenError::RadianceTerms),
    };
    let coefficients = Coefficients {
        similarity: 1.0 - document.medium.asymmetry,
        kept: 1.0 - document.medium.forward_fraction,
        top: table(Side::Top)?,
        bottom: table(Side::Bottom)?,
    };
    coefficients.check()?;
    Ok(coefficients)
}

/// The f64 twin of the emitted library.
pub(crate) struct Twin {
    coefficients: Coefficients<f64>,
    tables: Tables,
}

impl Twin {
    pub fn new(inputs: &Inputs, document: &RadianceParametersDocument) -> Result<Self, CodegenError> {
        Ok(Self { coefficients: coefficients(document)?, tables: Tables::new(inputs) })
    }

    /// The vector at (μ_l, μ_v, v, τ), rounded to f32 first.
    pub fn vector(&self, sight: [f64; 4]) -> Result<ShadeVector, CodegenError> {
        let [mu_l, mu_v, v, tau] = sight.map(single);
        let at = |side| {
            let slab = Slab::new(&self.coefficients, tau, Sight { mu_l, mu_v, v, side })?;
            Ok::<_, CodegenError>((slab.one(&self.tables), slab.more()))
        };
        let ((top_once, top_more), (bottom_once, bottom_more)) = (at(Side::Top)?, at(Side::Bottom)?);
        Ok(ShadeVector { mu_l, mu_v, v, tau, top_once, top_more, bottom_once, bottom_more })
    }
}

/// shade_test.csv: the sights of `radiance_test.csv`.
pub(crate) fn document(
    inputs: &Inputs,
    document: &RadianceParametersDocument,
) -> Result<String, CodegenError> {
    let twin = Twin::new(inputs, document)?;
    let vector = |[mu_l, mu_v, theta_deg, tau]: [f64; 4]| twin.vector([mu_l, mu_v, versine(theta_deg), tau]);
    Ok(to_csv(&sights().map(vector).collect::<Result<Vec<_>, _>>()?)?)
}
