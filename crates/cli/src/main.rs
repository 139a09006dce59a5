//! The command: parses, calls, prints.

use clap::Parser;
use std::process::ExitCode;
use stratiform_cli::{Cli, output, run};

fn main() -> ExitCode {
    ExitCode::from(output::finish(run(&Cli::parse())))
}
