//! `stratiform solve --view-mu` and `stratiform trace --view-mu` as other people's scripts call it.

#![allow(clippy::unwrap_used, reason = "a test may stop where it fails")]

mod common;

use common::{run, stdout};
use serde_json::Value;

const SUN: [&str; 7] = ["solve", "--phase", "isotropic", "--tau", "32", "--mu0", "0.1"];

fn with<'a>(more: &[&'a str]) -> Vec<&'a str> {
    SUN.iter().chain(more).copied().collect()
}

#[test]
fn rows_have_the_schema() {
    let dir = tempfile::tempdir().unwrap();
    let text = stdout(dir.path(), &with(&["--view-mu", "0.5,0.1", "--phi", "0,180", "--json"]));
    let document: Value = serde_json::from_str(&text).unwrap();
    assert_eq!(document["schema"], "stratiform/radiance/1");
    assert_eq!(document["medium"]["medium"], "full");
    let method = document["provenance"]["method"].as_str().unwrap();
    assert!(method.contains("std_error is the estimated absolute error"), "{method}");
    let rows = document["results"].as_array().unwrap();
    assert_eq!(rows.len(), 2 * 2 * 2 * 3);
    let total =
        rows.iter().find(|row| row["mu"] == 0.5 && row["side"] == "top" && row["order"] == "total").unwrap();
    assert_eq!((&total["tau"], &total["mu0"], &total["phi_deg"]), (&32.0.into(), &0.1.into(), &0.0.into()));
    // DISORT problem 1e: 1.02732, 6 digits.
    assert!((total["value"].as_f64().unwrap() - 1.027_32).abs() < 1e-4);
    assert!(total["std_error"].as_f64().unwrap() <= 1e-3);
    assert_eq!(rows[0]["order"], 1);
}

#[test]
fn csv_orders_threads_and_the_modified_medium() {
    let dir = tempfile::tempdir().unwrap();
    let more = ["--omega", "0.9", "--modified", "10", "--view-mu", "0.3", "--phi", "77", "--orders", "0"];
    let csv = stdout(dir.path(), &with(&[&more[..], &["--threads", "1"]].concat()));
    assert_eq!(csv.lines().next(), Some("tau,mu0,mu,phi_deg,side,order,value,std_error"));
    assert_eq!(csv.lines().count(), 3);
    assert_eq!(csv, stdout(dir.path(), &with(&[&more[..], &["--threads", "2"]].concat())));
}

#[test]
fn a_tolerance_that_is_not_met_is_exit_1_and_says_what_was_reached() {
    let dir = tempfile::tempdir().unwrap();
    let args = [
        "solve",
        "--phase",
        "hg:0.99",
        "--tau",
        "5",
        "--mu0",
        "1",
        "--view-mu",
        "0.99",
        "--tolerance",
        "2e-8",
    ];
    let output = run(dir.path(), &args);
    let message = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(1), "{message}");
    assert!(output.stdout.is_empty() && message.contains("2e-8") && message.contains("reach"), "{message}");
}

#[test]
fn bad_input_is_exit_2() {
    let dir = tempfile::tempdir().unwrap();
    for (more, named) in [
        (&["--view-mu", "1.5"][..], "view mu = 1.5"),
        (&["--view-mu", "0.5", "--phi", "1000"], "phi (degrees) = 1000"),
        (&["--view-mu", "0.5", "--orders", "3"], "orders = 3"),
        (&["--view-mu", "0.5", "--tolerance", "2"], "tolerance = 2"),
        (&["--view-mu", "half"], "half"),
        (&["--phi", "90"], "--view-mu"),
    ] {
        let output = run(dir.path(), &with(more));
        let message = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(2), "{more:?}: {message}");
        assert!(output.stdout.is_empty() && message.contains(named), "{more:?}: {message}");
    }
    for (mu0, named) in [("diffuse", "reciprocity"), ("0", "mu0 + view mu = 0")] {
        let args = ["solve", "--phase", "isotropic", "--tau", "1", "--mu0", mu0, "--view-mu", "0"];
        let output = run(dir.path(), &args);
        let message = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(2), "{mu0}: {message}");
        assert!(output.stdout.is_empty() && message.contains(named), "{mu0}: {message}");
    }
}

const PHOTONS: [&str; 9] =
    ["trace", "--phase", "isotropic", "--tau", "2", "--mu0", "0.6", "--photons", "20000"];

fn traced<'a>(more: &[&'a str]) -> Vec<&'a str> {
    PHOTONS.iter().chain(more).copied().collect()
}

/// The document of `solve`, with N orders and the tail. Values within five standard errors of it: seed fixed.
#[test]
fn photons_print_the_document_of_the_solver() {
    let dir = tempfile::tempdir().unwrap();
    let views = ["--view-mu", "0.5,1", "--phi", "90", "--json"];
    let document = |args: &[&str]| -> Value { serde_json::from_str(&stdout(dir.path(), args)).unwrap() };
    let one = document(&traced(&[&views[..], &["--orders", "3"]].concat()));
    assert_eq!(one["schema"], "stratiform/radiance/1");
    assert_eq!(one["provenance"]["seed"], 1);
    let rows = one["results"].as_array().unwrap();
    assert_eq!(rows.len(), 2 * 2 * 5);
    let sun = ["solve", "--phase", "isotropic", "--tau", "2", "--mu0", "0.6"];
    let other = document(&[&sun[..], &views[..]].concat());
    for solved in other["results"].as_array().unwrap() {
        let same =
            |row: &&Value| ["mu", "side", "order", "tau", "mu0"].iter().all(|key| row[key] == solved[key]);
        let row = rows.iter().find(same).unwrap();
        let number = |row: &Value, key: &str| row[key].as_f64().unwrap();
        let error = number(row, "std_error") + number(solved, "std_error");
        assert!((number(row, "value") - number(solved, "value")).abs() < 5.0 * error, "{row} {solved}");
        assert_eq!(row["settled"], true, "{row}");
    }
}

#[test]
fn photons_in_csv_do_not_depend_on_threads() {
    let dir = tempfile::tempdir().unwrap();
    let csv = |threads: &str| {
        stdout(dir.path(), &traced(&["--view-mu", "0.3", "--modified", "10", "--threads", threads]))
    };
    let one = csv("1");
    assert_eq!(one.lines().next(), Some("tau,mu0,mu,phi_deg,side,order,value,std_error,settled"));
    assert_eq!(one.lines().count(), 1 + 2 * 4);
    assert_eq!(one, csv("2"));
}

#[test]
fn photons_refuse_nonsense() {
    let dir = tempfile::tempdir().unwrap();
    for (more, says) in [
        (&["--view-mu", "0"][..], "view mu = 0 is outside (0, 1]"),
        (&["--view-mu", "1.5"], "view mu = 1.5"),
        (&["--view-mu", "0.5", "--phi", "500"], "phi (degrees) = 500"),
        (&["--view-mu", "0.5", "--estimator", "half-space"], "--estimator half-space"),
        (&["--view-mu", "0.5", "--std-error", "0.1"], "--std-error"),
        (&["--phi", "0"], "--view-mu"),
        (&["--view-mu", "0.5", "--orders", "100000"], "more than 16384 cells"),
    ] {
        let output = run(dir.path(), &traced(more));
        let message = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(2), "{more:?}: {message}");
        assert!(output.stdout.is_empty() && message.contains(says), "{more:?}: {message}");
    }
}
