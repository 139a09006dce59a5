//! `phase-check` as other people's scripts call it.

#![allow(clippy::unwrap_used, reason = "a test may stop where it fails")]

mod common;

use common::{root, run, stdout};
use serde_json::Value;
use std::f64::consts::PI;
use std::fmt::Write;
use std::fs;
use std::path::Path;

const DROPLETS: [&str; 6] = ["--r-eff", "7", "--gamma", "2", "--wavelength", "0.55"];

fn with<'a>(head: &[&'a str], tail: &[&'a str]) -> Vec<&'a str> {
    [&["phase-check"], head, tail].concat()
}

/// The cloud's own table, and what `change` makes of its rows.
fn write_table(dir: &Path, name: &str, change: impl Fn(&[(f64, f64)]) -> Vec<(f64, f64)>) {
    let out = dir.join("optics");
    if !out.exists() {
        let args = ["optics", "--r-eff", "7", "--gamma", "2", "--n0", "300", "--wavelength", "0.55"];
        stdout(dir, &[&args[..], &["--out", out.to_str().unwrap()]].concat());
    }
    let own = fs::read_to_string(out.join("phase_0.55um.csv")).unwrap();
    let number = |field: &str| field.parse::<f64>().unwrap();
    let pair = |line: &str| line.split_once(',').map(|(theta, p)| (number(theta), number(p))).unwrap();
    let rows: Vec<(f64, f64)> = own.lines().skip(1).map(pair).collect();
    let text = change(&rows).iter().fold(String::from("theta_deg,p\n"), |mut text, (theta, p)| {
        let _ = writeln!(text, "{theta},{p}");
        text
    });
    fs::write(dir.join(name), text).unwrap();
}

/// Linear between rows.
fn every_degree(rows: &[(f64, f64)]) -> Vec<(f64, f64)> {
    let at = |theta: f64| {
        let right = rows.partition_point(|row| row.0 <= theta).clamp(1, rows.len() - 1);
        let [(a, p), (b, q)] = [rows[right - 1], rows[right]];
        p + (q - p) * (theta - a) / (b - a)
    };
    (0..=180).map(|degrees| (f64::from(degrees), at(f64::from(degrees)))).collect()
}

#[test]
fn a_right_table_passes_and_wrong_ones_are_named() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path();
    write_table(path, "own.csv", <[_]>::to_vec);
    write_table(path, "coarse.csv", every_degree);
    write_table(path, "flipped.csv", |rows| rows.iter().rev().map(|(t, p)| (180.0 - t, *p)).collect());

    let document: Value =
        serde_json::from_str(&stdout(path, &with(&["own.csv", "--json"], &DROPLETS))).unwrap();
    assert_eq!(
        (&document["schema"], &document["passes"]),
        (&"stratiform/phase-check/1".into(), &true.into())
    );
    assert!((document["mie"]["forward_fraction"].as_f64().unwrap() - 0.455).abs() < 6e-4);
    assert_eq!(document["checks"].as_array().unwrap().len(), 12);

    let coarse = run(path, &with(&["coarse.csv"], &DROPLETS));
    assert_eq!(coarse.status.code(), Some(1));
    let text = String::from_utf8(coarse.stdout).unwrap();
    assert!(text.contains("too coarse: raw integral 1.094"), "{text}");
    assert!(text.contains("P_f 0.501 and 0.476 where Mie says 0.455"), "{text}");
    assert!(String::from_utf8(coarse.stderr).unwrap().contains("coarse.csv: sampling"));

    let flipped = run(path, &with(&["flipped.csv", "--json"], &[]));
    assert_eq!(flipped.status.code(), Some(1));
    let document: Value = serde_json::from_slice(&flipped.stdout).unwrap();
    assert_eq!(document["faults"], serde_json::json!(["angle-sign"]));
    assert!(document.get("mie").is_none(), "no droplets were given");

    let repaired = run(path, &with(&["flipped.csv", "--repaired", "right.csv"], &[]));
    assert_eq!(repaired.status.code(), Some(1), "the file itself is still wrong");
    stdout(path, &with(&["right.csv"], &DROPLETS));
    write_table(path, "density.csv", |rows| rows.iter().map(|(t, p)| (*t, 0.25 * p / PI)).collect());
    assert_eq!(run(path, &with(&["density.csv"], &[])).status.code(), Some(1));
    stdout(path, &with(&["density.csv", "--normalisation", "per-steradian"], &DROPLETS));
    let own = fs::read_to_string(path.join("own.csv")).unwrap();
    let over = run(path, &with(&["own.csv", "--repaired", "./own.csv"], &[]));
    assert_eq!((over.status.code(), over.stdout.len()), (Some(2), 0));
    assert_eq!(fs::read_to_string(path.join("own.csv")).unwrap(), own);
}

