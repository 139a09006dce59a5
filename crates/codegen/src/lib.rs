//! Shader modules and tables from fitted parameters and phase functions: deterministic text in every target language.
//!
//! [`generate`] turns [`Inputs`] into named [`Files`], [`write`](fn@write) puts them into a folder, [`check`] compares a
//! folder with them. Nothing is computed here but the interpolation between the table's rows and its error. The
//! libraries are written once, in WGSL, and printed in the other languages by [`language`]; [`usage`] shows each in use.
//!
//! | file | content |
//! | --- | --- |
//! | `stratiform.*` | the one-dimensional model over (μ_l, optical thickness), with its table and self-test, a [`Target`] each |
//! | `stratiform_phase.*` | look-up of the phase functions, likewise |
//! | `stratiform_weights.*` | what single and double scattering in a slab share, for the three below |
//! | `stratiform_radiance.*` | the angular model of radiance, on top of the three above, with its self-test |
//! | `stratiform_shade.*` | the fitted model of radiance, likewise, where its coefficients are given |
//! | `stratiform_halo.*`, `halo.json` | light that met forward events only, likewise, with its table |
//! | `stratiform_self_test.{wgsl,spv}` | compute entry point that evaluates the model over a buffer |
//! | `self_test.json` | inputs for it and the f64 model's outputs |
//! | `radiance_test.csv`, `shade_test.csv` | inputs for the two libraries of radiance and the f64 models' outputs |
//! | `parameters.json`, `parameters.csv` | the parameters, with errors and flags |
//! | `phase_full.csv`, `phase_modified.csv`, `phase_squared.csv` | P, P_S and P_S convolved with itself |
//! | `phase_warped.csv` | the same on the angle map of `stratiform_quantities` |
//! | `stratiform_family.*`, `family_*.csv` | with [`generate_family`]: the same over effective radius |

mod embedded_test;
mod error;
mod error_card;
mod family;
mod files;
mod halo_library;
mod inputs;
pub mod language;
mod node_error;
mod phase;
mod phase_library;
mod radiance_library;
mod radiance_test;
mod self_test;
mod shade_library;
mod shade_test;
mod shader;
mod spirv;
mod stale;
mod table_access;
mod tables;
mod text;
pub mod usage;
mod weights_library;

pub use error::CodegenError;
pub use error_card::{ErrorCard, error_card};
pub use family::{FAMILY_COORDINATE, FamilyVector, family_member, generate_family, parameter_family};
pub use files::Files;
pub use inputs::{HaloTable, Inputs, PhaseRow, PhaseTables, QUANTITIES, ReferencePoint};
pub use language::{SubsetError, Target};
pub use node_error::leave_one_out;
pub use phase::COUNT as PHASE_TEXELS;
pub use radiance_test::RadianceVector;
pub use self_test::{SelfTest, SelfTestVector, self_test_module};
pub use shade_test::ShadeVector;
pub use stale::{REGENERATE, Stale, check, left_over, write};
pub use tables::{diffuse_parameters, parameter_grid};

/// Every file for the `targets`, and the tables.
///
/// # Errors
/// [`CodegenError`] if the inputs are out of domain, incomplete, or do not fit together.
pub fn generate(inputs: &Inputs, targets: &[Target]) -> Result<Files, CodegenError> {
    inputs.check()?;
    let mut files: Vec<(String, Vec<u8>)> = Vec::new();
    let tables = tables::files(inputs)?.into_iter().chain(phase::files(inputs)?);
    files.extend(tables.map(|(name, text)| (name, text.into_bytes())));
    files.push(("self_test.json".to_owned(), self_test::document(inputs)?.into_bytes()));
    if let Some(halo) = &inputs.halo {
        files.push(("halo.json".to_owned(), stratiform_artifact::to_json(halo)?.into_bytes()));
    }
    files.push(("radiance_test.csv".to_owned(), radiance_test::document(inputs)?.into_bytes()));
    if let Some(document) = &inputs.radiance {
        files.push(("shade_test.csv".to_owned(), shade_test::document(inputs, document)?.into_bytes()));
    }
    let (fluxes, phase) = (shader::library(inputs)?, phase_library::library(inputs, &[]));
    let weights = weights_library::library(inputs, &fluxes);
    let needs = vec![&fluxes, &weights, &phase];
    let radiance = radiance_library::library(inputs, needs.clone())?;
    let shade = |document| shade_library::library(inputs, document, needs.clone());
    let shade = inputs.radiance.as_ref().map(shade).transpose()?;
    let halo = |table| halo_library::library(inputs, table, needs.clone());
    let halo = inputs.halo.as_ref().map(halo).transpose()?;
    let libraries: Vec<_> = needs.iter().copied().chain([&radiance]).chain(&shade).chain(&halo).collect();
    for library in &libraries {
        let texts = language::translate(library, targets)?.into_iter();
        files.extend(texts.map(|(name, text)| (name, text.into_bytes())));
    }
    let kernel = self_test::kernel(inputs);
    if targets.contains(&Target::Spirv) {
        let module = spirv::module(&format!("{}\n{kernel}", fluxes.code))?;
        files.push(("stratiform_self_test.spv".to_owned(), module));
    }
    if targets.contains(&Target::Wgsl) {
        files.push(("stratiform_self_test.wgsl".to_owned(), kernel.into_bytes()));
    }
    Ok(files.into_iter().collect())
}
