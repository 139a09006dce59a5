//! `stratiform completions` and `stratiform man`.

use clap::Args;
use clap_complete::Shell;
use std::path::PathBuf;

/// `stratiform completions`.
#[derive(Debug, Args)]
#[command(
    after_help = "Example: stratiform completions bash > ~/.local/share/bash-completion/completions/stratiform"
)]
pub struct CompletionsArgs {
    /// The shell that reads them.
    pub shell: Shell,
}

/// `stratiform man`.
#[derive(Debug, Args)]
#[command(
    after_help = "Examples:\n  stratiform man | man -l -\n  stratiform man --out ~/.local/share/man/man1"
)]
pub struct ManArgs {
    /// Write the page of every command into this folder instead of printing the main one.
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
}
