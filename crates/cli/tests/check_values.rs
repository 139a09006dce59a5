//! `stratiform check --values` on somebody else's numbers.

#![allow(clippy::unwrap_used, reason = "a test may stop where it fails")]

mod common;

use common::{config, run, stdout};
use std::fs;
use std::path::Path;

const HEADER: &str = "quantity,theta_l_deg,theta_v_deg,phi_deg,tau,order,value";

/// Bounds of radiances in the config.
const TOP: &str = "[check.values.radiance_top]\nany = { absolute = 0.01, relative = 0.05 }\n";
const BOTTOM: &str = "[check.values.radiance_bottom]\nany = { absolute = 0.01, relative = 0.05 }\n";

/// One wavelength, and no bound for radiances leaving below.
fn prepare(dir: &Path) {
    fs::write(dir.join("c.toml"), config(&[("[0.65, 0.55, 0.45]", "[0.55]"), (BOTTOM, "")])).unwrap();
}

/// `solve` says what is right, to six digits beyond the bound.
fn truth(dir: &Path, mu0: &str, modified: bool) -> Vec<Vec<String>> {
    let medium = ["--phase", "config:c.toml", "--tau", "0.5,5", "--mu0", mu0, "--tolerance", "1e-4"];
    let more: &[&str] = if modified { &["--modified", "5"] } else { &[] };
    let csv = stdout(dir, &[&["solve"], &medium[..], more].concat());
    csv.lines().skip(1).map(|line| line.split(',').map(str::to_owned).collect()).collect()
}

/// Values equal to what `solve` prints pass; a little beyond the bound they do not.
#[test]
fn true_values_pass_and_errors_just_above_the_bound_do_not() {
    let dir = tempfile::tempdir().unwrap();
    prepare(dir.path());
    let row = |quantity: &str, theta: &str, cells: &[String], off: f64| {
        let value: f64 = cells[if quantity == "reflectance" { 4 } else { 6 }].parse().unwrap();
        format!("{quantity},{theta},,,{},{},{}\n", cells[0], cells[3], value + off)
    };
    let table = |off: f64| {
        let mut text = format!("{HEADER}\n");
        for (theta, mu0) in [("60", "0.5"), ("diffuse", "diffuse")] {
            for cells in truth(dir.path(), mu0, true).iter().filter(|cells| cells[3] != "total") {
                text += &row("transmittance", theta, cells, 0.0);
            }
            for cells in truth(dir.path(), mu0, false).iter().filter(|cells| cells[3] == "total") {
                text += &row("reflectance", theta, cells, 0.0);
                text += &row("transmittance", theta, cells, off);
            }
        }
        fs::write(dir.path().join("v.csv"), text).unwrap();
    };
    let check = ["check", "c.toml", "--values", "v.csv"];
    table(0.0);
    assert!(stdout(dir.path(), &check).ends_with("24 comparisons, all within their bounds\n"));
    // The bound is 0.015, the truth's own error at most 1e-4, the printed one's too.
    table(0.0148);
    stdout(dir.path(), &check);
    table(0.0153);
    let output = run(dir.path(), &check);
    assert_eq!(output.status.code(), Some(1));
    let text = String::from_utf8(output.stdout).unwrap();
    assert!(
        text.contains("worst offenders (4 of 4)\n  values: transmittance order total at theta_l"),
        "{text}"
    );
}

#[test]
fn the_places_to_evaluate_are_a_table_to_fill_in() {
    let dir = tempfile::tempdir().unwrap();
    prepare(dir.path());
    assert_eq!(stdout(dir.path(), &["check", "c.toml", "--points", "p.csv"]), "p.csv\n");
    let text = fs::read_to_string(dir.path().join("p.csv")).unwrap();
    assert_eq!(text.lines().next(), Some(HEADER));
    // 9 angles up to 80, 8 between, diffuse light; 20 thicknesses; 4 orders of reflectance and 5 of transmittance.
    assert_eq!(text.lines().count(), 1 + 18 * 20 * 9);
    let output = run(dir.path(), &["check", "c.toml", "--values", "p.csv"]);
    assert_eq!(output.status.code(), Some(2));
    assert_eq!(String::from_utf8(output.stderr).unwrap(), "error: p.csv:2: value is empty\n");
}

