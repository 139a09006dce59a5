//! `stratiform export`: what it writes, what it prints, what it refuses.

#![allow(clippy::unwrap_used, reason = "a test may stop where it fails")]

mod common;

use common::{config, root, run, stdout};
use std::fs;
use std::path::Path;

const ALL: [&str; 6] = ["csv", "json", "npz", "exr", "rgba32f.ktx2", "rgba16f.ktx2"];

/// A folder with the paper's config, changed, and its accepted parameters.
fn folder(replacements: &[(&str, &str)]) -> tempfile::TempDir {
    let dir = tempfile::tempdir().unwrap();
    fs::write(dir.path().join("cloud.toml"), config(replacements)).unwrap();
    let accepted = dir.path().join("appendix-b/accepted");
    fs::create_dir_all(&accepted).unwrap();
    let from = root().join("fit-configs/appendix-b/accepted/parameters.json");
    fs::copy(from, accepted.join("parameters.json")).unwrap();
    dir
}

fn export(dir: &Path, more: &[&str]) -> String {
    stdout(dir, &[&["export", "cloud.toml", "--out", "out"], more].concat())
}

fn files(dir: &Path) -> Vec<(String, Vec<u8>)> {
    let mut files: Vec<_> = fs::read_dir(dir.join("out"))
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .map(|path| (path.file_name().unwrap().to_str().unwrap().to_owned(), fs::read(&path).unwrap()))
        .collect();
    files.sort();
    files
}

const ONE_WAVELENGTH: (&str, &str) = ("wavelengths_um = [0.65, 0.55, 0.45]", "wavelengths_um = [0.55]");

/// Every file with its card; the same bytes again for any number of threads.
#[test]
fn files_and_cards() {
    let dir = folder(&[]);
    let text = export(dir.path(), &["--srgb", "--threads", "1"]);
    let stems = ["parameters", "phase", "phase-srgb"];
    let mut names: Vec<_> = ALL.iter().flat_map(|end| stems.map(|stem| format!("{stem}.{end}"))).collect();
    names.sort();
    let written = files(dir.path());
    assert_eq!(written.iter().map(|(name, _)| name.clone()).collect::<Vec<_>>(), names);
    let rows: Vec<csv::StringRecord> =
        csv::Reader::from_reader(text.as_bytes()).records().map(Result::unwrap).collect();
    // Two sets of three functions and three channels, and a parameter table.
    assert_eq!(rows.len(), ALL.len() * (2 * 9 + 1));
    for row in rows.iter().filter(|row| &row[1] != "parameters") {
        let integral: f64 = row[6].parse().unwrap();
        assert!((integral - 1.0).abs() < 2e-4, "{row:?}");
    }
    let g: f64 = rows.iter().find(|row| &row[1] == "full" && &row[2] == "550nm").unwrap()[7].parse().unwrap();
    assert!((g - 0.853).abs() < 1e-3, "{g}");
    assert_eq!(export(dir.path(), &["--srgb", "--threads", "2"]), text);
    assert_eq!(files(dir.path()), written);
}

#[test]
fn json_holds_the_same_numbers_and_formats_may_be_chosen() {
    let dir = folder(&[ONE_WAVELENGTH]);
    let formats = ["--formats", "ktx2-16,exr,exr", "--texels", "64"];
    let text = export(dir.path(), &formats);
    let object: serde_json::Value =
        serde_json::from_str(&export(dir.path(), &[&formats[..], &["--json"]].concat())).unwrap();
    assert_eq!(object["schema"], "stratiform/export/1");
    let files = object["files"].as_array().unwrap();
    let names: Vec<_> = files.iter().map(|file| file["file"].as_str().unwrap()).collect();
    assert_eq!(names, ["phase.exr", "parameters.exr", "phase.rgba16f.ktx2", "parameters.rgba16f.ktx2"]);
    let full = &files[0]["cards"][0];
    assert_eq!((&full["function"], &full["precision"]), (&"full".into(), &"f32".into()));
    let row = text.lines().nth(1).unwrap().split(',').collect::<Vec<_>>();
    assert_eq!(full["asymmetry"].as_f64().unwrap(), row[7].parse::<f64>().unwrap());
    assert!(files[3]["rounding"]["largest_error"].as_f64().unwrap() < 1.0 / 2048.0);
}

/// Without accepted parameters there are phase functions all the same.
#[test]
fn a_cloud_that_was_not_fitted_yet() {
    let dir = folder(&[ONE_WAVELENGTH]);
    fs::remove_dir_all(dir.path().join("appendix-b")).unwrap();
    let output = run(dir.path(), &["export", "cloud.toml", "--out", "out", "--formats", "csv"]);
    assert!(output.status.success());
    assert!(String::from_utf8_lossy(&output.stderr).contains("no accepted parameters"));
    assert_eq!(files(dir.path()).len(), 1);
}

/// Exit code 2, a message, nothing on stdout, nothing written.
#[test]
fn bad_input() {
    let dir = folder(&[ONE_WAVELENGTH]);
    let refused = |dir: &Path, more: &[&str], says: &[&str]| {
        let output = run(dir, &[&["export", "cloud.toml", "--out", "out"], more].concat());
        let error = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{more:?}: {error}");
        assert!(output.stdout.is_empty() && !dir.join("out").exists(), "{more:?}");
        assert!(says.iter().all(|part| error.contains(part)), "{more:?}: {error}");
    };
    let formats = ["dds", "csv", "json", "npz", "exr", "ktx2-32", "ktx2-16"];
    refused(dir.path(), &["--formats", "csv,dds"], &formats);
    refused(dir.path(), &["--texels", "63"], &["texels = 63 is outside [64, 1024]"]);
    refused(dir.path(), &["--texels", "1025"], &["texels = 1025 is outside [64, 1024]"]);
    refused(dir.path(), &["--srgb"], &["wavelengths of a colour = 1"]);
    let parameters = dir.path().join("appendix-b/accepted/parameters.json");
    let text = fs::read_to_string(&parameters).unwrap();
    fs::write(&parameters, text.replace("\"emitted\": 0.2888940389260907", "\"emitted\": -0.3")).unwrap();
    refused(dir.path(), &["--formats", "csv"], &["parameters.json", "c = -0.3 is outside (0, infinity)"]);
    fs::write(&parameters, "{}").unwrap();
    refused(dir.path(), &["--formats", "csv"], &["parameters.json"]);
    let big = "distribution = \"single-size\"\nradius_um = 40.0";
    let droplets = ("distribution = \"modified-gamma\"\neffective_radius_um = 7.0\ngamma = 2.0", big);
    let dir = folder(&[ONE_WAVELENGTH, droplets]);
    let says = ["p of full at 550nm in f16 = ", "[-65504, 65504]"];
    refused(dir.path(), &["--texels", "1024"], &says);
}
