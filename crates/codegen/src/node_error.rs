//! The interpolation error that the table itself can tell: each inner row is left out and interpolated from its
//! neighbours. The gap is then twice as wide as in use, so that the error at mid-nodes is about a quarter of this.

use crate::{CodegenError, ErrorCard, QUANTITIES, error_card::spread, tables::angles};
use stratiform_artifact::ParameterTable;
use stratiform_model::table::{ParameterGrid, cos_degrees};
use stratiform_model::{Form, Thickness};

/// Optical thicknesses of the comparison, two per octave from 2^-5 to 2^6.
fn thicknesses() -> Vec<f64> {
    (-10..=12).map(|i| libm::exp2(0.5 * f64::from(i))).collect()
}

/// Absolute differences between the fluxes of each inner row and those interpolated without it.
///
/// # Errors
/// [`CodegenError`] if the table is out of domain.
pub fn leave_one_out(table: &ParameterTable) -> Result<Vec<ErrorCard>, CodegenError> {
    let all = angles(table);
    let whole = ParameterGrid::<f64>::new(&all)?;
    let mut errors: [Vec<f64>; 9] = Default::default();
    for left_out in 1..all.len().saturating_sub(1) {
        let mut rest = all.clone();
        let mu = cos_degrees(rest.remove(left_out).theta_l_deg);
        let (exact, interpolated) = (whole.at(mu)?, ParameterGrid::<f64>::new(&rest)?.at(mu)?);
        for tau in thicknesses() {
            let flux = |p: &stratiform_model::Parameters<f64>| {
                Ok::<_, CodegenError>(p.fluxes(Form::Corrected, Thickness::new(tau)?).named())
            };
            for (errors, (a, b)) in errors.iter_mut().zip(flux(&exact)?.iter().zip(flux(&interpolated)?)) {
                errors.push((a.1 - b.1).abs());
            }
        }
    }
    Ok(QUANTITIES.iter().zip(errors).filter_map(|(quantity, errors)| spread(quantity, errors)).collect())
}