#[test]
fn constants_come_from_files_or_the_command_line() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path();
    fs::write(path.join("paper.toml"), "P_f = 0.51\nkappa = 0.04618\n").unwrap();
    let paper = run(path, &with(&["paper.toml", "--n0", "300"], &DROPLETS));
    assert_eq!(paper.status.code(), Some(1));
    let text = String::from_utf8(paper.stdout).unwrap();
    assert!(text.contains("P_f 0.510 where Mie says 0.455") && text.contains("gives 0.501"), "{text}");
    assert!(text.contains("as N0 pi r_e^2"), "{text}");

    assert!(stdout(path, &["phase-check", "--hg", "0.85"]).contains("sampling"));
    let hg = run(path, &with(&["--hg", "0.85"], &DROPLETS));
    assert!(String::from_utf8(hg.stderr).unwrap().contains("forward-peak, forward-fraction"));
    stdout(path, &["phase-check", "--two-lobe", "0.3,0.9,-0.4"]);
    stdout(path, &["phase-check", "--draine", "0.48,0.98,0.57,10.2"]);
    fs::write(path.join("blend.json"), r#"{"blend": {"w": 0.3, "g1": 0.9, "g2": -0.4, "alpha": 0.0}}"#)
        .unwrap();
    stdout(path, &["phase-check", "blend.json"]);
}

/// Exit code 2, one message that names the place, nothing on stdout.
#[test]
fn bad_input_is_refused() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path();
    let config = root().join("fit-configs/appendix-b.toml");
    for (name, text) in [
        ("nan.csv", "theta,p\n0,1\n90,nan\n180,1\n"),
        ("empty.csv", ""),
        ("short.csv", "0,1\n"),
        ("none.toml", ""),
        ("typo.toml", "asymmetry = 0.8\ng_hg = 1\n"),
        ("far.toml", "\nblend = { w = 2.0, g1 = 0.5, g2 = 0.5, alpha = 0.0 }\n"),
        ("alone.toml", "P_f = 0.5\n"),
        ("kappa.toml", "kappa = 0.05\n"),
    ] {
        fs::write(path.join(name), text).unwrap();
    }
    let cases: [(&[&str], &str); 15] = [
        (&["nan.csv"], "nan.csv:3: the value NaN is outside [0, infinity)"),
        (&["empty.csv"], "empty.csv: the file is empty"),
        (&["short.csv"], "short.csv: 1 rows of numbers are no phase table"),
        (&["missing.csv"], "cannot read missing.csv"),
        (&["none.toml"], "none.toml: the file is empty"),
        (&["typo.toml"], "typo.toml:2: unknown field `g_hg`"),
        (&["far.toml"], "far.toml: w = 2 is outside [0, 1]"),
        (&["alone.toml"], "alone.toml: constants can be held against Mie only"),
        (&["kappa.toml", "--r-eff", "7", "--gamma", "2", "--wavelength", "0.55"], "needs --n0"),
        (&["--hg", "1.5"], "--hg 1.5: g = 1.5 is outside (-1, 1)"),
        (&["--hg", "0.9999"], "--hg 0.9999: phase function: too sharp to be looked at in 4096 angles"),
        (&["--two-lobe", "0.5,0.5"], "--two-lobe: 3 numbers are needed"),
        (&["--hg", "0.5", "--wavelength", "0.55"], "--wavelength needs --config or --r-eff and --gamma"),
        (&["--hg", "0.5", "--theta-f", "0"], "theta_f_deg = 0 is outside (0, 180)"),
        (
            &["--hg", "0.5", "--config", config.to_str().unwrap(), "--wavelength", "0"],
            "wavelengths_um = 0 is outside",
        ),
    ];
    for (args, expected) in cases {
        let output = run(path, &with(args, &[]));
        let error = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(2), "{args:?}: {error}");
        assert!(error.contains(expected), "{args:?}: {error}");
        assert!(output.stdout.is_empty(), "{args:?}");
    }
    assert_eq!(run(path, &["phase-check"]).status.code(), Some(2), "nothing to look at");
}
