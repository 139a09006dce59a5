//! The commands as other people's scripts call them.

#![allow(clippy::unwrap_used, reason = "a test may stop where it fails")]

mod common;

use common::{config, run, stdout};
use serde_json::Value;
use std::fs;

fn json(text: &str) -> Value {
    serde_json::from_str(text).unwrap()
}

/// Du 2004, case e: x = 100, m = 1.33 + 1e-5 i has Q_ext = 2.101321, Q_sca = 2.096594.
#[test]
fn mie_prints_the_schema_and_the_published_efficiencies() {
    let dir = tempfile::tempdir().unwrap();
    let args = ["mie", "--x", "100", "--m", "1.33,1e-5", "--angles", "0,90,180", "--json"];
    let document = json(&stdout(dir.path(), &args));
    assert_eq!(document["schema"], "stratiform/mie/1");
    assert!((document["q_ext"].as_f64().unwrap() - 2.101_321).abs() < 1e-6);
    assert!((document["q_sca"].as_f64().unwrap() - 2.096_594).abs() < 1e-6);
    assert_eq!(document["m"][1], 1e-5);
    assert_eq!(document["angles"].as_array().unwrap().len(), 3);
    assert_eq!(document["angles"][2]["theta_deg"], 180.0);
    assert!((document["angles"][0]["s1"][0].as_f64().unwrap() - 5253.3).abs() < 0.1);
}

#[test]
fn trace_prints_every_row_and_conserves_light() {
    let dir = tempfile::tempdir().unwrap();
    let args = ["trace", "--phase", "hg:0.85", "--tau", "0,5", "--mu0", "1,0,diffuse", "--photons", "2e3"];
    let document = json(&stdout(dir.path(), &[&args[..], &["--json"]].concat()));
    assert_eq!(document["schema"], "stratiform/orders/1");
    assert_eq!(document["medium"]["phase"], "hg:0.85");
    assert_eq!(document["provenance"]["seed"], 1);
    let results = document["results"].as_array().unwrap();
    assert_eq!(results.len(), 2 * 3 * 5);
    for row in results.iter().filter(|row| row["order"] == "total") {
        let value = |key: &str| row[key]["value"].as_f64().unwrap();
        assert!((value("reflectance") + value("transmittance") - 1.0).abs() < 1e-12, "{row}");
        assert!(row["reflectance"]["std_error"].as_f64().unwrap() > 0.0);
    }
    let csv = stdout(dir.path(), &args);
    let header =
        "tau,mu0,medium,order,reflectance,reflectance_std_error,transmittance,transmittance_std_error";
    assert_eq!(csv.lines().next(), Some(header));
    assert_eq!(csv.lines().count(), 1 + 2 * 3 * 5);
}

#[test]
fn the_bytes_do_not_depend_on_threads_nor_on_what_else_is_asked() {
    let dir = tempfile::tempdir().unwrap();
    let trace = |more: &[&str]| {
        let args = ["trace", "--phase", "hg:0.85", "--tau", "1,16", "--photons", "5e3"];
        stdout(dir.path(), &[&args[..], more].concat())
    };
    let one = trace(&["--mu0", "0.5", "--threads", "1"]);
    assert_eq!(one, trace(&["--mu0", "0.5", "--threads", "2"]));
    assert_eq!(one, trace(&["--mu0", "0.5", "--threads", "3"]));
    let among_others = trace(&["--mu0", "1,0.5"]);
    let rows: Vec<_> = among_others.lines().filter(|line| !line.contains(",1,full")).collect();
    assert_eq!(one.lines().collect::<Vec<_>>(), rows);
    assert_ne!(one, trace(&["--mu0", "0.5", "--seed", "8"]));
    assert_eq!(one, trace(&["--mu0", "0.5", "--seed", "1"]));
}

#[test]
fn a_target_error_is_met_or_the_exit_code_says_so() {
    let dir = tempfile::tempdir().unwrap();
    let args =
        ["trace", "--phase", "isotropic", "--tau", "1", "--mu0", "1", "--photons", "1e3", "--std-error"];
    let output = run(dir.path(), &[&args[..], &["1e-4"]].concat());
    assert_eq!(output.status.code(), Some(1));
    assert_eq!(output.stdout.iter().filter(|byte| **byte == b'\n').count(), 6, "what was reached is printed");
    assert!(String::from_utf8_lossy(&output.stderr).contains("not 1.000e-4"));
    stdout(dir.path(), &[&args[..], &["0.1"]].concat());
}

