//! Any number of ranks prints the bytes of one process, or one message says why not.

#![allow(clippy::unwrap_used, reason = "a test may stop where it fails")]

mod job;

use job::{alone, mpirun, refused, run, stdout, talk};
use std::fs;
use tempfile::tempdir;

const TRACE: &str = "trace --phase hg:0.85 --tau 1,16 --mu0 1,diffuse --photons 30001";

#[test]
fn one_to_four_ranks_print_the_bytes_of_one_process() {
    let dir = tempdir().unwrap();
    let whole = alone(TRACE);
    for ranks in 1..=4 {
        assert_eq!(stdout(dir.path(), ranks, TRACE), whole, "{ranks} ranks");
    }
    let json = format!("{TRACE} --json");
    assert_eq!(stdout(dir.path(), 3, &format!("{json} --threads 2")), alone(&json));
    let other = format!("{TRACE} --seed 2");
    assert_ne!(stdout(dir.path(), 3, &other), whole, "the comparison sees another seed");
    assert_eq!(fs::read_dir(dir.path()).unwrap().count(), 0);
}

#[test]
fn more_ranks_than_photons_and_the_plain_tracer_are_fine() {
    let dir = tempdir().unwrap();
    let few = "trace --phase rayleigh --tau 2 --mu0 0.3 --photons 3 --estimator plain";
    assert_eq!(stdout(dir.path(), 5, few), alone(few));
}

#[test]
fn one_rank_takes_a_target_error() {
    let dir = tempdir().unwrap();
    let target = "trace --phase isotropic --tau 1 --mu0 1 --photons 1e6 --std-error 2e-3";
    assert_eq!(stdout(dir.path(), 1, target), alone(target));
    refused(&run(dir.path(), 2, target), 2, &["rank 1 of 2", "--std-error is for one rank, not 2"]);
    let unmet = run(dir.path(), 1, &target.replace("1e6", "1e3"));
    assert_eq!(unmet.status.code(), Some(1), "{}", talk(&unmet));
    assert!(unmet.stdout.starts_with(b"tau,mu0"), "what was reached is printed");
}

#[test]
fn bad_input_is_said_once_and_ends_all_ranks() {
    let dir = tempdir().unwrap();
    let cases = [
        ("trace --phase hg:0.85 --tau -1 --mu0 1 --photons 100", "-1"),
        ("trace --phase hg:2 --tau 1 --mu0 1 --photons 100", "2"),
        ("trace --phase isotropic --tau 1 --mu0 1 --photons 100 --threads 0", "threads = 0"),
        (
            "trace --phase isotropic --tau 1 --mu0 1 --photons 100 --shard 1/2 --out x",
            "--shard is for single",
        ),
        ("trace --phase isotropic --tau 1 --mu0 1 --photons 9 --view-mu 1", "--view-mu is for one process"),
        ("solve --phase isotropic --tau 1 --mu0 1", "solve"),
    ];
    for (args, says) in cases {
        refused(&run(dir.path(), 3, args), 2, &[says]);
    }
    assert_eq!(fs::read_dir(dir.path()).unwrap().count(), 0);
    let version = run(dir.path(), 3, "--version");
    assert_eq!((version.status.code(), talk(&version)), (Some(0), String::new()));
    assert_eq!(String::from_utf8(version.stdout).unwrap().lines().count(), 1);
}

/// Only one rank knows; the others are told.
#[test]
fn the_error_of_one_rank_ends_all() {
    let dir = tempdir().unwrap();
    let kept = format!("{TRACE} --checkpoint run.ckpt");
    let whole = stdout(dir.path(), 3, &kept);
    let file = dir.path().join("run.ckpt.rank-2-of-3");
    let sound = fs::read(&file).unwrap();
    fs::write(&file, &sound[..sound.len() - 1]).unwrap();
    refused(&run(dir.path(), 3, &kept), 2, &["rank 2 of 3", "run.ckpt.rank-2-of-3", "cut short"]);
    refused(&run(dir.path(), 2, &kept), 2, &["rank 1 of 2", "is of 3 ranks, not 2"]);
    fs::write(&file, &sound).unwrap();
    refused(&run(dir.path(), 3, &format!("{kept} --seed 5")), 2, &["another trace", "its seed is 1, not 5"]);
    assert_eq!(stdout(dir.path(), 3, &kept), whole);
}

/// Ranks that were started for different things find out before they trace.
#[test]
fn ranks_of_different_traces_are_refused() {
    let dir = tempdir().unwrap();
    let mut job = mpirun(dir.path());
    for (index, seed) in [1, 2].into_iter().enumerate() {
        job.args([":"; 1].iter().take(index)).args(["-n", "1", env!("CARGO_BIN_EXE_stratiform-mpi")]);
        job.args(TRACE.split(' ')).args(["--seed", &seed.to_string()]);
    }
    let says = ["rank 2 of 2", "it belongs to another trace", "its seed is 2, not 1"];
    refused(&job.output().unwrap(), 2, &says);
}

/// Open MPI takes 0 for as many ranks as there are cores; other kinds of MPI refuse it.
#[test]
fn no_rank_at_all_is_refused_or_replaced() {
    let dir = tempdir().unwrap();
    let output = run(dir.path(), 0, TRACE);
    let (printed, whole) = (String::from_utf8(output.stdout).unwrap(), alone(TRACE));
    assert!(if output.status.success() { printed == whole } else { printed.is_empty() });
}
