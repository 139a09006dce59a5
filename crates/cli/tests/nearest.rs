//! `stratiform nearest` as other people's scripts call it.

#![allow(clippy::unwrap_used, reason = "a test may stop where it fails")]

mod common;

use common::{run, stdout};
use serde_json::Value;
use std::fmt::Write;
use std::fs;
use std::path::Path;

const G: f64 = 0.7;

/// Henyey and Greenstein's function (1941) every quarter of a degree.
fn write_table(dir: &Path) {
    let text = (0..=720).fold("theta_deg,p\n".to_owned(), |mut text, i| {
        let theta_deg = 0.25 * f64::from(i);
        let off = 1.0 + G * G - 2.0 * G * libm::cos(theta_deg.to_radians());
        let _ = writeln!(text, "{theta_deg},{}", (1.0 - G * G) / (off * off.sqrt()));
        text
    });
    fs::write(dir.join("hg.csv"), text).unwrap();
}

#[test]
fn a_table_of_henyey_and_greenstein_is_found_again() {
    let dir = tempfile::tempdir().unwrap();
    write_table(dir.path());
    let args = ["nearest", "--phase", "table:hg.csv", "--diameter", "20"];
    let text = stdout(dir.path(), &args);
    let mut reader = csv::Reader::from_reader(text.as_bytes());
    let columns = "family,fitted_by,diameter_um,w,g1,g2,alpha,total_variation,log_rms,asymmetry,asymmetry_error,forward_fraction,\
                   forward_fraction_error,backward_fraction,backward_fraction_error,forward_ratio,fogbow_ratio,glory_ratio";
    assert_eq!(reader.headers().unwrap().iter().collect::<Vec<_>>().join(","), columns);
    let rows: Vec<csv::StringRecord> = reader.records().map(Result::unwrap).collect();
    assert_eq!(rows.len(), 9);

    let json = stdout(dir.path(), &[&args[..], &["--json"]].concat());
    let document: Value = serde_json::from_str(&json).unwrap();
    assert_eq!(document["schema"], "stratiform/nearest-phases/1");
    assert_eq!(document["theta_f_deg"], 5.0);
    let number = |row: usize, column: &str| document["rows"][row][column].as_f64().unwrap();
    for (i, row) in rows.iter().enumerate() {
        assert_eq!(number(i, "g1"), row[4].parse::<f64>().unwrap());
    }
    // By asymmetry g is that of the table to the last bit; the table is linear between its rows, hence the tolerance to 0.7.
    assert_eq!((&rows[0][0], &rows[0][1]), ("henyey-greenstein", "asymmetry"));
    assert_eq!((number(0, "asymmetry_error"), number(0, "asymmetry")), (0.0, number(0, "g1")));
    assert!((number(0, "g1") - G).abs() < 1e-5 && number(0, "total_variation") < 1e-4);
    // ½∫P dcosΘ below 5° in closed form: (1-g²)/2g · (1/(1-g) - 1/√(1+g²-2g cos 5°)).
    let edge = (1.0 + G * G - 2.0 * G * libm::cos(5.0_f64.to_radians())).sqrt();
    let share = (1.0 - G * G) / (2.0 * G) * (1.0 / (1.0 - G) - 1.0 / edge);
    assert!((number(0, "forward_fraction") - share).abs() < 1e-4);
    // The blend for droplets of 20 µm is none of them.
    assert_eq!(number(8, "diameter_um"), 20.0);
    assert!(number(8, "total_variation") > 0.1);
}

/// Exit code 2, one message, nothing on stdout.
#[test]
fn bad_input() {
    let dir = tempfile::tempdir().unwrap();
    write_table(dir.path());
    fs::write(dir.path().join("half.csv"), "theta_deg,p\n0,0.5\n180,0.5\n").unwrap();
    let cases: [(&[&str], &str); 6] = [
        (&["--phase", "hg:0.85"], "--phase hg:0.85: not one of moments:FILE, table:FILE, config:FILE"),
        (&["--phase", "table:none.csv"], "cannot read none.csv"),
        (
            &["--phase", "table:half.csv"],
            "half.csv: the phase function's norm is 0.5, outside [0.999, 1.001]",
        ),
        (&["--phase", "table:hg.csv", "--diameter", "4"], "diameter_um = 4 is outside [5, 50]"),
        (&["--phase", "table:hg.csv", "--theta-f", "0"], "theta_f_deg = 0 is outside (0, 180)"),
        (&["--phase", "table:hg.csv", "--theta-f", "nan"], "`nan` is not a finite number"),
    ];
    for (args, expected) in cases {
        let output = run(dir.path(), &[&["nearest"], args].concat());
        let error = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(2), "{args:?}: {error}");
        assert!(error.contains(expected) && output.stdout.is_empty(), "{args:?}: {error}");
    }
}