#[test]
fn files_give_the_phase_function() {
    let dir = tempfile::tempdir().unwrap();
    fs::write(dir.path().join("p.csv"), "theta_deg,p\n0,1\n180,1\n").unwrap();
    fs::write(dir.path().join("m.txt"), "1\n0.3\n").unwrap();
    for (phase, g) in [("table:p.csv", 0.0), ("moments:m.txt", 0.3), ("rayleigh", 0.0), ("draine:0.3,1", 0.3)]
    {
        let args = ["trace", "--phase", phase, "--tau", "1", "--mu0", "1", "--photons", "100", "--json"];
        let document = json(&stdout(dir.path(), &args));
        let asymmetry = document["medium"]["asymmetry"].as_f64().unwrap();
        assert!(phase.starts_with("draine") || (asymmetry - g).abs() < 1e-4, "{phase}: {asymmetry}");
    }
}

#[test]
fn optics_writes_what_its_document_lists() {
    let dir = tempfile::tempdir().unwrap();
    let args =
        ["--r-eff", "2", "--gamma", "6", "--n0", "100", "--wavelength", "0.55", "--out", "o", "--json"];
    let document = json(&stdout(dir.path(), &[&["optics"][..], &args].concat()));
    assert_eq!(document["schema"], "stratiform/optics/1");
    let wavelength = &document["wavelengths"][0];
    // 100 droplets per cm³ of effective radius 2 µm: 1e8 π (2e-6)² per metre.
    let paper = wavelength["extinction_per_m"]["paper"].as_f64().unwrap();
    assert!((paper - 1e8 * std::f64::consts::PI * 4e-12).abs() < 1e-12);
    let phase = wavelength["phase_csv"].as_str().unwrap();
    let table = format!("table:{}", dir.path().join("o").join(phase).display());
    stdout(dir.path(), &["trace", "--phase", &table, "--tau", "1", "--mu0", "1", "--photons", "100"]);
}

#[test]
fn codegen_writes_and_finds_stale_text() {
    let dir = tempfile::tempdir().unwrap();
    let accepted = common::root().join("fit-configs/appendix-b/accepted");
    let text =
        config(&[("appendix-b/accepted", accepted.to_str().unwrap()), ("appendix-b/generated", "emitted")]);
    fs::write(dir.path().join("c.toml"), text).unwrap();
    let missing = run(dir.path(), &["codegen", "c.toml", "--check"]);
    assert_eq!(missing.status.code(), Some(1));
    stdout(dir.path(), &["codegen", "c.toml"]);
    stdout(dir.path(), &["codegen", "c.toml", "--check"]);
    let shader = dir.path().join("emitted/stratiform.wgsl");
    let edited = fs::read_to_string(&shader).unwrap().replacen("fn stratiform", "fn  stratiform", 1);
    fs::write(&shader, edited).unwrap();
    let stale = run(dir.path(), &["codegen", "c.toml", "--check"]);
    assert_eq!(stale.status.code(), Some(1));
    let error = String::from_utf8_lossy(&stale.stderr).into_owned();
    assert!(error.contains("stratiform.wgsl is stale") && error.contains("-fn  stratiform"), "{error}");
    let object = run(dir.path(), &["codegen", "c.toml", "--check", "--json"]);
    assert_eq!(object.status.code(), Some(1));
    let object = json(&String::from_utf8_lossy(&object.stdout));
    assert_eq!(object["fresh"], false);
    assert_eq!(object["files"].as_array().unwrap().len(), 1);
}

#[test]
fn a_droplet_file_lies_beside_its_config() {
    let dir = tempfile::tempdir().unwrap();
    let sub = dir.path().join("sub");
    fs::create_dir(&sub).unwrap();
    fs::write(sub.join("d.csv"), "radius_um,number\n1,0\n2,1\n4,0\n").unwrap();
    let droplets = "distribution = \"tabulated\"\nfile = \"d.csv\"";
    let text = config(&[
        ("distribution = \"modified-gamma\"\neffective_radius_um = 7.0\ngamma = 2.0", droplets),
        ("[0.65, 0.55, 0.45]", "[0.55]"),
    ]);
    fs::write(sub.join("c.toml"), text).unwrap();
    let document = json(&stdout(dir.path(), &["optics", "--config", "sub/c.toml", "--out", "o", "--json"]));
    assert!(document["effective_radius_um"].as_f64().unwrap() > 2.0);
}
