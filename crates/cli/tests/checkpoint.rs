//! Checkpoints of the real binary: killed at any moment and started again, it prints the bytes of an uninterrupted run.
#![cfg(unix)]
#![allow(clippy::unwrap_used, reason = "a test may stop where it fails")]

mod common;

use common::{command, refused, run, stdout};
use std::fs;
use std::path::Path;
use std::process::{Child, Command, Output, Stdio};
use std::time::{Duration, Instant};

/// Kills of one trace.
const KILLS: u64 = 12;

/// The trace that is killed, two seconds of work: by the reference tracer, so that a faster one changes nothing here.
const LONG: [&str; 11] = [
    "trace",
    "--phase",
    "hg:0.85",
    "--tau",
    "3,16",
    "--mu0",
    "1,0.2",
    "--photons",
    "400000",
    "--estimator",
    "plain",
];
/// One that ends within days.
const ENDLESS: [&str; 9] = ["trace", "--phase", "rayleigh", "--tau", "9", "--mu0", "1", "--photons", "1e12"];
const KEEP: [&str; 4] = ["--checkpoint", "run.ckpt", "--checkpoint-every", "0.01"];

fn start(dir: &Path, args: &[&str]) -> Child {
    command(dir, args).stdout(Stdio::null()).stderr(Stdio::null()).spawn().unwrap()
}

fn signal(child: &mut Child, name: &str) -> Option<i32> {
    // The process may have ended by itself.
    let _ = Command::new("kill").args([name, &child.id().to_string()]).stderr(Stdio::null()).status();
    child.wait().unwrap().code()
}

fn wait_for(path: &Path) {
    let start = Instant::now();
    while !path.exists() {
        assert!(start.elapsed() < Duration::from_secs(60), "{} does not appear", path.display());
        std::thread::sleep(Duration::from_millis(5));
    }
}

