//! The command: parses, calls, prints.

use clap::Parser;
use std::process::ExitCode;
use stratiform_cli::{Cli, output, run};

#[expect(clippy::print_stderr, reason = "errors are said even when quiet")]
fn main() -> ExitCode {
    let cli = Cli::parse();
    match run(&cli).and_then(|data| output::emit(&data)) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            error.exit_code()
        }
    }
}
