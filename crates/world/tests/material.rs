//! A material read from folders, whole and damaged.
#![allow(clippy::unwrap_used, reason = "a test may stop where it fails")]

use std::fs;
use std::path::{Path, PathBuf};
use stratiform_optics::phase::{PhaseFunction, PhaseTable};
use stratiform_world::Material;
use tempfile::TempDir;

fn committed(name: &str) -> PathBuf {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../../fit-configs")).join(name)
}

/// A copy of what a material needs.
fn copy() -> TempDir {
    let (from, dir) = (committed("appendix-b"), tempfile::tempdir().unwrap());
    for folder in ["accepted", "generated"] {
        fs::create_dir(dir.path().join(folder)).unwrap();
        for entry in fs::read_dir(from.join(folder)).unwrap().map(Result::unwrap) {
            let name = entry.file_name().into_string().unwrap();
            if name.ends_with(".json") || name.ends_with(".csv") || name.ends_with(".wgsl") {
                fs::copy(entry.path(), dir.path().join(folder).join(name)).unwrap();
            }
        }
    }
    dir
}

fn refusal(dir: &TempDir) -> String {
    Material::load(dir.path()).unwrap_err().to_string()
}

fn edit(dir: &TempDir, file: &str, change: impl Fn(&str) -> String) {
    let path = dir.path().join(file);
    let text = fs::read_to_string(&path).unwrap();
    let changed = change(&text);
    assert_ne!(text, changed, "{file} has nothing to damage");
    fs::write(path, changed).unwrap();
}

/// The medium of the paper's cloud: N0 π r_e² = 300e6 π (7e-6)².
#[test]
fn the_papers_cloud_loads() {
    let material = Material::load(&committed("appendix-b")).unwrap();
    let kappa = 300e6 * std::f64::consts::PI * 49e-12;
    assert!((material.extinction_per_m / kappa - 1.0).abs() < 1e-12);
    let share = material.phase.forward_fraction(material.theta_f_deg).unwrap();
    assert!((share - material.forward_fraction).abs() < 1e-6, "{share}");
    assert!((material.phase.asymmetry() - material.asymmetry).abs() < 1e-4);
}

/// Diffraction: the forward peak is higher and narrower the shorter the wavelength; green is nearest to the one wavelength of the rest.
#[test]
fn colours_stand_in_their_order() {
    let material = Material::load(&committed("appendix-b")).unwrap();
    let [red, green, blue] = &material.colour;
    assert!(red.at(0.0) < green.at(0.0) && green.at(0.0) < blue.at(0.0));
    let shares: Vec<f64> = material.colour.iter().map(|p| p.forward_fraction(5.0).unwrap()).collect();
    assert!(shares[0] < shares[1] && shares[1] < shares[2], "{shares:?}");
    assert!((shares[1] - material.forward_fraction).abs() < 3e-3, "{shares:?}");
    for (p, squared) in material.colour.iter().zip(&material.colour_squared) {
        let beyond = p.modified(material.theta_f_deg).unwrap().asymmetry();
        assert!((squared.asymmetry() - beyond * beyond).abs() < 1e-3, "{} {beyond}", squared.asymmetry());
    }
}

/// Where a channel is brightest between 177 and 179 degrees.
fn ring(p: &PhaseTable) -> f64 {
    let at = |i: i32| 177.0 + f64::from(i) / 1000.0;
    let value = |i: &i32| p.at(at(*i).to_radians());
    at((0..2000).max_by(|a, b| value(a).total_cmp(&value(b))).unwrap())
}

/// Rings of γ = 18, r_e = 7 µm at 177.5 (red), 177.9 and 178.25 degrees; the
/// droplets of γ = 2 smear them and move them inwards.
#[test]
fn narrow_droplets_have_a_glory_in_colour() {
    let rings = |name: &str| Material::load(&committed(name)).unwrap().colour.each_ref().map(ring);
    for (found, expected) in rings("narrow").into_iter().zip([177.5, 177.9, 178.25]) {
        assert!((found - expected).abs() < 0.04, "{found} {expected}");
    }
    assert!((rings("appendix-b")[0] - 177.5).abs() > 0.2);
}

#[test]
fn a_folder_that_is_none_or_lacks_files_is_refused() {
    let dir = copy();
    assert!(Material::load(&dir.path().join("nowhere")).unwrap_err().to_string().contains("nowhere"));
    fs::remove_file(dir.path().join("accepted/phase_colour.csv")).unwrap();
    fs::remove_file(dir.path().join("generated/stratiform.wgsl")).unwrap();
    assert!(
        refusal(&dir).ends_with("lacks accepted/phase_colour.csv, generated/stratiform.wgsl"),
        "{}",
        refusal(&dir)
    );
}

#[test]
fn parts_of_different_configs_are_refused() {
    for file in ["accepted/phase_colour.csv", "generated/stratiform_phase.wgsl", "accepted/parameters.json"] {
        let dir = copy();
        edit(&dir, file, |text| text.replace("788f9247", "788f9248"));
        assert!(refusal(&dir).contains("788f9248"), "{file}: {}", refusal(&dir));
    }
    let dir = copy();
    edit(&dir, "accepted/parameters.json", |text| text.replace("0.4547162193", "0.4647162193"));
    assert!(refusal(&dir).contains("parameters.json says 0.46471"), "{}", refusal(&dir));
}

type Damage<'a> = &'a dyn Fn(&str) -> String;

#[test]
fn damage_is_told_with_file_and_line() {
    let line = |text: &str, number: usize, new: &str| {
        let mut lines: Vec<&str> = text.lines().collect();
        lines[number - 1] = new;
        lines.join("\n")
    };
    let cut = |text: &str| text[..text.len() / 2].to_owned();
    let damages: [(&str, Damage, &str); 7] = [
        ("accepted/phase_full.csv", &|text| line(text, 9, "0.2407,NaN"), "phase_full.csv:9: "),
        ("accepted/phase_full.csv", &cut, "phase_full.csv:"),
        (
            "accepted/phase_colour.csv",
            &|text| line(text, 9, "5,0,1,1,1,1,1,1"),
            "phase_colour.csv:9: theta_deg",
        ),
        ("accepted/phase_colour.csv", &cut, "phase_colour.csv:"),
        ("accepted/phase_colour.csv", &|_| String::new(), "phase_colour.csv: the file is empty"),
        ("accepted/parameters.json", &cut, "parameters.json:"),
        (
            "accepted/parameters.json",
            &|text| text.replace("\"asymmetry\": 0.8", "\"asymmetry\": 8.8"),
            "asymmetry = 8.8",
        ),
    ];
    for (file, damage, message) in damages {
        let dir = copy();
        edit(&dir, file, damage);
        assert!(refusal(&dir).contains(message), "{message}: {}", refusal(&dir));
    }
}
