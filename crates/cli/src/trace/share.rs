//! A share of the photons of a trace, from what was typed to what is counted: what every process does, alone or among
//! others.

use super::{Checkpoint, Device, RunParts, TraceRun};
use crate::args::TraceArgs;
use crate::medium::Medium;
use crate::output::Talk;
use crate::{CliError, interrupt, pipeline};
use stratiform_transport::{Share, TransportError};

/// Traces `share` of what `args` ask for, going on from the checkpoint that they name and keeping it.
/// `args.spread.shard` and `out` are left to the caller.
///
/// # Errors
/// [`CliError::Input`] for bad input; [`CliError::Interrupted`], after a checkpoint if there is one.
pub fn trace_share(args: &TraceArgs, share: Share, talk: Talk) -> Result<RunParts, CliError> {
    check(args, share)?;
    let device = Device::open(args)?;
    let medium = Medium::parse(&args.medium)?;
    let run = TraceRun::new(args, &medium, &device);
    let engines = run.engines(&medium, &device)?;
    let mut parts = RunParts::nothing(run, share, &engines);
    let _watch = interrupt::watch();
    let checkpoint = Checkpoint::resumed(&args.spread, &mut parts, talk)?;
    parts.trace_keeping(&engines, checkpoint, talk)?;
    Ok(parts)
}

/// What can be checked before the medium is known.
fn check(args: &TraceArgs, share: Share) -> Result<(), CliError> {
    TraceRun::check(args)?;
    if share.of() > 1 && args.std_error.is_some() {
        let place = format!("shard {share} with --std-error");
        return Err(pipeline::trace_error(TransportError::OneAfterTheOther).at(&place));
    }
    if args.spread.out.is_some() && args.spread.out == args.spread.checkpoint {
        return Err(CliError::Input("--out and --checkpoint name the same file".to_owned()));
    }
    if !args.views.view_mu.is_empty() {
        let message = "a share of --view-mu: radiance is summed in the order of the photons, in one process";
        return Err(CliError::Input(message.to_owned()));
    }
    Ok(())
}
