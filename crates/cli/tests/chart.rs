//! `stratiform chart` from the outside.

#![allow(clippy::unwrap_used, reason = "a test may stop where it fails")]

use std::path::Path;
use std::process::{Command, Output};

fn stratiform(args: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_stratiform")).args(args).env("STRATIFORM_CACHE", "").output().unwrap()
}

/// A named scene made small enough for Mie theory without a cache.
fn scene(dir: &Path) -> String {
    let text = include_str!("../../../fit-configs/scenes/thin-veil.toml")
        .replace("wavelengths_um = [0.65, 0.55, 0.45]", "wavelengths_um = [0.55]")
        .replace("{ min = 4.0, max = 20.0 }", "{ min = 0.3, max = 0.3 }");
    let path = dir.join("small.toml");
    std::fs::write(&path, text).unwrap();
    path.display().to_string()
}

/// The table without what depends on the machine.
fn without_times(csv: &[u8]) -> Vec<Vec<String>> {
    let mut reader = csv::Reader::from_reader(csv);
    let headers = reader.headers().unwrap().clone();
    let kept = |name: &str| !["ns_per_evaluation", "pareto"].contains(&name);
    let row = |record: csv::StringRecord| {
        headers.iter().zip(&record).filter(|(name, _)| kept(name)).map(|(_, v)| v.to_owned()).collect()
    };
    reader.records().map(|record| row(record.unwrap())).collect()
}

#[test]
fn a_quick_chart_is_whole_and_only_its_times_differ() {
    let dir = tempfile::tempdir().unwrap();
    let (scene, out) = (scene(dir.path()), dir.path().join("out"));
    let run = |threads: &str| {
        let out = out.to_str().unwrap();
        let words = ["--scene", &scene, "--methods", "single-hg,two-stream", "--quick", "--out", out];
        let done = stratiform(&[&["chart", "--threads", threads][..], &words].concat());
        assert!(done.status.success(), "{}", String::from_utf8_lossy(&done.stderr));
        (without_times(&done.stdout), std::fs::read(Path::new(out).join("manifest.json")).unwrap())
    };
    let (rows, manifest) = run("1");
    assert_eq!(run("2"), (rows.clone(), manifest));
    assert_eq!(rows.len(), 6, "{rows:?}");
    for file in ["chart.csv", "manifest.json", "chart-small.svg", "chart.html"] {
        assert!(out.join(file).is_file(), "{file}");
    }
}

#[test]
fn unknown_names_and_bad_scenes_are_refused_before_anything_is_written() {
    let dir = tempfile::tempdir().unwrap();
    let bad = scene(dir.path());
    let text =
        std::fs::read_to_string(&bad).unwrap().replace("min = 10.0, max = 70.0", "min = 70.0, max = 10.0");
    std::fs::write(&bad, text).unwrap();
    let out = dir.path().join("out");
    let cases = [
        (["--scene", "no-such"], "the scenes are thin-veil, stratocumulus-above"),
        (["--scene", "glory-view,glory-view"], "named twice"),
        (["--methods", "no-such"], "the methods are single-mie"),
        (["--methods", "octaves:x"], "octaves:x"),
        (["--scene", bad.as_str()], "small.toml:18: sun.theta_deg = { min = 70, max = 10 } is inverted"),
    ];
    for (words, message) in cases {
        let done = stratiform(&["chart", words[0], words[1], "--quick", "--out", out.to_str().unwrap()]);
        let said = String::from_utf8_lossy(&done.stderr).into_owned();
        assert_eq!(done.status.code(), Some(2), "{said}");
        assert!(said.contains(message) && done.stdout.is_empty() && !out.exists(), "{said}");
    }
}
