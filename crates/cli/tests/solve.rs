//! `stratiform solve` as other people's scripts call it.

#![allow(clippy::unwrap_used, reason = "a test may stop where it fails")]

mod common;

use common::{run, stdout};
use serde_json::Value;

fn json(dir: &std::path::Path, args: &[&str]) -> Value {
    serde_json::from_str(&stdout(dir, &[args, &["--json"]].concat())).unwrap()
}

#[test]
fn the_schema_is_that_of_trace() {
    let dir = tempfile::tempdir().unwrap();
    let medium = ["--phase", "hg:0.75", "--tau", "8,0", "--mu0", "1,0,diffuse"];
    let solved = json(dir.path(), &[&["solve"], &medium[..]].concat());
    let traced = json(dir.path(), &[&["trace"], &medium[..], &["--photons", "1e3"]].concat());
    let places = |document: &Value| -> Vec<(Value, Value, Value)> {
        let rows = document["results"].as_array().unwrap().iter();
        rows.map(|row| (row["tau"].clone(), row["mu0"].clone(), row["order"].clone())).collect()
    };
    assert_eq!(places(&solved), places(&traced));
    assert_eq!(solved["schema"], traced["schema"]);
    assert_eq!(solved["medium"], traced["medium"]);
    assert!(solved["provenance"].get("seed").is_none());
    assert!(
        solved["provenance"]["method"]
            .as_str()
            .unwrap()
            .contains("std_error is the estimated absolute error")
    );
    // DISORT problem 3b: 1.59096/π, 5 digits.
    let total = &solved["results"][4];
    assert_eq!(total["order"], "total");
    assert!((total["reflectance"]["value"].as_f64().unwrap() - 0.506_42).abs() < 1e-5);
    assert!(total["reflectance"]["std_error"].as_f64().unwrap() <= 1e-6);
}

#[test]
fn csv_orders_and_threads() {
    let dir = tempfile::tempdir().unwrap();
    let args = [
        "solve",
        "--phase",
        "isotropic",
        "--omega",
        "0.9",
        "--modified",
        "10",
        "--tau",
        "1,2",
        "--mu0",
        "0.5",
    ];
    let csv = stdout(dir.path(), &[&args[..], &["--orders", "5", "--threads", "1"]].concat());
    let header =
        "tau,mu0,medium,order,reflectance,reflectance_std_error,transmittance,transmittance_std_error";
    assert_eq!(csv.lines().next(), Some(header));
    assert_eq!(csv.lines().count(), 1 + 2 * 8);
    assert_eq!(csv, stdout(dir.path(), &[&args[..], &["--orders", "5", "--threads", "2"]].concat()));
}

#[test]
fn a_tolerance_that_is_not_met_is_exit_1_and_says_what_was_reached() {
    let dir = tempfile::tempdir().unwrap();
    let args = ["solve", "--phase", "isotropic", "--tau", "1e-4", "--mu0", "0", "--tolerance", "1e-12"];
    let output = run(dir.path(), &args);
    assert_eq!(output.status.code(), Some(1));
    assert!(output.stdout.is_empty());
    let message = String::from_utf8(output.stderr).unwrap();
    assert!(message.contains("1e-12") && message.contains("reach"), "{message}");
}

#[test]
fn bad_input_is_exit_2() {
    let dir = tempfile::tempdir().unwrap();
    for (flag, value, named) in [
        ("--tau", "-1", "tau = -1"),
        ("--mu0", "1.5", "1.5"),
        ("--tolerance", "0", "tolerance = 0"),
        ("--tolerance", "nan", "nan"),
        ("--orders", "61", "orders = 61"),
        ("--omega", "2", "omega = 2"),
    ] {
        let mut args = vec!["solve", "--phase", "isotropic", "--tau", "1", "--mu0", "1"];
        match args.iter().position(|arg| *arg == flag) {
            Some(place) => args[place + 1] = value,
            None => args.extend([flag, value]),
        }
        let output = run(dir.path(), &args);
        let message = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(2), "{flag} {value}: {message}");
        assert!(output.stdout.is_empty() && message.contains(named), "{flag} {value}: {message}");
    }
}
