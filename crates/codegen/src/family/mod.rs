//! A family of clouds over effective radius: what is emitted beside the library of one cloud.
//!
//! | file | content |
//! | --- | --- |
//! | `stratiform_family.*` | the one-dimensional model over (μ_l, r_e, τ), with tables and self-test |
//! | `family_test.csv` | inputs for it and the f64 model's outputs |
//! | `stratiform_phase.*` | as of one cloud, with rows for every radius below |
//! | `stratiform_family_phase.*` | look-up of the phase functions over (Θ, r_e) |
//! | `family_phase.csv` | P and P_S convolved with itself: a row per angle of the angle map, function and radius |
//!
//! P at another radius is interpolated linearly in P and ln r_e ([`PhaseFamily`](stratiform_model::family::PhaseFamily)).

mod library;
mod phase_library;
mod tables;
mod vectors;

pub use tables::{FAMILY_COORDINATE, family_member, parameter_family};
pub use vectors::FamilyVector;

use crate::language::translate;
use crate::{CodegenError, Files, Inputs, Target, shader};
use serde::Serialize;
use stratiform_artifact::{FamilyDocument, to_csv};
use stratiform_quantities::angle_map::angle_deg;

/// A row of `family_phase.csv`.
#[derive(Serialize)]
struct PhaseRow {
    effective_radius_um: f64,
    index: usize,
    theta_deg: f64,
    p: f64,
    p_squared: f64,
}

/// The family's files for the `targets`, to stand beside those of [`generate`](crate::generate).
///
/// # Errors
/// [`CodegenError`] if the inputs are out of domain, incomplete, or do not fit together.
pub fn generate_family(
    inputs: &Inputs,
    family: &FamilyDocument,
    targets: &[Target],
) -> Result<Files, CodegenError> {
    inputs.check()?;
    let fluxes = shader::library(inputs)?;
    let over_radius = library::library(inputs, family, &fluxes)?;
    let phase = crate::phase_library::library(inputs, &phase_library::rows(family)?);
    let phase_over_radius = phase_library::library(inputs, family, &phase)?;
    let mut files = vec![
        ("family_test.csv".to_owned(), to_csv(&vectors::vectors(family)?)?),
        ("family_phase.csv".to_owned(), to_csv(&phase_rows(family))?),
    ];
    let libraries = [&over_radius, &phase, &phase_over_radius];
    for library in libraries {
        files.extend(translate(library, targets)?);
    }
    Ok(files.into_iter().map(|(name, text)| (name, text.into_bytes())).collect())
}

fn phase_rows(family: &FamilyDocument) -> Vec<PhaseRow> {
    let mut rows = Vec::new();
    for member in &family.members {
        let last = member.phase.len().saturating_sub(1).max(1) as f64;
        for (index, (p, p_squared)) in member.phase.iter().zip(&member.phase_squared).enumerate() {
            rows.push(PhaseRow {
                effective_radius_um: member.effective_radius_um,
                index,
                theta_deg: angle_deg(index as f64 / last),
                p: *p,
                p_squared: *p_squared,
            });
        }
    }
    rows
}
