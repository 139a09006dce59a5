//! `stratiform errors`: the data that `advise` reads.

use crate::args::ErrorsArgs;
use crate::output::{Data, Talk};
use crate::pipeline::{input_error, optics};
use crate::{CliError, progress};
use stratiform_artifact::{ErrorData, create_folder};
use stratiform_chart::errors::{ErrorsError, Nodes, WAVELENGTHS_UM, make};
use stratiform_methods::Cloud;
use stratiform_optics::OpticsConfig;
use stratiform_optics::droplets::DropletDistribution;
use stratiform_quantities::SingleScatteringAlbedo;

/// γ of the data's droplets, as in Bouthors, Neyret & Lefebvre 2006.
const GAMMA: f64 = 2.0;

/// Runs the command.
///
/// # Errors
/// [`CliError::Failed`] if the truth cannot be solved, [`CliError::Input`] if the folder cannot be written.
pub fn run(args: &ErrorsArgs, talk: Talk) -> Result<Data, CliError> {
    let nodes = if args.small { Nodes::small() } else { Nodes::full() };
    let spinner = progress::spinner("errors", talk.quiet);
    let clouds = nodes.radii_um.iter().map(|radius| clouds(*radius)).collect::<Result<Vec<_>, _>>()?;
    let data = make(&nodes, &clouds, &|| spinner.tick()).map_err(failed)?;
    spinner.finish_and_clear();
    create_folder(&args.out)?;
    data.write(&args.out)?;
    talk.say(format!("{} methods at {} points", data.methods.len(), data.errors.rows.len()));
    let names = ErrorData::FILES.map(|name| args.out.join(name).display().to_string());
    Ok(names.join("\n") + "\n")
}

fn failed(error: ErrorsError) -> CliError {
    CliError::Failed(error.to_string())
}

/// Droplets of that effective radius at the three wavelengths, without absorption.
///
/// # Errors
/// As [`optics::ensembles`].
pub fn clouds(effective_radius_um: f64) -> Result<[Cloud; 3], CliError> {
    let config = OpticsConfig {
        droplets: DropletDistribution::ModifiedGamma { gamma: GAMMA, effective_radius_um },
        number_density_per_cm3: 300.0,
        wavelengths_um: WAVELENGTHS_UM.to_vec(),
        refractive_index: Default::default(),
        theta_f_deg: 5.0,
        tolerance: Default::default(),
    };
    let omega = SingleScatteringAlbedo::new(1.0)?;
    let cloud = |one: stratiform_optics::ensemble::Ensemble| {
        Cloud::new(one.phase, omega, config.theta_f_deg, Some(effective_radius_um)).map_err(input_error)
    };
    let made = optics::ensembles(&config)?.into_iter().map(cloud).collect::<Result<Vec<_>, _>>()?;
    made.try_into().map_err(|_| CliError::Failed("the optics have not three wavelengths".to_owned()))
}
