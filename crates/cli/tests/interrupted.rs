//! Signals half-way: what is in the folder afterwards is whole, and the next run goes on from it.
#![cfg(unix)]
#![allow(clippy::unwrap_used, reason = "a test may stop where it fails")]

mod common;

use common::{command, config, stdout};
use std::fs;
use std::path::Path;
use std::process::{Child, Command, ExitStatus, Stdio};
use std::time::{Duration, Instant};

/// A run that would take hours.
fn start(dir: &Path, args: &[&str]) -> Child {
    command(dir, args).stdout(Stdio::null()).stderr(Stdio::null()).spawn().unwrap()
}

fn signal(child: &mut Child, name: &str) -> ExitStatus {
    let sent = Command::new("kill").args([name, &child.id().to_string()]).status().unwrap();
    assert!(sent.success());
    child.wait().unwrap()
}

fn wait_for(path: &Path) {
    let start = Instant::now();
    while !path.exists() {
        assert!(start.elapsed() < Duration::from_secs(60), "{} does not appear", path.display());
        std::thread::sleep(Duration::from_millis(20));
    }
}

/// Every JSON file of the folder parses, and the stage that was interrupted left nothing.
fn whole(out: &Path) {
    for name in ["manifest.json", "optics/optics.json"] {
        let text = fs::read_to_string(out.join(name)).unwrap();
        serde_json::from_str::<serde_json::Value>(&text).unwrap();
    }
    for name in ["reference.json", "orders.csv", "parameters.json", "report.html"] {
        assert!(!out.join(name).exists(), "{name} was written by an interrupted stage");
    }
}

#[test]
fn a_run_that_is_interrupted_or_killed_leaves_whole_files() {
    let dir = tempfile::tempdir().unwrap();
    let long = config(&[
        ("source = \"solve\"", "source = \"trace\""),
        ("photons = 1_000_000", "photons = 1_000_000_000\nphotons_between = 1_000"),
        ("[0.65, 0.55, 0.45]", "[0.55]"),
    ]);
    fs::write(dir.path().join("long.toml"), long).unwrap();
    let out = dir.path().join("out");
    for name in ["-INT", "-TERM", "-KILL"] {
        let mut child = start(dir.path(), &["reproduce", "long.toml", "--out", "out"]);
        wait_for(&out.join("manifest.json"));
        std::thread::sleep(Duration::from_millis(300));
        let status = signal(&mut child, name);
        assert_eq!(status.code(), if name == "-KILL" { None } else { Some(130) }, "{name}");
        whole(&out);
    }
    let text = stdout(dir.path(), &["fit", "long.toml", "--out", "out", "--photons", "2000"]);
    assert!(text.contains("kappa_c"));
}

#[test]
fn a_trace_that_is_interrupted_prints_nothing() {
    let dir = tempfile::tempdir().unwrap();
    let args = ["trace", "--phase", "isotropic", "--tau", "9", "--mu0", "1", "--photons", "1e12"];
    let mut child = start(dir.path(), &args);
    std::thread::sleep(Duration::from_millis(500));
    assert_eq!(signal(&mut child, "-INT").code(), Some(130));
}
