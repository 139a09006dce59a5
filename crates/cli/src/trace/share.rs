//! A share of the photons of a trace, from what was typed to what is counted: what every process does, alone or among
//! others.

use super::{Checkpoint, RunParts, TraceRun};
use crate::args::{SpreadArgs, TraceArgs};
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
    let medium = Medium::parse(&args.medium)?;
    let run = TraceRun::new(args, &medium);
    let engines = run.engines(&medium)?;
    let mut parts = RunParts::nothing(run, share, &engines);
    let _watch = interrupt::watch();
    match checkpoint(&args.spread, talk)? {
        None => parts.trace(&engines, talk, |_| ())?,
        Some(mut checkpoint) => {
            checkpoint.resume(&mut parts)?;
            let traced = parts.trace(&engines, talk, |snapshot| checkpoint.keep(snapshot));
            checkpoint.keep_now(&parts);
            if matches!(traced, Err(CliError::Interrupted)) {
                talk.say(format!(
                    "{} photons are kept: the same command goes on from there",
                    parts.photons()
                ));
            }
            traced?;
        }
    }
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

fn checkpoint(args: &SpreadArgs, talk: Talk) -> Result<Option<Checkpoint>, CliError> {
    let open = |path| Checkpoint::open(path, args.checkpoint_every, talk);
    args.checkpoint.as_deref().map(open).transpose()
}