/// What `solve --view-mu` prints passes; a little beyond the bound does not.
#[test]
fn radiance_is_held_against_the_radiance_solver() {
    let dir = tempfile::tempdir().unwrap();
    let bounds = "[check.values.radiance_top]\nany = { absolute = 0.01 }\n\
                  [check.values.radiance_bottom]\ntotal = { relative = 0.1 }\nany = { absolute = 0.01 }\n";
    fs::write(
        dir.path().join("c.toml"),
        config(&[("[0.65, 0.55, 0.45]", "[0.55]"), (TOP, ""), (BOTTOM, "")]) + bounds,
    )
    .unwrap();
    let solve = |more: &[&str]| {
        let places = ["--tau", "2", "--mu0", "0.5", "--view-mu", "1", "--phi", "90"];
        stdout(dir.path(), &[&["solve", "--phase", "config:c.toml"], &places[..], more].concat())
    };
    let (totals, orders) = (solve(&[]), solve(&["--modified", "5"]));
    let table = |off: f64| {
        let mut text = format!("{HEADER}\n");
        let totals = totals.lines().filter(|line| line.contains(",total,"));
        for line in totals.chain(orders.lines().skip(1).filter(|line| !line.contains(",total,"))) {
            let cells: Vec<_> = line.split(',').collect();
            let value: f64 = cells[6].parse().unwrap();
            text += &format!("radiance_{},60,0,90,2,{},{}\n", cells[4], cells[5], value + off);
        }
        fs::write(dir.path().join("v.csv"), text).unwrap();
        run(dir.path(), &["check", "c.toml", "--values", "v.csv"])
    };
    let output = table(0.0);
    let said = String::from_utf8(output.stdout).unwrap();
    assert!(said.ends_with("6 comparisons, all within their bounds\n"), "{said}");
    // 0.01 and the truth's own error, at most 1e-3; the total below is bounded by a tenth of some 0.4.
    let output = table(0.013);
    assert_eq!(output.status.code(), Some(1));
    let said = String::from_utf8(output.stdout).unwrap();
    assert!(said.contains("worst offenders (5 of 5)"), "{said}");
}

/// The sun is named where the truth cannot be had.
#[test]
fn a_radiance_tolerance_that_cannot_be_met_is_exit_1() {
    let dir = tempfile::tempdir().unwrap();
    let rate = "false_alarm_rate";
    let strict = format!("radiance_tolerance = 2e-8\n{rate}");
    fs::write(dir.path().join("c.toml"), config(&[("[0.65, 0.55, 0.45]", "[0.55]"), (rate, &strict)]))
        .unwrap();
    let rows = "radiance_top,89.999,0,0,1000,total,0.1\nradiance_top,89.999,89.9999,0,1000,total,0.1\n";
    fs::write(dir.path().join("v.csv"), format!("{HEADER}\n{rows}")).unwrap();
    let output = run(dir.path(), &["check", "c.toml", "--values", "v.csv"]);
    let error = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(1), "{error}");
    let says = "the deterministic truth of radiance at theta_l 89.999: tolerance = 2e-8";
    assert!(output.stdout.is_empty() && error.contains(says), "{error}");
}

/// A truth that misses its tolerance at the horizon widens its row's bound and stops nothing.
#[test]
fn rows_of_slow_truth_are_judged_with_its_error() {
    let dir = tempfile::tempdir().unwrap();
    let none = [("[0.65, 0.55, 0.45]", "[0.55]")];
    fs::write(dir.path().join("c.toml"), config(&none)).unwrap();
    let rows = "radiance_top,90,60,0,5,total,9\nradiance_top,60,60,180,5,1,9\n";
    fs::write(dir.path().join("v.csv"), format!("{HEADER}\n{rows}")).unwrap();
    let output = run(dir.path(), &["check", "c.toml", "--values", "v.csv"]);
    assert_eq!(output.status.code(), Some(1));
    let said = String::from_utf8(output.stdout).unwrap();
    assert!(said.contains("2 of 2 comparisons are out of bounds"), "{said}");
}

