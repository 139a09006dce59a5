//! `stratiform render`: a scene's picture. Without the cargo feature `gpu` it says how to get one.

#[cfg(feature = "gpu")]
mod draw;
#[cfg(feature = "gpu")]
mod settings;

#[cfg(feature = "gpu")]
pub use settings::said;

use crate::CliError;
use crate::args::RenderArgs;
use crate::output::{Data, Talk};

/// Runs the command.
///
/// # Errors
/// [`CliError::Input`] for a scene that is no picture, contributions that do not exist, files that cannot be read or written, or a
/// device that is missing or fails.
#[cfg(feature = "gpu")]
pub fn run(args: &RenderArgs, talk: Talk) -> Result<Data, CliError> {
    draw::run(args, talk)
}

/// Refuses.
///
/// # Errors
/// [`CliError::Input`], always.
#[cfg(not(feature = "gpu"))]
pub fn run(args: &RenderArgs, _talk: Talk) -> Result<Data, CliError> {
    Err(crate::commands::picture::unavailable("draw", &args.scene, "gpu"))
}
