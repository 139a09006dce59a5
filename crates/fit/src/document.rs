//! The table of parameters: fitted in optical thickness, converted to metres.
//!
//! With s = (1-β)/β and τ = κH: s, c, κ_c and κ_S per metre are κ times those per optical thickness; b, t, r
//! stay. Hence β_m = 1/(1 + κs), and its error is κ(β_m/β_τ)² times that of β_τ.

use crate::orders_fit::{OrdersFit, fit_orders};
use crate::totals_fit::{TotalsRow, fit_totals};
use crate::{FitConfig, FitError, ORDERS, Reference};
use stratiform_artifact::{
    FittedParameter, Flag, MediumRecord, Misfit, ParameterRow, ParameterTable, ParametersDocument, Provenance,
};
use stratiform_model::{Form, Parameters, Thickness, Values, problems};
use stratiform_quantities::Range;
use stratiform_stats::Estimate;

/// T_3+ and R_3+ below minus this are flagged.
const NEGLIGIBLE_FLUX: f64 = 1e-3;

/// Single-scattering albedos that the model can stand for: it has R_ms = 1 - T_ms. At the lower end diffuse light
/// loses 2e-5 of its flux per unit of optical thickness.
pub const ALBEDO: Range = Range::closed(0.99999, 1.0);

/// Fits every row of the table: one per angle of the config, in its order, then, if there is one, the diffuse
/// row.
///
/// # Errors
/// [`FitError`] for a config, medium or reference that is out of domain, or references that do not belong to
/// the config.
pub fn fit(
    config: &FitConfig,
    references: &[Reference],
    medium: MediumRecord,
    provenance: Provenance,
) -> Result<ParametersDocument, FitError> {
    config.check()?;
    check_medium(&medium)?;
    let kappa = medium.extinction_per_m;
    let tau: Vec<f64> = config.thickness_m.metres().iter().map(|metres| metres * kappa).collect();
    check_references(config, references, &tau)?;
    let kappa_s = 1.0 - medium.single_scattering_albedo * medium.forward_fraction;
    let totals = fit_totals(config, &tau, references)?;
    let mut rows = Vec::with_capacity(references.len());
    for (reference, totals_row) in references.iter().zip(totals.rows) {
        let orders = fit_orders(&config.bounds, &tau, reference)?;
        rows.push(row(reference, totals.beta.value, kappa_s, totals_row, orders)?);
    }
    let optical = ParameterTable { beta: totals.beta, kappa_s, rows };
    Ok(ParametersDocument {
        schema: ParametersDocument::SCHEMA.to_owned(),
        provenance,
        medium,
        thickness_range_m: [config.thickness_m.min, config.thickness_m.max],
        metres: in_metres(&optical, kappa),
        optical,
    })
}

fn check_medium(medium: &MediumRecord) -> Result<(), FitError> {
    Range { min_included: false, ..Range::closed(0.0, 1e6) }
        .check("extinction_per_m", medium.extinction_per_m)?;
    ALBEDO.check("single_scattering_albedo", medium.single_scattering_albedo)?;
    Range { max_included: false, ..Range::closed(0.0, 1.0) }
        .check("forward_fraction", medium.forward_fraction)?;
    Ok(())
}

fn check_references(config: &FitConfig, references: &[Reference], tau: &[f64]) -> Result<(), FitError> {
    let beams = references.iter().take_while(|r| r.incidence.degrees().is_some()).count();
    FitError::check_length("the list of references at an angle", beams, config.theta_l_deg.len())?;
    if references.len() > beams + 1 {
        return Err(FitError::Inconsistent("more than one reference follows those at an angle".into()));
    }
    for (reference, angle) in references.iter().zip(&config.theta_l_deg) {
        Range::closed(*angle, *angle)
            .check("theta_l_deg", reference.incidence.degrees().unwrap_or(f64::NAN))?;
    }
    references.iter().try_for_each(|reference| reference.check(tau))
}

