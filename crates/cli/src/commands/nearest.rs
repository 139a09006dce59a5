//! `stratiform nearest`: analytic phase functions near a table, with their measured error.

use crate::args::NearestArgs;
use crate::output::Data;
use crate::{CliError, medium, pipeline};
use stratiform_optics::phase::Norm;
use stratiform_tables::nearest::nearest;

/// Runs the command.
///
/// # Errors
/// [`CliError::Input`] for bad input.
pub fn run(args: &NearestArgs) -> Result<Data, CliError> {
    let norm = if args.renormalise { Norm::Any } else { Norm::Strict };
    let table = medium::phase_table(&args.phase, norm)?;
    let found = nearest(&table, args.theta_f, args.diameter).map_err(pipeline::input_error)?;
    let text = if args.json { found.to_json() } else { found.to_csv() };
    text.map_err(pipeline::input_error)
}
