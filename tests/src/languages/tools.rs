//! Compilers and validators of other languages: run, or skipped loudly where they are missing.

use std::fs::{self, File};
use std::io::{ErrorKind, Write as _};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::atomic::{AtomicUsize, Ordering};
use tempfile::TempDir;

/// Why a tool gave nothing.
#[derive(Debug, thiserror::Error)]
pub enum ToolError {
    /// The machine does not have it.
    #[error("{0} is not installed")]
    Missing(&'static str),
    /// It refused its input, or the compiled program failed.
    #[error("{command}\n{said}")]
    Refused {
        /// What was run.
        command: String,
        /// What it said.
        said: String,
    },
    /// The scratch folder could not be used.
    #[error("{0}")]
    Io(#[from] std::io::Error),
}

static SKIPPED: AtomicUsize = AtomicUsize::new(0);

/// What a tool gave; or, where the machine has no such tool, a loud skip. With `STRATIFORM_REQUIRE_TOOLS=1` that is a
/// failure, except for the tools in `optional`.
///
/// # Panics
/// If the tool refused: a test then fails.
pub fn available<T>(result: Result<T, ToolError>, optional: &[&str]) -> Option<T> {
    let required = std::env::var_os("STRATIFORM_REQUIRE_TOOLS").is_some();
    match result {
        Ok(value) => Some(value),
        Err(error @ ToolError::Missing(tool)) if !required || optional.contains(&tool) => {
            skip(&error);
            None
        }
        Err(error) => panic!("{error}"),
    }
}

/// Says that a test is skipped, and how many were.
pub fn skip(reason: &impl std::fmt::Display) {
    let count = SKIPPED.fetch_add(1, Ordering::Relaxed) + 1;
    // Past the test harness's capture: a skipped test must be seen.
    let _ = std::io::stderr().write_all(format!("SKIPPED ({count}): {reason}\n").as_bytes());
}

/// A folder that goes away with it, for the files of one compilation.
pub struct Scratch(TempDir);

impl Scratch {
    /// A fresh folder.
    ///
    /// # Errors
    /// If there is no room for one.
    pub fn new() -> Result<Self, ToolError> {
        Ok(Self(TempDir::new()?))
    }

    /// Writes a file into it.
    ///
    /// # Errors
    /// If it cannot be written.
    pub fn write(&self, name: &str, content: impl AsRef<[u8]>) -> Result<PathBuf, ToolError> {
        let path = self.path(name);
        fs::write(&path, content)?;
        Ok(path)
    }

    /// The path of `name` in it.
    pub fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    /// Runs `tool` in it and gives what it wrote to stdout.
    ///
    /// # Errors
    /// [`ToolError::Missing`] if there is no such program, [`ToolError::Refused`] if it fails.
    pub fn run(&self, tool: &'static str, arguments: &[&str]) -> Result<Vec<u8>, ToolError> {
        self.execute(tool, Command::new(tool).args(arguments).stdin(Stdio::null()))
    }

    /// Runs the compiled `program` with `input` on stdin and gives what it wrote to stdout.
    ///
    /// # Errors
    /// [`ToolError::Refused`] if it fails.
    pub fn run_program(&self, program: &str, input: &[u8]) -> Result<Vec<u8>, ToolError> {
        let input = File::open(self.write("input", input)?)?;
        self.execute("the compiled program", Command::new(self.path(program)).stdin(input))
    }

    fn execute(&self, tool: &'static str, command: &mut Command) -> Result<Vec<u8>, ToolError> {
        let output = command.current_dir(self.0.path()).output();
        let output = output.map_err(|error| match error.kind() {
            ErrorKind::NotFound => ToolError::Missing(tool),
            _ => ToolError::Io(error),
        })?;
        if output.status.success() {
            return Ok(output.stdout);
        }
        let said = [output.stdout, output.stderr].concat();
        let said = String::from_utf8_lossy(&said).into_owned();
        Err(ToolError::Refused { command: format!("{command:?}"), said })
    }
}

/// SPIR-V words of a file.
///
/// # Errors
/// If it cannot be read.
pub fn words(path: &Path) -> Result<Vec<u32>, ToolError> {
    Ok(words_of(&fs::read(path)?))
}

/// SPIR-V words of bytes.
pub fn words_of(bytes: &[u8]) -> Vec<u32> {
    bytes.as_chunks().0.iter().map(|four| u32::from_le_bytes(*four)).collect()
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "a test may stop where it fails")]

    use super::*;

    #[test]
    fn a_missing_tool_is_told_from_one_that_refuses() {
        let scratch = Scratch::new().unwrap();
        assert!(matches!(scratch.run("no-such-compiler", &[]), Err(ToolError::Missing("no-such-compiler"))));
        let refused = scratch.run("rustc", &["no-such-file.rs"]).unwrap_err();
        assert!(matches!(&refused, ToolError::Refused { said, .. } if said.contains("no-such-file.rs")));
    }

    #[test]
    fn an_optional_tool_is_skipped() {
        assert!(
            available::<()>(
                Err(ToolError::Missing("a tool invented by this test")),
                &["a tool invented by this test"]
            )
            .is_none()
        );
        assert_eq!(available(Ok(1), &[]), Some(1));
    }

    #[test]
    #[should_panic = "refused here"]
    fn a_refusal_is_never_skipped() {
        let refused = ToolError::Refused { command: "tool".to_owned(), said: "refused here".to_owned() };
        available::<()>(Err(refused), &["tool"]);
    }
}