fn row(
    reference: &Reference,
    beta: f64,
    kappa_s: f64,
    totals: TotalsRow,
    orders: OrdersFit,
) -> Result<ParameterRow, FitError> {
    let [kappa_c, t, r] = orders.parameters;
    let (b, c) = (totals.b.emitted, totals.c.emitted);
    let values = Values { beta, b, c, kappa_c: kappa_c.emitted, t: t.emitted, r: r.emitted, kappa_s };
    let mut flags = [totals.flags, orders.flags, unphysical(reference, &values)?].concat();
    flags.sort_unstable();
    flags.dedup();
    let count = reference.tau.len();
    let of_orders = ORDERS.iter().zip(orders.residuals.chunks(count));
    let curves = std::iter::once((&"t_ms", totals.residuals.as_slice())).chain(of_orders);
    Ok(ParameterRow {
        theta_l_deg: reference.incidence.clone(),
        b: totals.b,
        c: totals.c,
        kappa_c,
        t,
        r,
        correlation_b_c: totals.correlation,
        correlation_kappa_c_t_r: orders.correlations,
        misfit: curves.map(|(name, residuals)| misfit(name, residuals, &reference.tau)).collect(),
        flags,
        stopped_multiple: totals.outcome.to_string(),
        stopped_orders: orders.outcome.to_string(),
    })
}

fn misfit(quantity: &str, residuals: &[f64], tau: &[f64]) -> Misfit {
    let square = residuals.iter().fold(0.0, |sum, r| sum + r * r);
    let (mut max, mut max_at) = (0.0, tau[0]);
    for (r, &tau) in residuals.iter().zip(tau) {
        if r.abs() > max {
            (max, max_at) = (r.abs(), tau);
        }
    }
    Misfit { quantity: quantity.to_owned(), rms: (square / residuals.len() as f64).sqrt(), max, max_at }
}

/// Flags of fluxes that no slab can have, over the grid.
fn unphysical(reference: &Reference, values: &Values<f64>) -> Result<Vec<Flag>, FitError> {
    let parameters = Parameters::new(values, reference.light()?)?;
    let mut flags = Vec::new();
    for &tau in &reference.tau {
        for problem in problems(&parameters.fluxes(Form::Corrected, Thickness::new(tau)?)) {
            let negative = problem.value < -NEGLIGIBLE_FLUX;
            match problem.quantity {
                "t_3_plus" if problem.value < 0.0 => flags.extend(negative.then_some(Flag::NegativeT3Plus)),
                "r_3_plus" if problem.value < 0.0 => flags.extend(negative.then_some(Flag::NegativeR3Plus)),
                _ => flags.push(Flag::OutsideUnitInterval),
            }
        }
    }
    Ok(flags)
}

/// The same table per metre; `kappa` is the extinction of the full medium, 1/m.
pub(crate) fn in_metres(optical: &ParameterTable, kappa: f64) -> ParameterTable {
    let beta = optical.beta.value;
    let per_metre = 1.0 / (1.0 + kappa * (1.0 - beta) / beta);
    let ratio = per_metre / beta;
    let rate = |p: &FittedParameter| FittedParameter {
        value: p.value.map(|v| v * kappa),
        std_error: p.std_error.map(|e| e * kappa),
        emitted: p.emitted * kappa,
    };
    let convert = |row: &ParameterRow| ParameterRow {
        c: rate(&row.c),
        kappa_c: rate(&row.kappa_c),
        misfit: row.misfit.iter().map(|m| Misfit { max_at: m.max_at / kappa, ..m.clone() }).collect(),
        ..row.clone()
    };
    ParameterTable {
        beta: Estimate { value: per_metre, std_error: kappa * ratio * ratio * optical.beta.std_error },
        kappa_s: optical.kappa_s * kappa,
        rows: optical.rows.iter().map(convert).collect(),
    }
}