#[test]
fn tables_that_mean_nothing_are_refused_with_file_and_line() {
    let dir = tempfile::tempdir().unwrap();
    prepare(dir.path());
    let long = format!("{HEADER}\nreflectance,0,,,1,total,0.1\nreflectance,0,,,1,total,0.2\n");
    for (text, says) in [
        ("", "v.csv: the file is empty"),
        (HEADER, "v.csv:1: the table has no rows"),
        ("quantity,theta_l_deg,tau,order,value\n", "v.csv:1: column `theta_v_deg` is missing"),
        (&format!("{HEADER}\nalbedo,0,,,1,total,0.1\n"), "v.csv:2: quantity `albedo`"),
        (&format!("{HEADER}\nreflectance,0,,,1,total,NaN\n"), "v.csv:2: value: `NaN`"),
        (&format!("{HEADER}\nreflectance,90.5,,,1,total,0.1\n"), "v.csv:2: theta_l_deg = 90.5"),
        (&format!("{HEADER}\nradiance_top,0,,,1,total,0.1\n"), "v.csv:2: theta_v_deg is empty"),
        (&format!("{HEADER}\nradiance_bottom,0,10,0,1,total,0.1\n"), "v.csv:2: the config states no bound"),
        (&long, "v.csv:3: repeats line 2"),
    ] {
        fs::write(dir.path().join("v.csv"), text).unwrap();
        let args = ["check", "c.toml", "--values", "v.csv", "--junit", "a.xml", "--markdown", "a.md"];
        let output = run(dir.path(), &args);
        let error = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{text}: {error}");
        assert!(output.stdout.is_empty() && error.contains(says), "{says}: {error}");
        assert!(!dir.path().join("a.xml").exists() && !dir.path().join("a.md").exists());
    }
}

/// Nothing is written over an input, nor twice to one file, nor to a folder.
#[test]
fn files_to_be_written_are_told_apart() {
    let dir = tempfile::tempdir().unwrap();
    prepare(dir.path());
    let values = format!("{HEADER}\nreflectance,0,,,1,total,0.1\n");
    fs::write(dir.path().join("v.csv"), &values).unwrap();
    let config = fs::read_to_string(dir.path().join("c.toml")).unwrap();
    fs::create_dir(dir.path().join("folder")).unwrap();
    let here = dir.path().join("v.csv");
    for (more, says) in [
        (
            &["--values", "v.csv", "--junit", "v.csv"][..],
            "cannot write v.csv: --junit is the same file as --values",
        ),
        (&["--values", "v.csv", "--markdown", "folder/../v.csv"], "--markdown is the same file as --values"),
        (&["--values", "v.csv", "--junit", here.to_str().unwrap()], "--junit is the same file as --values"),
        (
            &["--values", "v.csv", "--junit", "a", "--markdown", "./a"],
            "--markdown is the same file as --junit",
        ),
        (
            &["--values", "v.csv", "--junit", "c.toml"],
            "cannot write c.toml: --junit is the same file as the config",
        ),
        (&["--points", "c.toml"], "--points is the same file as the config"),
        (&["--store-counts", "c.toml"], "--store-counts is the same file as the config"),
        (&["--values", "v.csv", "--junit", "folder"], "cannot write folder: it is a folder"),
        (&["--values", "v.csv", "--markdown", "folder/"], "cannot write folder/: it is a folder"),
        (&["--points", "."], "cannot write .: it is a folder"),
    ] {
        let output = run(dir.path(), &[&["check", "c.toml"], more].concat());
        let error = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{more:?}: {error}");
        assert!(output.stdout.is_empty() && error.contains(says), "{more:?}: {error}");
        assert!(!dir.path().join("a").exists());
    }
    assert_eq!(fs::read_to_string(here).unwrap(), values);
    assert_eq!(fs::read_to_string(dir.path().join("c.toml")).unwrap(), config);
}
