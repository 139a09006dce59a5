//! `stratiform compare`: a picture against its truth. Without the cargo feature `gpu` it says how to get one.

#[cfg(feature = "gpu")]
mod run;
#[cfg(feature = "gpu")]
mod said;

use crate::CliError;
use crate::args::CompareArgs;
use crate::output::{Data, Talk};

/// Runs the command.
///
/// # Errors
/// [`CliError::Input`] for a scene that is no picture, a truth that does not fit it, files that cannot be read or written, or a device
/// that is missing or fails; [`CliError::Failed`] for costs on a device without a clock.
#[cfg(feature = "gpu")]
pub fn run(args: &CompareArgs, talk: Talk) -> Result<Data, CliError> {
    run::run(args, talk)
}

/// Refuses.
///
/// # Errors
/// [`CliError::Input`], always.
#[cfg(not(feature = "gpu"))]
pub fn run(args: &CompareArgs, _talk: Talk) -> Result<Data, CliError> {
    Err(crate::commands::picture::unavailable("draw", &args.scene, "gpu"))
}
