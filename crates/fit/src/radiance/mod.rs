//! From reference radiances to the coefficients of [`stratiform_model::radiance`].
//!
//! With I the reference, I1 single scattering and D the model's envelope, ln((I - I1)/D) = Σ a_kj u^j B_k is a linear problem
//! for each face. Its rows are weighted with (I - I1)/I, so that what is made small is the relative error of I. The model
//! is not the truth: standard errors are those of White's sandwich (Econometrica 48 (1980) 817), the spread that other
//! points of the same kind would give; the reference's own errors are far below the misfit.

mod config;
mod face;
mod misfit;
mod plan;

pub use config::RadianceConfig;
pub use misfit::misfit;
pub use plan::{Draw, RadianceDraw, RadiancePlan, SunViews};

use crate::FitError;
use face::fit_face;
use stratiform_artifact::{MediumRecord, Provenance, RadianceParametersDocument, RadianceSample};
use stratiform_model::angular::{PhaseLookup, Sight};
use stratiform_model::radiance::{Coefficients, EXPONENTS, POWERS, TERMS};
use stratiform_quantities::{Range, Side};
use stratiform_stats::Estimate;

/// A reference radiance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RadiancePoint {
    /// Optical thickness of the full medium.
    pub tau: f64,
    /// μ_l.
    pub mu_l: f64,
    /// μ_v.
    pub mu_v: f64,
    /// Azimuth; at 0 light keeps the sun's.
    pub phi_deg: f64,
    /// The face that light leaves.
    pub side: Side,
    /// Reflectance factor of all scattered light.
    pub radiance: Estimate,
}

impl RadiancePoint {
    pub(crate) fn sight(&self) -> Result<Sight<f64>, FitError> {
        Ok(Sight::new(self.mu_l, self.mu_v, self.phi_deg, self.side)?)
    }
}

/// Points with what they are drawn from.
#[derive(Clone, Copy, Debug)]
pub struct Drawn<'a> {
    /// Where they lie.
    pub sample: &'a RadianceSample,
    /// The points.
    pub points: &'a [RadiancePoint],
}

/// Fits both faces to `fitted`, and states the errors there and at `others`.
///
/// # Errors
/// [`FitError`] for a medium that is not lossless, points out of domain, or too few of them.
pub fn fit_radiance(
    fitted: &Drawn<'_>,
    others: &[Drawn<'_>],
    medium: MediumRecord,
    provenance: Provenance,
    phase: &impl PhaseLookup<f64>,
) -> Result<RadianceParametersDocument, FitError> {
    crate::ALBEDO.check("single_scattering_albedo", medium.single_scattering_albedo)?;
    let zero = [[0.0; TERMS]; POWERS];
    let mut coefficients = Coefficients {
        similarity: 1.0 - medium.asymmetry,
        kept: 1.0 - medium.forward_fraction,
        top: zero,
        bottom: zero,
    };
    coefficients.check()?;
    let top = fit_face(Side::Top, fitted.points, &coefficients, phase)?;
    let bottom = fit_face(Side::Bottom, fitted.points, &coefficients, phase)?;
    (coefficients.top, coefficients.bottom) = (top.table, bottom.table);
    let mut errors = Vec::new();
    for (drawn, is_fitted) in std::iter::once((fitted, true)).chain(others.iter().map(|o| (o, false))) {
        for side in Side::BOTH {
            errors.push(misfit(&coefficients, drawn, side, is_fitted, phase)?);
        }
    }
    Ok(RadianceParametersDocument {
        schema: RadianceParametersDocument::SCHEMA.to_owned(),
        provenance,
        medium,
        exponents: EXPONENTS.to_vec(),
        faces: vec![top.record(Side::Top), bottom.record(Side::Bottom)],
        misfit: errors,
    })
}

/// The coefficients of a document.
///
/// # Errors
/// [`FitError::Inconsistent`] for another shape or other terms than this program's, [`FitError::Domain`] for numbers out of
/// domain.
pub fn radiance_coefficients(document: &RadianceParametersDocument) -> Result<Coefficients<f64>, FitError> {
    let wrong =
        || FitError::Inconsistent("radiance parameters of another shape than this program's".to_owned());
    if document.exponents != EXPONENTS {
        return Err(wrong());
    }
    let table = |side| document.table::<TERMS, POWERS>(side).ok_or_else(wrong);
    let coefficients = Coefficients {
        similarity: 1.0 - document.medium.asymmetry,
        kept: 1.0 - document.medium.forward_fraction,
        top: table(Side::Top)?,
        bottom: table(Side::Bottom)?,
    };
    coefficients.check()?;
    Ok(coefficients)
}

/// The range of thickness in which points are drawn.
pub(crate) const DRAWN_TAU: Range = Range { min_included: false, ..Range::closed(0.0, 1e6) };
