//! `stratiform merge` as typed.

use clap::Args;
use std::path::PathBuf;

/// `stratiform merge`.
#[derive(Debug, Args)]
#[command(
    after_help = "Example, four processes anywhere, then their sum:\n  for k in 1 2 3 4; do stratiform trace --phase hg:0.85 --tau 16 \
                  --mu0 1 --photons 1e8 --shard $k/4 --out part$k.bin; done\n  stratiform merge part?.bin\nPrints the \
                  bytes that one process prints. The files may be of any shards that together have every photon once: \
                  N need not be the same, and a checkpoint of a finished trace is one too. Damaged, doubled, missing or foreign \
                  ones are refused by name."
)]
pub struct MergeArgs {
    /// Files that `trace --shard` wrote, in any order.
    #[arg(required = true, value_name = "FILE")]
    pub files: Vec<PathBuf>,
    /// Print one JSON object instead of CSV.
    #[arg(long)]
    pub json: bool,
}
