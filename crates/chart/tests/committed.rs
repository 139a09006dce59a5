//! The chart in the repository.

#![allow(clippy::unwrap_used, reason = "a test may stop where it fails")]

use std::path::{Path, PathBuf};
use stratiform_artifact::{ChartDocument, ChartRow, KnobRow, read_csv, read_json};
use stratiform_methods::by_name;
use stratiform_scene::NAMES;

fn file(name: &str) -> PathBuf {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../../fit-configs/chart")).join(name)
}

/// Every method that it names exists under that name, every scene is one of the named ones, and every named one is there.
#[test]
fn it_names_only_what_exists() {
    let manifest: ChartDocument = read_json(&file("manifest.json")).unwrap();
    assert!(manifest.schema == ChartDocument::SCHEMA && !manifest.quick);
    let scenes: Vec<&str> = manifest.scenes.iter().map(|scene| scene.name.as_str()).collect();
    assert_eq!(scenes, NAMES);
    for method in &manifest.methods {
        assert_eq!(by_name(&method.name).unwrap().card().title, method.title);
    }
    let rows: Vec<ChartRow> = read_csv(&file("chart.csv")).unwrap();
    for row in &rows {
        let known = manifest.methods.iter().any(|method| method.name == row.method);
        assert!(known && scenes.contains(&row.scene.as_str()), "{row:?}");
        assert!(ChartRow::QUANTITIES.contains(&row.quantity.as_str()), "{row:?}");
    }
    let knobs: Vec<KnobRow> = read_csv(&file("knobs.csv")).unwrap();
    assert!(knobs.iter().all(|row| by_name(&format!("{}:{}", row.method, row.setting)).is_ok()));
}

/// A planted name is found.
#[test]
fn a_method_that_nobody_knows_is_none() {
    assert!(by_name("bouthors-forgotten").is_err() && by_name("fitted:3").is_err());
}
