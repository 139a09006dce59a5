//! The command `stratiform`: what is typed, the stages it calls, what it prints. The pipeline that ties the stages
//! together is here too, as a library, so that tests can run it.

pub mod args;
pub mod check;
mod commands;
#[cfg(feature = "gpu")]
pub mod compare;
pub mod config;
mod error;
mod interrupt;
mod medium;
mod numbers;
pub mod output;
pub mod pipeline;
mod progress;
mod solve_args;
pub mod trace;

pub use args::Cli;
pub use error::CliError;

use args::Command;
use output::{Data, Talk};

/// Runs a command and returns what belongs on stdout.
///
/// # Errors
/// [`CliError`], whose exit code says which kind.
pub fn run(cli: &Cli) -> Result<Data, CliError> {
    set_up(cli.threads)?;
    let talk = Talk { quiet: cli.quiet };
    match &cli.command {
        Command::Mie(args) => commands::mie::run(args),
        Command::Optics(args) => commands::optics::run(args, talk),
        Command::Trace(args) => commands::trace::run(args, talk),
        Command::Merge(args) => commands::merge::run(args),
        Command::Solve(args) => commands::solve::run(args),
        Command::Fit(args) => commands::stages::fit(args, talk),
        Command::Codegen(args) => commands::codegen::run(args, talk),
        Command::Export(args) => commands::export::run(args, talk),
        Command::Check(args) => commands::check::run(args, talk),
        Command::PhaseCheck(args) => commands::phase_check::run(args, talk),
        Command::Nearest(args) => commands::nearest::run(args),
        Command::Advise(args) => commands::advise::run(args, talk),
        Command::Errors(args) => commands::errors::run(args, talk),
        Command::Reproduce(args) => commands::stages::reproduce(args, talk),
        Command::Chart(args) => commands::chart::run(args, talk),
        Command::Atlas(args) => commands::atlas::run(args, talk),
        Command::Render(args) => commands::render::run(args, talk),
        Command::View(args) => commands::view::run(args, talk),
        Command::Truth(args) => commands::truth::run(args, talk),
        Command::Compare(args) => commands::compare::run(args, talk),
        Command::Report(args) => commands::report::run(args, talk),
        Command::Completions(args) => commands::shell::completions(args),
        Command::Man(args) => commands::shell::man(args),
    }
}

/// Watches for signals; sets the number of threads, one per core if none is given.
///
/// # Errors
/// [`CliError::Input`] outside 1 to 1024 threads.
pub fn set_up(threads: Option<usize>) -> Result<(), CliError> {
    interrupt::install();
    let Some(threads) = threads else { return Ok(()) };
    if !(1..=1024).contains(&threads) {
        return Err(CliError::Input(format!("threads = {threads} is outside [1, 1024]")));
    }
    // A pool that exists already (a second call in one process) keeps its size: the numbers are the same.
    let _ = rayon::ThreadPoolBuilder::new().num_threads(threads).build_global();
    Ok(())
}
