//! `stratiform-mpi trace`: the photons of one trace shared out over MPI ranks, the bytes of `stratiform trace`.
//!
//! Each rank traces share K/N as `stratiform trace --shard K/N` does, the first one adds the counts up as
//! `stratiform merge` does and prints. Nothing reaches stdout before every photon is counted once. Bad input is told by
//! one rank and ends all; where a rank is lost, `mpirun` ends the job.

mod args;
mod checkpoints;
mod ranks;

use args::{Command, MpiArgs};
use clap::Parser;
use mpi::Threading;
use ranks::Ranks;
use std::process::ExitCode;
use stratiform_cli::args::TraceArgs;
use stratiform_cli::output::{self, Talk};
use stratiform_cli::trace::{Checkpoint, Device, Medium, RunParts, TraceRun};
use stratiform_cli::{CliError, set_up};

fn main() -> ExitCode {
    let Some((universe, _)) = mpi::initialize_with_threading(Threading::Funneled) else {
        return ExitCode::FAILURE;
    };
    let ranks = Ranks::new(universe.world());
    let code = run(&ranks).err().unwrap_or(0);
    ExitCode::from(code)
}

fn run(ranks: &Ranks) -> Result<(), u8> {
    let typed = MpiArgs::try_parse();
    let MpiArgs { command, threads, quiet } = ranks.agree(typed, |error| {
        // Where not even the message can be written there is nobody to tell.
        let _ = error.print();
        error.exit_code() as u8
    })?;
    let Command::Trace(args) = command;
    let talk = Talk { quiet: quiet || !ranks.is_first() };
    let checked = set_up(Some(threads)).and_then(|()| prepared(ranks, args));
    let args = ranks.agree(checked, |error| ranks.say(error))?;
    match trace(ranks, &args, talk)? {
        Some(sum) => finish(output::finish(sum.print(args.json))),
        None => Ok(()),
    }
}

fn finish(code: u8) -> Result<(), u8> {
    if code == 0 { Ok(()) } else { Err(code) }
}

/// The arguments of this rank, with a checkpoint of its own.
fn prepared(ranks: &Ranks, mut args: TraceArgs) -> Result<TraceArgs, CliError> {
    args::check(&args, ranks.count())?;
    if let Some(file) = args.spread.checkpoint.take() {
        if ranks.is_first() {
            checkpoints::refuse_other_sizes(&file, ranks.count())?;
        }
        args.spread.checkpoint = Some(checkpoints::of_rank(&file, ranks.share()?));
    }
    Ok(args)
}

/// All photons at the first rank, nothing at the others.
fn trace(ranks: &Ranks, args: &TraceArgs, talk: Talk) -> Result<Option<RunParts>, u8> {
    let say = |error| ranks.say(error);
    let device = ranks.agree(Device::open(args), say)?;
    let medium = ranks.agree(Medium::parse(&args.medium), say)?;
    let run = TraceRun::new(args, &medium, &device);
    let engines = ranks.agree(run.engines(&medium, &device), say)?;
    let mut parts = RunParts::nothing(run, ranks.agree(ranks.share(), say)?, &engines);
    ranks.agree(ranks.check_same(&parts), say)?;
    let checkpoint = ranks.agree(Checkpoint::resumed(&args.spread, &mut parts, talk), say)?;
    let traced = parts.trace_keeping(&engines, checkpoint, talk).and_then(|()| ranks.sum(parts));
    Ok(traced.unwrap_or_else(|error| ranks.end_all(error)))
}
