//! `notes.json`: the numbers that explain why the published table differs from the regenerated one.

use super::optics::{Cloud, optics_error};
use super::published;
use crate::CliError;
use crate::config::Config;
use crate::pipeline::curves;
use std::path::Path;
use stratiform_artifact::{
    AngularShares, CoarseTabulation, Misfit, ModifiedBias, NotesDocument, OpticsDocument, OrdersRow,
    ParametersDocument, Provenance, PublishedMisfit, RowIncidence, WavelengthShares, read_csv, read_json,
};
use stratiform_fit::Reference;
use stratiform_model::table::cos_degrees;
use stratiform_optics::phase::{Norm, PhaseFunction, PhaseTable};
use stratiform_quantities::Medium;

/// Gathers the numbers from the folder's artifacts.
///
/// # Errors
/// [`CliError::Input`] naming the artifact that is missing or damaged.
pub fn gather(
    config: &Config,
    document: &OpticsDocument,
    cloud: &Cloud,
    parameters: &ParametersDocument,
    provenance: &Provenance,
    dir: &Path,
) -> Result<NotesDocument, CliError> {
    let theta_f = config.optics.theta_f_deg;
    let table = config.published_table;
    let (mut shares, mut coarse_tabulation) = (Vec::new(), Vec::new());
    for wavelength in &document.wavelengths {
        let path = dir.join("optics").join(&wavelength.phase_csv);
        let phase = PhaseTable::read(&path, Norm::Strict).map_err(optics_error)?;
        let wavelength_um = wavelength.wavelength_um;
        shares.push(WavelengthShares { wavelength_um, shares: angular_shares(&phase, theta_f) });
        coarse_tabulation.push(coarse(&phase, wavelength_um, theta_f));
    }
    Ok(NotesDocument {
        schema: NotesDocument::SCHEMA.to_owned(),
        provenance: provenance.clone(),
        published_source: table.map_or(String::new(), |_| published::SOURCE.to_owned()),
        published_beta: table.map(|_| published::BETA),
        published_shares: table.map(|_| {
            let [forward, wide, backward] = published::SHARES;
            AngularShares { forward, wide, backward }
        }),
        shares,
        coarse_tabulation,
        modified_bias: modified_bias(&read_csv(&dir.join("orders.csv"))?)?,
        published_misfit: published_misfit(
            config,
            cloud,
            parameters,
            &read_json::<Vec<Reference>>(&dir.join("reference.json"))?,
        )?,
    })
}

fn versine(theta_deg: f64) -> f64 {
    1.0 - cos_degrees(theta_deg)
}

fn angular_shares(phase: &PhaseTable, theta_f_deg: f64) -> AngularShares {
    let (forward, half) = (phase.cumulative(versine(theta_f_deg)), phase.cumulative(1.0));
    AngularShares { forward, wide: half - forward, backward: 1.0 - half }
}

/// What a table at 1° steps, integrated linearly in cosΘ, makes of `phase`.
fn coarse(phase: &PhaseTable, wavelength_um: f64, theta_f_deg: f64) -> CoarseTabulation {
    let strip = |degree: u32| {
        let (a, b) = (f64::from(degree), f64::from(degree + 1));
        let mean = 0.5 * (phase.value(versine(a)) + phase.value(versine(b)));
        0.5 * mean * (versine(b) - versine(a))
    };
    let below =
        |limit: f64| (0..180).filter(|d| f64::from(*d) < limit).map(strip).fold(0.0, |sum, x| sum + x);
    let (raw_integral, raw_forward_fraction) = (below(180.0), below(theta_f_deg));
    let forward_fraction = raw_forward_fraction / raw_integral;
    CoarseTabulation { wavelength_um, step_deg: 1.0, raw_integral, raw_forward_fraction, forward_fraction }
}

/// Per incidence, the thickness at which the modified medium's total transmittance is off most.
fn modified_bias(rows: &[OrdersRow]) -> Result<Vec<ModifiedBias>, CliError> {
    let mut bias: Vec<ModifiedBias> = Vec::new();
    for full in rows.iter().filter(|row| row.medium == Medium::Full && row.order == "total") {
        let twin = rows.iter().find(|row| {
            row.medium == Medium::Modified
                && row.order == "total"
                && row.theta_l_deg == full.theta_l_deg
                && row.thickness_m == full.thickness_m
        });
        let Some(modified) = twin else { continue };
        let errors = [full.transmittance_std_error, modified.transmittance_std_error];
        let found = ModifiedBias {
            theta_l_deg: row_incidence(&full.theta_l_deg)?,
            thickness_m: full.thickness_m,
            difference: full.transmittance - modified.transmittance,
            std_error: libm::hypot(errors[0], errors[1]),
        };
        match bias.last_mut() {
            Some(last) if last.theta_l_deg == found.theta_l_deg => {
                if found.difference.abs() > last.difference.abs() {
                    *last = found;
                }
            }
            _ => bias.push(found),
        }
    }
    Ok(bias)
}

fn row_incidence(text: &str) -> Result<RowIncidence, CliError> {
    match text.parse() {
        Ok(degrees) => Ok(RowIncidence::Degrees(degrees)),
        Err(_) if text == "diffuse" => Ok(RowIncidence::diffuse()),
        Err(_) => Err(CliError::Input(format!(
            "orders.csv: theta_l_deg `{text}` is neither an angle nor `diffuse`"
        ))),
    }
}

/// How far the published parameters are from the reference.
fn published_misfit(
    config: &Config,
    cloud: &Cloud,
    parameters: &ParametersDocument,
    references: &[Reference],
) -> Result<Vec<PublishedMisfit>, CliError> {
    let metres = config.fit.thickness_m.metres();
    debug_assert!(cloud.extinction_per_m > 0.0);
    let mut all = Vec::new();
    for row in published::rows(config.published_table)? {
        let wanted = RowIncidence::Degrees(row.theta_l_deg);
        let Some(reference) = references.iter().find(|reference| reference.incidence == wanted) else {
            continue;
        };
        let values = published::values(&row, parameters.metres.kappa_s);
        let mut differences: [Vec<f64>; 5] = Default::default();
        for (k, thickness) in metres.iter().enumerate() {
            let model = curves::fluxes(&values, row.theta_l_deg, *thickness)?;
            let [t_1, t_2, r_1, r_2] = &reference.orders;
            let pairs = [
                (model.t_ms, reference.t_ms[k]),
                (model.t_1, t_1[k]),
                (model.t_2, t_2[k]),
                (model.r_1, r_1[k]),
                (model.r_2, r_2[k]),
            ];
            differences.iter_mut().zip(pairs).for_each(|(list, (model, truth))| list.push(model - truth));
        }
        let names = ["t_ms", "t_1", "t_2", "r_1", "r_2"];
        let misfit = names.iter().zip(&differences).map(|(name, list)| misfit(name, list, &metres)).collect();
        all.push(PublishedMisfit { theta_l_deg: row.theta_l_deg, misfit });
    }
    Ok(all)
}

fn misfit(quantity: &str, differences: &[f64], metres: &[f64]) -> Misfit {
    let square = differences.iter().fold(0.0, |sum, d| sum + d * d) / differences.len() as f64;
    let worst = (0..differences.len())
        .fold(0, |w, k| if differences[k].abs() > differences[w].abs() { k } else { w });
    Misfit {
        quantity: quantity.to_owned(),
        rms: square.sqrt(),
        max: differences[worst].abs(),
        max_at: metres[worst],
    }
}
