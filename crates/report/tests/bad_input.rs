//! Missing, damaged and impossible artifacts: one error that names the file, and nothing written.

#![allow(clippy::unwrap_used, reason = "tests")]

mod folder;

use std::path::Path;
use stratiform_artifact::{OpticsDocument, ParametersDocument, read_json, read_text, write_json};
use stratiform_report::{ReportError, build};

/// Builds a synthetic folder after `change`; checks that it failed and that nothing was written.
fn refused(change: impl FnOnce(&Path)) -> ReportError {
    let dir = tempfile::tempdir().unwrap();
    folder::write(dir.path());
    change(dir.path());
    let error = build(dir.path()).expect_err("accepted");
    assert!(!dir.path().join("report.html").exists(), "a page was written");
    assert!(!dir.path().join("figures/parameters.svg").exists(), "a figure was written");
    error
}

/// The error after replacing `from` by `to` in a text file.
fn refused_edit(file: &str, from: &str, to: &str) -> ReportError {
    refused(|dir| {
        let text = read_text(&dir.join(file)).unwrap();
        assert!(text.contains(from), "{file} has no `{from}`");
        std::fs::write(dir.join(file), text.replacen(from, to, 1)).unwrap();
    })
}

const ALL: [&str; 9] = [
    "optics/optics.json",
    "optics/phase-0.55.csv",
    "orders.csv",
    "parameters.json",
    "optics/sphere.csv",
    "convergence.csv",
    "published.csv",
    "curves.csv",
    "notes.json",
];

#[test]
fn a_missing_file_that_is_needed_is_named() {
    for file in &ALL[..4] {
        let error = refused(|dir| std::fs::remove_file(dir.join(file)).unwrap());
        assert!(matches!(&error, ReportError::Missing { path, .. } if path.ends_with(file)), "{error}");
        assert!(error.to_string().contains(" is missing: the report needs "), "{error}");
    }
}

#[test]
fn empty_binary_and_truncated_files_are_named() {
    for file in ALL {
        let name = Path::new(file).file_name().unwrap().to_str().unwrap();
        for damage in ["empty", "binary", "truncated"] {
            let error = refused(|dir| {
                let path = dir.join(file);
                let whole = std::fs::read(&path).unwrap();
                let bytes = match damage {
                    "empty" => Vec::new(),
                    "binary" => vec![0xff, 0xfe, 0, 1],
                    _ => whole[..whole.iter().rposition(|b| matches!(b, b',' | b'}')).unwrap()].to_vec(),
                };
                std::fs::write(&path, bytes).unwrap();
            });
            assert!(matches!(error, ReportError::Artifact(_)), "{damage} {file}: {error}");
            assert!(error.to_string().contains(name), "{damage} {file}: {error}");
        }
    }
}

#[test]
fn impossible_numbers_are_named_with_row_value_and_range() {
    for (file, from, to, message) in [
        ("orders.csv", "\n0,1.0,", "\n0,NaN,", "row 1, thickness_m = NaN is outside (0, infinity)"),
        ("orders.csv", "\n0,1.0,", "\n0,-1.0,", "row 1, thickness_m = -1 is outside (0, infinity)"),
        ("orders.csv", "\n0,1.0,", "\nzenith,1.0,", "row 1, theta_l_deg = NaN is outside [0, 90]"),
        ("orders.csv", "modified,0,", "modified,first,", "row 1: order `first`"),
        ("curves.csv", "\n0.0,1.0,", "\n0.0,inf,", "row 1, thickness_m = inf is outside (0, infinity)"),
        ("published.csv", "\n0.0,1.1796", "\n91.0,1.1796", "row 1, theta_l_deg = 91 is outside [0, 90]"),
        ("published.csv", "1.1796", "NaN", "row 1, b = NaN is outside"),
        ("convergence.csv", "plain,40.0,5.0,0,10000", "plain,40.0,5.0,0,0", "row 1, photons = 0 is outside"),
        ("optics/phase-0.55.csv", "\n0,", "\n-1,", "row 1, theta_deg = -1 is outside [0, 180]"),
        ("optics/phase-0.55.csv", "\n0,", "\n50,", "row 2, theta_deg ="),
        ("optics/phase-0.55.csv", "\n0,", "\n0,-", "row 1, p = -"),
    ] {
        let error = refused_edit(file, from, to).to_string();
        assert!(error.contains(message) && error.contains(file), "{file}: {error}");
    }
}

#[test]
fn wrong_schemas_and_unknown_names_are_refused() {
    for (file, from, to, message) in [
        (
            "parameters.json",
            "stratiform/parameters/1",
            "stratiform/parameters/9",
            "schema is `stratiform/parameters/9`",
        ),
        (
            "notes.json",
            "stratiform/notes/1",
            "stratiform/optics/1",
            "this program reads `stratiform/notes/1`",
        ),
        ("optics/optics.json", "\"droplets\"", "\"droplet\"", "unknown field `droplet`"),
        ("curves.csv", "t_ms,fitted", "t_all,fitted", "t_all"),
        ("orders.csv", "transmittance_std_error", "transmitance_std_error", "transmitance_std_error"),
    ] {
        let error = refused_edit(file, from, to).to_string();
        assert!(error.contains(message), "{file}: {error}");
    }
}

#[test]
fn documents_without_content_are_refused() {
    let error = refused(|dir| {
        let path = dir.join("parameters.json");
        let mut document: ParametersDocument = read_json(&path).unwrap();
        document.metres.rows.clear();
        write_json(&path, &document).unwrap();
    });
    assert!(error.to_string().ends_with("metres.rows is empty; at least one angle is needed"), "{error}");
    let error = refused(|dir| edit_optics(dir, |optics| optics.wavelengths.clear()));
    assert!(error.to_string().contains("wavelengths is empty"), "{error}");
    let error = refused(|dir| edit_optics(dir, |optics| optics.size_density.radius_um.truncate(7)));
    assert!(error.to_string().contains("7 radius_um and 300 number_per_cm3_um"), "{error}");
}

#[test]
fn a_phase_table_outside_the_folder_is_refused() {
    for name in ["../orders.csv", "/etc/passwd"] {
        let error =
            refused(|dir| edit_optics(dir, |optics| optics.wavelengths[0].phase_csv = name.to_owned()));
        assert!(error.to_string().contains(&format!("phase_csv = `{name}`")), "{error}");
    }
}

fn edit_optics(dir: &Path, edit: impl FnOnce(&mut OpticsDocument)) {
    let path = dir.join("optics/optics.json");
    let mut optics: OpticsDocument = read_json(&path).unwrap();
    edit(&mut optics);
    write_json(&path, &optics).unwrap();
}

#[test]
fn an_unwritable_place_is_an_error_and_leaves_no_page() {
    let error = refused(|dir| {
        std::fs::remove_dir_all(dir.join("figures")).unwrap();
        std::fs::write(dir.join("figures"), "a file, not a folder").unwrap();
    });
    assert!(matches!(error, ReportError::Artifact(_)), "{error}");
    assert!(error.to_string().contains("figures"), "{error}");
}
