//! Options of `stratiform trace` that spread it over time and machines.

use crate::numbers::{seconds, share};
use clap::Args;
use std::path::PathBuf;
use std::time::Duration;
use stratiform_transport::Share;

/// Checkpoint and shard.
#[derive(Debug, Args)]
pub struct SpreadArgs {
    /// Keep what is counted in this file, and go on from it if it is there. It stays when all is done; the same command
    /// then prints at once.
    #[arg(long, value_name = "FILE")]
    pub checkpoint: Option<PathBuf>,
    /// Seconds from one checkpoint to the next; there is one on Ctrl-C and SIGTERM too.
    #[arg(long, value_name = "SECONDS", value_parser = seconds, default_value = "60", requires = "checkpoint")]
    pub checkpoint_every: Duration,
    /// Trace the K-th of N equal shares of the photons, K from 1, into --out; `stratiform merge` prints the sum.
    #[arg(long, value_name = "K/N", value_parser = share, requires = "out", conflicts_with = "json")]
    pub shard: Option<Share>,
    /// Where the shard's counts go.
    #[arg(long, value_name = "FILE", requires = "shard")]
    pub out: Option<PathBuf>,
}
