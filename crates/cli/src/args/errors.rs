//! `stratiform errors`.

use clap::Args;
use std::path::PathBuf;

/// What is typed.
#[derive(Debug, Args)]
#[command(
    after_help = "Example: stratiform errors --out fit-configs/chart\nTakes minutes; costs are those of this machine, at its quickest."
)]
pub struct ErrorsArgs {
    /// Folder to write errors.csv, colour.csv and methods.csv to.
    #[arg(long, value_name = "DIR")]
    pub out: PathBuf,
    /// Take truths from the data in this folder where it has them: after a method changed, nothing is solved again.
    #[arg(long, value_name = "DIR")]
    pub before: Option<PathBuf>,
    /// A few nodes only, for trials.
    #[arg(long)]
    pub small: bool,
}
