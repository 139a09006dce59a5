//! The command: parses, calls, prints.

use clap::Parser;
use std::process::ExitCode;
use stratiform_cli::{Cli, CliError, output, run};

#[expect(clippy::print_stderr, reason = "errors are said even when quiet")]
fn main() -> ExitCode {
    let cli = Cli::parse();
    let printed = match run(&cli) {
        Err(CliError::Unmet { message, data }) => {
            output::emit(&data).and(Err(CliError::Unmet { message, data: String::new() }))
        }
        result => result.and_then(|data| output::emit(&data)),
    };
    match printed {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            error.exit_code()
        }
    }
}
