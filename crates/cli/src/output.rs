//! stdout is data: written once, whole, when everything has succeeded. stderr is talk.

use crate::{CliError, progress};
use std::io::{ErrorKind, Write};

/// What a command hands to `main` for stdout.
pub type Data = String;

/// Writes `data` to stdout. A reader that closed the pipe has what it wanted.
///
/// # Errors
/// [`CliError::Input`] if stdout cannot be written, a full disk for example.
pub fn emit(data: &str) -> Result<(), CliError> {
    let mut stdout = std::io::stdout().lock();
    match stdout.write_all(data.as_bytes()).and_then(|()| stdout.flush()) {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => {
            Err(CliError::Input(format!("cannot write to standard output: {error}")))
        }
        _ => Ok(()),
    }
}

/// Ends a command: data to stdout, an error to stderr. Returns the exit code.
#[expect(clippy::print_stderr, reason = "errors are said even when quiet")]
pub fn finish(result: Result<Data, CliError>) -> u8 {
    let printed = match result {
        Err(CliError::Unmet { message, data }) => emit(&data).and(Err(CliError::Failed(message))),
        result => result.and_then(|data| emit(&data)),
    };
    match printed {
        Ok(()) => 0,
        Err(error) => {
            eprintln!("error: {error}");
            error.code()
        }
    }
}

/// Says something on stderr unless told to be quiet.
#[derive(Clone, Copy, Debug)]
pub struct Talk {
    /// No talk at all, except errors.
    pub quiet: bool,
}

impl Talk {
    /// One line on stderr.
    #[expect(clippy::print_stderr, reason = "the one place where the command talks")]
    pub fn say(self, line: impl std::fmt::Display) {
        if !self.quiet {
            progress::beside_bars(|| eprintln!("{line}"));
        }
    }
}
