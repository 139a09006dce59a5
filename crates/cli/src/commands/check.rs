//! `stratiform check`: from what was typed to what is printed.

use crate::CliError;
use crate::args::CheckArgs;
use crate::check::config::TracerConfig;
use crate::check::counts;
use crate::config::Config;
use crate::output::{Data, Talk};
use crate::pipeline;
use std::path::Path;
use stratiform_artifact::write_csv;

/// Runs the command.
///
/// # Errors
/// [`CliError`].
pub fn run(args: &CheckArgs, talk: Talk) -> Result<Data, CliError> {
    let mut config = Config::load(&args.config)?;
    if let Some(file) = &args.store_counts {
        return store_counts(&mut config, args, file, talk);
    }
    Err(CliError::Input("not yet".to_owned()))
}

fn tracer_section<'a>(config: &'a mut Config, path: &Path) -> Result<&'a mut TracerConfig, CliError> {
    let message = format!("{}: the section [check.tracer] is missing", path.display());
    config.check.tracer.as_mut().ok_or(CliError::Input(message))
}

fn store_counts(config: &mut Config, args: &CheckArgs, file: &Path, talk: Talk) -> Result<Data, CliError> {
    let tracer = tracer_section(config, &args.config)?;
    tracer.stored_photons = args.photons.unwrap_or(tracer.stored_photons);
    tracer.stored_seed = args.seed.unwrap_or(tracer.stored_seed);
    let tracer = tracer.clone();
    config.check_again()?;
    let cloud = pipeline::optics::at_transport_wavelength(config)?;
    let rows = counts::trace(config, &cloud, &tracer, tracer.stored_photons, tracer.stored_seed, talk)?;
    write_csv(file, &rows)?;
    Ok(format!("{}\n", file.display()))
}
