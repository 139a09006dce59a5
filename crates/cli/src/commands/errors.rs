//! `stratiform errors`: the data that `advise` reads.

use crate::args::ErrorsArgs;
use crate::output::{Data, Talk};
use crate::pipeline::visible::clouds;
use crate::{CliError, progress};
use stratiform_artifact::{ErrorData, create_folder};
use stratiform_chart::errors::{ErrorsError, Nodes, make};

/// Runs the command.
///
/// # Errors
/// [`CliError::Failed`] if the truth cannot be solved, [`CliError::Input`] if the folder cannot be written.
pub fn run(args: &ErrorsArgs, talk: Talk) -> Result<Data, CliError> {
    let nodes = if args.small { Nodes::small() } else { Nodes::full() };
    let before = args.before.as_deref().map(ErrorData::read).transpose()?;
    let spinner = progress::spinner("errors", talk.quiet);
    let clouds = nodes.radii_um.iter().map(|radius| clouds(*radius)).collect::<Result<Vec<_>, _>>()?;
    let data = make(&nodes, &clouds, before.as_ref(), &|| spinner.tick()).map_err(failed)?;
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
