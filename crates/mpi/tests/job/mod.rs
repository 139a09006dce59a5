//! Real jobs under `mpirun`, beside the same trace in this process.

#![allow(dead_code, reason = "each test program uses its part")]

use clap::Parser;
use std::path::Path;
use std::process::{Child, Command, Output, Stdio};
use stratiform_cli::Cli;

/// `stratiform-mpi` on `ranks` ranks, with the words of `args`, in `dir`.
pub fn command(dir: &Path, ranks: usize, args: &str) -> Command {
    let mut command = mpirun(dir);
    command.args(["-n", &ranks.to_string(), env!("CARGO_BIN_EXE_stratiform-mpi")]).args(args.split(' '));
    command
}

/// `mpirun` that starts any number of ranks on this machine, whoever runs the test. A job that hangs is ended, and fails.
pub fn mpirun(dir: &Path) -> Command {
    let mut command = Command::new("mpirun");
    command.current_dir(dir).args(["--oversubscribe", "--bind-to", "none", "--mca", "btl", "self,vader"]);
    command.args(["--timeout", "120"]);
    command.env("OMPI_ALLOW_RUN_AS_ROOT", "1").env("OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "1");
    command.stdin(Stdio::null());
    command
}

/// Runs a job to its end.
pub fn run(dir: &Path, ranks: usize, args: &str) -> Output {
    command(dir, ranks, args).output().unwrap()
}

/// stdout of a job that must succeed.
pub fn stdout(dir: &Path, ranks: usize, args: &str) -> String {
    let output = run(dir, ranks, args);
    assert!(output.status.success(), "{ranks} ranks, {args}: {}", talk(&output));
    String::from_utf8(output.stdout).unwrap()
}

/// A job in the background.
pub fn start(dir: &Path, ranks: usize, args: &str) -> Child {
    command(dir, ranks, args).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap()
}

/// stderr.
pub fn talk(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

/// What one process prints: `stratiform` with the same words.
pub fn alone(args: &str) -> String {
    stratiform_cli::run(&Cli::parse_from(["stratiform"].into_iter().chain(args.split(' ')))).unwrap()
}

/// The job ended with `code`, printed nothing, and one of its errors says all of `says`.
pub fn refused(output: &Output, code: i32, says: &[&str]) {
    let talk = talk(output);
    assert_eq!(output.status.code(), Some(code), "{talk}");
    assert!(output.stdout.is_empty(), "{talk}");
    let errors: Vec<&str> = talk.lines().filter(|line| line.starts_with("error: ")).collect();
    assert_eq!(errors.len(), 1, "{talk}");
    assert!(says.iter().all(|word| errors[0].contains(word)), "{}", errors[0]);
}
