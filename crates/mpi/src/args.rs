//! The command line: that of `stratiform trace`, less what one process or one rank alone can do.

use clap::{Parser, Subcommand};
use stratiform_cli::CliError;
use stratiform_cli::args::TraceArgs;
use stratiform_cli::trace::TraceRun;

/// `stratiform trace` over the ranks of an MPI job: the same arguments, the same bytes on stdout.
#[derive(Debug, Parser)]
#[command(
    name = "stratiform-mpi",
    version,
    max_term_width = 100,
    arg_required_else_help = true,
    after_help = "Example: mpirun -n 4 stratiform-mpi trace --phase hg:0.85 --tau 1,16 --mu0 1 --photons 1e9\nEach rank \
                  traces an equal share of the photons, rank 0 prints. With --checkpoint FILE each rank keeps \
                  FILE.rank-K-of-N; the same command with as many ranks goes on from them. If a rank is lost the job \
                  ends without output."
)]
pub struct MpiArgs {
    /// What to do.
    #[command(subcommand)]
    pub command: Command,
    /// Threads of each rank; the numbers do not depend on it.
    #[arg(long, global = true, value_name = "N", default_value_t = 1)]
    pub threads: usize,
    /// Say nothing on stderr but errors.
    #[arg(long, global = true)]
    pub quiet: bool,
}

/// What ranks do together.
#[derive(Debug, Subcommand)]
pub enum Command {
    /// Monte Carlo reflectance and transmittance of slabs, per scattering order.
    Trace(TraceArgs),
}

/// Checks what can be checked before the medium is known.
///
/// # Errors
/// [`CliError::Input`] naming the number that is out of domain, or the option that `ranks` cannot share.
pub fn check(args: &TraceArgs, ranks: u64) -> Result<(), CliError> {
    let refuse = |message: &str| Err(CliError::Input(message.to_owned()));
    TraceRun::check(args)?;
    if !args.views.view_mu.is_empty() {
        return refuse("--view-mu is for one process: radiance is summed in the order of the photons");
    }
    if args.spread.shard.is_some() {
        return refuse("--shard is for single processes: each rank traces a share of its own");
    }
    if args.std_error.is_some() && ranks > 1 {
        return Err(CliError::Input(format!(
            "--std-error is for one rank, not {ranks}: how long such a trace is depends on the results of all photons"
        )));
    }
    Ok(())
}
