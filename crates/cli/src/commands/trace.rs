//! `stratiform trace`: Monte Carlo fluxes per order, as CSV or JSON; with views, `traced_radiance`.

use crate::args::{SpreadArgs, TraceArgs};
use crate::commands::traced_radiance;
use crate::medium::Medium;
use crate::output::{Data, Talk};
use crate::trace::{Checkpoint, RunParts, TraceRun};
use crate::{CliError, interrupt, pipeline};
use stratiform_transport::{Share, TransportError};

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
    check(args, share)?;
    let medium = Medium::parse(&args.medium)?;
    let run = TraceRun::new(args, &medium);
    let jobs = run.jobs(&medium)?;
    let mut parts = RunParts::nothing(run, share, &jobs);
    let watch = interrupt::watch();
    match checkpoint(&args.spread, talk)? {
        None => parts.trace(&jobs, talk, |_| ())?,
        Some(mut checkpoint) => {
            checkpoint.resume(&mut parts)?;
            let traced = parts.trace(&jobs, talk, |snapshot| checkpoint.keep(snapshot));
            checkpoint.keep_now(&parts);
            traced?;
        }
    }
    drop(watch);
    match &args.spread.out {
        None => parts.print(args.json),
        Some(out) => {
            parts.write(out)?;
            talk.say(format!("{}: shard {share}, {} photons", out.display(), parts.photons()));
            Ok(Data::new())
        }
    }
}

fn check(args: &TraceArgs, share: Share) -> Result<(), CliError> {
    TraceRun::check(args)?;
    if share.of() > 1 && args.std_error.is_some() {
        let place = format!("--shard {share} with --std-error");
        return Err(pipeline::trace_error(TransportError::OneAfterTheOther).at(&place));
    }
    if args.spread.out.is_some() && args.spread.out == args.spread.checkpoint {
        return Err(CliError::Input("--out and --checkpoint name the same file".to_owned()));
    }
    Ok(())
}

fn checkpoint(args: &SpreadArgs, talk: Talk) -> Result<Option<Checkpoint>, CliError> {
    let open = |path| Checkpoint::open(path, args.checkpoint_every, talk);
    args.checkpoint.as_deref().map(open).transpose()
}