/// A number below `range` from SplitMix64, the same in every run.
fn random(index: u64, range: u64) -> u64 {
    let mut word = index.wrapping_add(1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    word = (word ^ (word >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    word = (word ^ (word >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    (word ^ (word >> 31)) % range
}

/// Photons that the checkpoint of an unfinished run has at the first incidence.
fn photons_held(dir: &Path) -> Option<u64> {
    let output = run(dir, &["merge", "run.ckpt"]);
    let error = String::from_utf8(output.stderr).unwrap();
    let (_, rest) = error.split_once("is not finished: it has ")?;
    rest.split_once(' ')?.0.parse().ok()
}

fn says(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

#[test]
fn killed_at_random_moments_it_still_prints_the_same_bytes() {
    let dir = tempfile::tempdir().unwrap();
    let whole = stdout(dir.path(), &LONG);
    let args = [&LONG[..], &KEEP].concat();
    let mut killed = 0;
    for attempt in 0..KILLS {
        let mut child = start(dir.path(), &args);
        std::thread::sleep(Duration::from_millis(5 + random(attempt, 90)));
        killed += u64::from(signal(&mut child, "-KILL").is_none());
    }
    assert!(killed >= 10, "the trace is too short to be killed: {killed} of {KILLS} times");
    let last = run(dir.path(), &args);
    assert!(says(&last).contains("run.ckpt: goes on after "), "nothing was kept: {}", says(&last));
    assert_eq!(String::from_utf8(last.stdout).unwrap(), whole);
    // The finished checkpoint stays, alone: it prints at once, and is a part of its own.
    assert_eq!(stdout(dir.path(), &args), whole);
    assert_eq!(stdout(dir.path(), &["merge", "run.ckpt"]), whole);
    assert_eq!(fs::read_dir(dir.path()).unwrap().count(), 1);
}

#[test]
fn signals_store_what_is_counted() {
    let dir = tempfile::tempdir().unwrap();
    let args = [&ENDLESS[..], &["--checkpoint", "run.ckpt", "--checkpoint-every", "1000"]].concat();
    let mut before = 0;
    for name in ["-TERM", "-INT"] {
        let mut child = start(dir.path(), &args);
        wait_for(&dir.path().join("run.ckpt.lock"));
        wait_for(&dir.path().join("run.ckpt"));
        std::thread::sleep(Duration::from_millis(300));
        assert_eq!(signal(&mut child, name), Some(130), "{name}");
        let held = photons_held(dir.path()).unwrap();
        assert!(held > before, "{name}: {held} photons after {before}");
        before = held;
    }
}

/// A target error: the length of each round depends on the photons before it.
#[test]
fn a_trace_with_a_target_error_goes_on_too() {
    let dir = tempfile::tempdir().unwrap();
    let trace = ["trace", "--phase", "hg:0.85", "--tau", "16", "--mu0", "1", "--photons", "1e8"];
    let trace = [&trace[..], &["--std-error", "6e-4"]].concat();
    let whole = stdout(dir.path(), &trace);
    let args = [&trace[..], &KEEP].concat();
    for attempt in 0..4 {
        let mut child = start(dir.path(), &args);
        std::thread::sleep(Duration::from_millis(20 + random(attempt, 60)));
        signal(&mut child, "-KILL");
    }
    assert_eq!(stdout(dir.path(), &args), whole);
    assert_eq!(stdout(dir.path(), &["merge", "run.ckpt"]), whole);
}

#[test]
fn damaged_and_foreign_checkpoints_are_refused_and_left_alone() {
    let dir = tempfile::tempdir().unwrap();
    let trace = ["trace", "--phase", "hg:0.5", "--tau", "2", "--mu0", "1", "--photons"];
    let with = |photons: &str, more: &[&str]| {
        run(dir.path(), &[&trace[..], &[photons, "--checkpoint", "run.ckpt"], more].concat())
    };
    assert!(with("1000", &[]).status.success());
    let path = dir.path().join("run.ckpt");
    let good = fs::read(&path).unwrap();
    let body = good.iter().position(|byte| *byte == b'\n').unwrap() + 1;
    let flipped = |at: usize| {
        let mut bytes = good.clone();
        bytes[at] ^= 1;
        bytes
    };
    let damaged: [(Vec<u8>, &str); 10] = [
        (vec![], "it is no part of a trace"),
        (good[..body / 2].to_vec(), "it is no part of a trace"),
        (good[..body].to_vec(), "it is cut short"),
        (good[..good.len() - 1].to_vec(), "it is cut short"),
        ([&good[..], b"\n"].concat(), "it is damaged"),
        (flipped(0), "it is no part of a trace"),
        (flipped(body - 4), "it is "),
        (flipped(body), "it is damaged: its checksum"),
        (flipped((body + good.len()) / 2), "it is damaged: its checksum"),
        (flipped(good.len() - 1), "it is damaged: its checksum"),
    ];
    for (bytes, message) in damaged {
        fs::write(&path, &bytes).unwrap();
        refused(message, &with("1000", &[]), &["run.ckpt", message]);
        assert_eq!(fs::read(&path).unwrap(), bytes, "the checkpoint was overwritten");
    }
    fs::write(&path, &good).unwrap();
    let foreign: [(Output, &str); 5] = [
        (with("1000", &["--seed", "2"]), "its seed is 1, not 2"),
        (with("1001", &[]), "its photons is 1000, not 1001"),
        (with("1000", &["--omega", "0.9"]), "its medium.single_scattering_albedo is 1.0, not 0.9"),
        (with("1000", &["--shard", "1/2", "--out", "x"]), "it is of shard 1/1, not 1/2"),
        (with("1000", &["--std-error", "1e-3"]), "its std_error is null, not 0.001"),
    ];
    for (output, message) in foreign {
        refused(message, &output, &["run.ckpt", message]);
    }
    assert_eq!(fs::read(&path).unwrap(), good, "the checkpoint was overwritten");
    assert_eq!(fs::read_dir(dir.path()).unwrap().count(), 1);
}

/// The same name for a phase function that has changed meanwhile.
#[test]
fn a_changed_table_is_another_medium() {
    let dir = tempfile::tempdir().unwrap();
    let table = |middle: &str| {
        let text = format!("theta_deg,p\n0,1\n45,{middle}\n90,1\n135,{middle}\n180,1\n");
        fs::write(dir.path().join("p.csv"), text).unwrap();
    };
    let args = ["trace", "--phase", "table:p.csv", "--tau", "1", "--mu0", "1", "--photons", "100"];
    let args = [&args[..], &["--renormalise", "--checkpoint", "run.ckpt"]].concat();
    table("1");
    stdout(dir.path(), &args);
    table("1.000001");
    let output = run(dir.path(), &args);
    refused("table", &output, &["run.ckpt: it belongs to another trace: its medium"]);
}

#[test]
fn two_processes_do_not_share_a_checkpoint() {
    let dir = tempfile::tempdir().unwrap();
    let args = [&ENDLESS[..], &KEEP].concat();
    let mut first = start(dir.path(), &args);
    wait_for(&dir.path().join("run.ckpt"));
    refused("a second process", &run(dir.path(), &args), &["run.ckpt: another process uses this checkpoint"]);
    assert_eq!(signal(&mut first, "-KILL"), None);
    let mut next = start(dir.path(), &args);
    std::thread::sleep(Duration::from_millis(300));
    assert_eq!(signal(&mut next, "-TERM"), Some(130), "the lock of a dead process holds");
}
