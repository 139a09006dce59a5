//! The drawing of a study of estimators, and that the committed one shows the committed rows.

#![allow(clippy::unwrap_used, reason = "a test may stop where it fails")]

use roxmltree::Document;
use std::path::Path;
use stratiform_artifact::{EstimatorErrorRow, read_csv, read_text};
use stratiform_report::draw_estimators;

fn row(estimator: &str, quantity: &str, photons: u64, error: f64) -> EstimatorErrorRow {
    EstimatorErrorRow {
        estimator: estimator.to_owned(),
        quantity: quantity.to_owned(),
        tau: 4.0,
        mu0: 0.5,
        photons,
        seconds: 1e-6 * photons as f64,
        error,
    }
}

#[test]
fn every_estimator_is_in_the_legend_and_every_quantity_has_panels() {
    let estimators = ["counted", "guessed"];
    let rows: Vec<_> = estimators
        .iter()
        .flat_map(|name| {
            [100, 10_000].map(|n| row(name, "R1", n, 0.1)).into_iter().chain([row(name, "T", 100, 0.2)])
        })
        .collect();
    let (name, svg) = draw_estimators(&rows);
    assert_eq!(name, "estimators.svg");
    let document = Document::parse(&svg).unwrap();
    let texts: Vec<_> = document.descendants().filter_map(|node| node.text()).collect();
    for wanted in estimators.into_iter().chain(["slope −1/2"]) {
        assert!(texts.contains(&wanted), "{wanted}: {texts:?}");
    }
    let axes = document.descendants().filter(|node| node.attribute("class") == Some("axis")).count();
    assert_eq!(axes, 8, "two panels for each of two quantities");
}

#[test]
fn an_error_of_zero_is_left_out_and_no_rows_are_no_panels() {
    let (_, svg) = draw_estimators(&[row("exact", "R", 100, 0.0)]);
    assert!(!svg.contains("NaN") && !svg.contains("inf"), "{svg}");
    assert!(Document::parse(&draw_estimators(&[]).1).is_ok());
}

#[test]
fn the_committed_figure_shows_the_committed_rows() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fit-configs/estimators");
    let rows: Vec<EstimatorErrorRow> = read_csv(&folder.join("convergence.csv")).unwrap();
    let (name, svg) = draw_estimators(&rows);
    assert_eq!(svg, read_text(&folder.join(name)).unwrap());
}
