//! `stratiform export`: what it writes, what it prints, what it refuses.

#![allow(clippy::unwrap_used, reason = "a test may stop where it fails")]

mod common;

use common::{config, root, run, stdout};
use std::fs;
use std::path::Path;
use stratiform_artifact::{ParametersDocument, read_json, write_json};
use stratiform_cli::config::Config;

const ALL: [&str; 6] = ["csv", "json", "npz", "exr", "rgba32f.ktx2", "rgba16f.ktx2"];

/// A folder with the paper's config, changed, and the paper's parameters as if they were accepted for it.
fn folder(replacements: &[(&str, &str)]) -> tempfile::TempDir {
    let dir = tempfile::tempdir().unwrap();
    fs::write(dir.path().join("cloud.toml"), config(replacements)).unwrap();
    let accepted = dir.path().join("appendix-b/accepted");
    fs::create_dir_all(&accepted).unwrap();
    let from = root().join("fit-configs/appendix-b/accepted/parameters.json");
    let parameters: ParametersDocument = read_json(&from).unwrap();
    let changed = Config::load(&dir.path().join("cloud.toml")).unwrap();
    let provenance = stratiform_cli::pipeline::provenance(&changed);
    write_json(&accepted.join("parameters.json"), &ParametersDocument { provenance, ..parameters }).unwrap();
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

/// Optics to a few per cent: the tests are about files.
const LOOSE: (&str, &str) = (
    "theta_f_deg = 5.0",
    "theta_f_deg = 5.0\ntolerance = { asymmetry = 3e-3, forward_fraction = 1e-2, moments = 1e-2, phase_below_60_deg = 0.3, phase_beyond_60_deg = 1.0 }",
);

const ONE_WAVELENGTH: (&str, &str) = ("wavelengths_um = [0.65, 0.55, 0.45]", "wavelengths_um = [0.55]");

/// Every file with its card; the same bytes again for any number of threads.
#[test]
fn files_and_cards() {
    let dir = folder(&[LOOSE]);
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
    assert!((g - 0.853).abs() < 3e-3, "{g}");
    assert_eq!(export(dir.path(), &["--srgb", "--threads", "2"]), text);
    assert_eq!(files(dir.path()), written);
}

#[test]
fn json_holds_the_same_numbers_and_formats_may_be_chosen() {
    let dir = folder(&[ONE_WAVELENGTH, LOOSE]);
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

/// Other programs' files: one per wavelength, or one for all, each with a card of that program's own look-up.
#[test]
fn files_of_other_programs() {
    let small = ("effective_radius_um = 7.0", "effective_radius_um = 1.0");
    let dir = folder(&[LOOSE, small]);
    let text = export(dir.path(), &["--formats", "mitsuba,mitsuba-irregular,eradiate,mcx,disort,bevy"]);
    let each = ["irregular.xml", "mcx.json", "pmom.txt", "tabphase.xml"];
    let each = each.iter().flat_map(|end| ["450", "550", "650"].map(|nm| format!("phase.{nm}nm.{end}")));
    let mut names: Vec<_> = each.chain(["particles.nc", "phase.bevy.ktx2"].map(str::to_owned)).collect();
    names.sort();
    let written = files(dir.path());
    assert_eq!(written.iter().map(|(name, _)| name.clone()).collect::<Vec<_>>(), names);
    let of = |wanted: &str| &written.iter().find(|(name, _)| name == wanted).unwrap().1;
    assert!(
        of("particles.nc").starts_with(b"CDF\x01") && of("phase.bevy.ktx2").starts_with(b"\xABKTX 20\xBB")
    );
    let pmom = String::from_utf8(of("phase.550nm.pmom.txt").clone()).unwrap();
    let chi: Vec<f64> = pmom.lines().skip(1).map(|line| line.parse().unwrap()).collect();
    let rows: Vec<csv::StringRecord> =
        csv::Reader::from_reader(text.as_bytes()).records().map(Result::unwrap).collect();
    assert_eq!(rows.len(), 3 * 6);
    for row in rows {
        let [integral, g]: [f64; 2] = [6, 7].map(|column| row[column].parse().unwrap());
        assert!((integral - 1.0).abs() < 1e-3 && &row[1] == "full", "{row:?}");
        assert!(&row[2] != "550nm" || (g - chi[1]).abs() < 1e-4, "{row:?} {}", chi[1]);
    }
}

/// Without accepted parameters there are phase functions all the same.
#[test]
fn a_cloud_that_was_not_fitted_yet() {
    let dir = folder(&[ONE_WAVELENGTH, LOOSE]);
    fs::remove_dir_all(dir.path().join("appendix-b")).unwrap();
    let output = run(dir.path(), &["export", "cloud.toml", "--out", "out", "--formats", "csv"]);
    assert!(output.status.success());
    assert!(String::from_utf8_lossy(&output.stderr).contains("no accepted parameters"));
    assert_eq!(files(dir.path()).len(), 1);
}

/// Exit code 2, a message, nothing on stdout, nothing written.
#[test]
fn bad_input() {
    let dir = folder(&[ONE_WAVELENGTH, LOOSE]);
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
    refused(dir.path(), &["--srgb"], &["--srgb: wavelengths of a colour = 1 is outside [3, infinity)"]);
    refused(dir.path(), &["--formats", "csv,bevy"], &["--formats bevy: wavelengths of a colour = 1"]);
    refused(dir.path(), &["--formats", "mcx", "--srgb"], &["--srgb: none of the formats"]);
    let parameters = dir.path().join("appendix-b/accepted/parameters.json");
    let text = fs::read_to_string(&parameters).unwrap();
    let (before, rest) = text.split_once("\"emitted\": 0.288894038").unwrap();
    let digits = rest.trim_start_matches(|digit: char| digit.is_ascii_digit());
    fs::write(&parameters, format!("{before}\"emitted\": -0.3{digits}")).unwrap();
    refused(dir.path(), &["--formats", "csv"], &["parameters.json", "c = -0.3 is outside (0, infinity)"]);
    fs::write(&parameters, "{}").unwrap();
    refused(dir.path(), &["--formats", "csv"], &["parameters.json"]);
    let big = "distribution = \"single-size\"\nradius_um = 40.0";
    let droplets = ("distribution = \"modified-gamma\"\neffective_radius_um = 7.0\ngamma = 2.0", big);
    let dir = folder(&[ONE_WAVELENGTH, LOOSE, droplets]);
    let says = ["p of full at 550nm in f16 = ", "[-65504, 65504]"];
    refused(dir.path(), &["--texels", "1024", "--formats", "ktx2-16"], &says);
}
