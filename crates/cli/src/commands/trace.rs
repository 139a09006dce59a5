//! `stratiform trace`: Monte Carlo fluxes per order, as CSV or JSON; with views, `traced_radiance`.

use crate::CliError;
use crate::args::TraceArgs;
use crate::commands::traced_radiance;
use crate::output::{Data, Talk};
use crate::trace::trace_share;
use stratiform_transport::Share;

/// Runs the command.
///
/// # Errors
/// [`CliError::Input`] for bad input; [`CliError::Unmet`], with the result, if the error asked for was not reached;
/// [`CliError::Interrupted`], after a checkpoint if there is one.
pub fn run(args: &TraceArgs, talk: Talk) -> Result<Data, CliError> {
    if !args.views.view_mu.is_empty() {
        return traced_radiance::run(args, talk);
    }
    let share = args.spread.shard.unwrap_or(Share::WHOLE);
    let parts = trace_share(args, share, talk)?;
    match &args.spread.out {
        None => parts.print(args.json),
        Some(out) => {
            parts.write(out)?;
            talk.say(format!("{}: shard {share}, {} photons", out.display(), parts.photons()));
            Ok(Data::new())
        }
    }
}
