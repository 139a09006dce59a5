//! Running the real binary.

#![allow(dead_code, reason = "each test program uses its part")]
#![allow(clippy::unwrap_used, reason = "a test may stop where it fails")]

use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::time::{Duration, Instant};

/// The repository's root.
pub fn root() -> PathBuf {
    PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/../.."))
}

/// The command with `args`, run in `dir`.
pub fn command(dir: &Path, args: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_stratiform"));
    command.current_dir(dir).args(args).env("STRATIFORM_CACHE", dir.join("cache"));
    command
}

/// Runs it to the end.
pub fn run(dir: &Path, args: &[&str]) -> Output {
    command(dir, args).output().unwrap()
}

/// stdout of a run that must succeed.
pub fn stdout(dir: &Path, args: &[&str]) -> String {
    let output = run(dir, args);
    let error = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(output.status.success(), "{args:?}: {error}");
    String::from_utf8(output.stdout).unwrap()
}

/// The paper's config with `(from, to)` replaced in its text; each must occur.
pub fn config(replacements: &[(&str, &str)]) -> String {
    let text = std::fs::read_to_string(root().join("fit-configs/appendix-b.toml")).unwrap();
    replacements.iter().fold(text, |text, (from, to)| {
        assert!(text.contains(from), "`{from}` is not in the config");
        text.replacen(from, to, 1)
    })
}

/// Checks that `output` refuses with a message holding every part of `says`.
pub fn refused(what: &str, output: &Output, says: &[&str]) {
    let error = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{what}: {error}");
    assert!(output.stdout.is_empty(), "{what}: stdout is not empty");
    for part in says {
        assert!(error.contains(part), "{what}: `{part}` is not in: {error}");
    }
    assert!(!error.contains("panicked"), "{what}: {error}");
}

/// Waits for a file that another process writes.
pub fn wait_for(path: &Path) {
    let start = Instant::now();
    while !path.exists() {
        assert!(start.elapsed() < Duration::from_secs(60), "{} does not appear", path.display());
        std::thread::sleep(Duration::from_millis(5));
    }
}

/// A shell script `name` in `dir` that stands in for a program.
#[cfg(unix)]
pub fn program(dir: &Path, name: &str, body: &str) {
    use std::os::unix::fs::PermissionsExt as _;
    let path = dir.join(name);
    std::fs::write(&path, format!("#!/bin/sh\n{body}\n")).unwrap();
    std::fs::set_permissions(&path, std::fs::Permissions::from_mode(0o755)).unwrap();
}
