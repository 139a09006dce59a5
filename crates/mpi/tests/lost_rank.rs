//! A rank is killed for real: the job ends without output, and the same command goes on.
#![cfg(target_os = "linux")]
#![allow(clippy::unwrap_used, reason = "a test may stop where it fails")]

mod job;

use job::{alone, start, stdout, talk};
use std::fs;
use std::path::Path;
use std::process::{Child, Command};
use std::time::{Duration, Instant};
use stratiform_cli::trace::RunParts;
use tempfile::tempdir;

/// Ten seconds of one processor, many times what passes before three checkpoints: there is a middle in which to kill.
const TRACE: &str = "trace --phase hg:0.85 --tau 1,40 --mu0 0.7 --photons 3000000 --estimator plain --json";
const PHOTONS: u64 = 3_000_000;
const RANKS: usize = 3;

/// The processes that `parent` started.
fn children(parent: u32) -> Vec<String> {
    let list = fs::read_to_string(format!("/proc/{parent}/task/{parent}/children")).unwrap_or_default();
    list.split_whitespace().map(str::to_owned).collect()
}

fn signal(name: &str, process: &str) {
    assert!(Command::new("kill").args([name, process]).status().unwrap().success());
}

/// Waits until `reached`, while the job runs.
fn wait_until(job: &mut Child, what: &str, reached: impl Fn() -> bool) {
    let start = Instant::now();
    while !reached() {
        assert!(job.try_wait().unwrap().is_none(), "the job ended before {what}");
        assert!(start.elapsed() < Duration::from_secs(60), "{what} does not happen");
        std::thread::sleep(Duration::from_millis(5));
    }
}

/// Photons in the checkpoints of all ranks.
fn photons(dir: &Path) -> u64 {
    let file = |rank| dir.join(format!("run.ckpt.rank-{rank}-of-{RANKS}"));
    (1..=RANKS).map(|rank| RunParts::read(&file(rank)).map_or(0, |parts| parts.photons())).sum()
}

/// Starts the job, ends `rank` by `name` when more is stored than before, and sees the job end without output.
fn lose(dir: &Path, kept: &str, rank: usize, name: &str) {
    let before = photons(dir);
    let mut job = start(dir, RANKS, kept);
    wait_until(&mut job, "a checkpoint", || photons(dir) > before);
    let processes = children(job.id());
    assert_eq!(processes.len(), RANKS, "the ranks are mpirun's children");
    signal(name, &processes[rank - 1]);
    let output = job.wait_with_output().unwrap();
    assert!(!output.status.success());
    assert!(output.stdout.is_empty(), "{}", talk(&output));
}

#[test]
fn a_job_that_lost_ranks_goes_on_to_the_same_bytes() {
    let dir = tempdir().unwrap();
    let kept = format!("{TRACE} --checkpoint run.ckpt --checkpoint-every 0.02");
    for (rank, name) in [(2, "-KILL"), (1, "-KILL"), (3, "-TERM")] {
        lose(dir.path(), &kept, rank, name);
    }
    let done = photons(dir.path());
    assert!((1..PHOTONS).contains(&done), "{done} photons were kept of a job in its middle");
    assert_eq!(stdout(dir.path(), RANKS, &kept), alone(TRACE));
}

/// Without checkpoints a lost rank costs the work, and still nothing is printed.
#[test]
fn a_job_without_checkpoints_ends_too() {
    let dir = tempdir().unwrap();
    let mut job = start(dir.path(), RANKS, &TRACE.replace("3000000", "1e9"));
    let id = job.id();
    wait_until(&mut job, "the ranks", || children(id).len() == RANKS);
    std::thread::sleep(Duration::from_millis(500));
    signal("-KILL", &children(id)[1]);
    let output = job.wait_with_output().unwrap();
    assert!(!output.status.success() && output.stdout.is_empty(), "{}", talk(&output));
    assert_eq!(fs::read_dir(dir.path()).unwrap().count(), 0);
}
