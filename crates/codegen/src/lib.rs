//! Shader modules and tables from fitted parameters and phase functions: deterministic text.
//!
//! [`generate`] turns [`Inputs`] into named texts, [`write`](fn@write) puts them into a folder, [`check`] compares a folder
//! with them. Nothing is computed here but the interpolation between the table's rows and its error.
//!
//! | file | content |
//! | --- | --- |
//! | `stratiform.wgsl` | the one-dimensional model over (μ_l, optical thickness), with its table |
//! | `stratiform_phase.wgsl` | look-up of the phase functions in a storage buffer |
//! | `stratiform_self_test.wgsl` | compute entry point that evaluates the model over a buffer |
//! | `self_test.json` | inputs for it and the f64 model's outputs |
//! | `parameters.json`, `parameters.csv` | the parameters, with errors and flags |
//! | `phase_full.csv`, `phase_modified.csv`, `phase_squared.csv` | P, P_S and P_S convolved with itself |
//! | `phase_warped.csv` | the same on the shader's angle grid |

mod error;
mod error_card;
mod inputs;
mod node_error;
mod phase;
mod self_test;
mod shader;
mod stale;
mod tables;
mod text;

pub use error::CodegenError;
pub use error_card::{ErrorCard, error_card};
pub use inputs::{Inputs, PhaseRow, PhaseTables, QUANTITIES, ReferencePoint};
pub use node_error::leave_one_out;
pub use self_test::{SelfTest, SelfTestVector, self_test_module};
pub use stale::{REGENERATE, Stale, check, write};
pub use tables::{diffuse_parameters, parameter_grid};

use std::collections::BTreeMap;

/// Every emitted file by name.
///
/// # Errors
/// [`CodegenError`] if the inputs are out of domain, incomplete, or do not fit together.
pub fn generate(inputs: &Inputs) -> Result<BTreeMap<String, String>, CodegenError> {
    inputs.check()?;
    let mut files = BTreeMap::from_iter(tables::files(inputs)?);
    files.extend(phase::files(inputs)?);
    files.extend(self_test::files(inputs)?);
    files.insert("stratiform.wgsl".to_owned(), shader::module(inputs)?);
    Ok(files)
}
