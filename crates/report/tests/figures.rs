//! What every figure must be: well-formed, labelled with units, free of numbers that are none, always the same.

#![allow(clippy::unwrap_used, reason = "tests")]

mod folder;

use roxmltree::{Document, Node};
use std::collections::BTreeMap;
use std::path::Path;
use stratiform_artifact::{
    ConvergenceRow, CurvesRow, FittedParameter, OpticsDocument, OrdersRow, ParametersDocument, read_csv,
    read_json, write_csv, write_json,
};
use stratiform_report::build;

/// Name and text of each figure of a fresh synthetic folder, changed by `change`.
fn drawn(change: impl FnOnce(&Path)) -> BTreeMap<String, String> {
    let dir = tempfile::tempdir().unwrap();
    folder::write(dir.path());
    change(dir.path());
    let summary = build(dir.path()).unwrap();
    let name = |path: &Path| path.file_name().unwrap().to_str().unwrap().to_owned();
    summary.figures.iter().map(|path| (name(path), std::fs::read_to_string(path).unwrap())).collect()
}

fn text_of(node: Node) -> String {
    node.descendants().filter(Node::is_text).filter_map(|n| n.text()).collect()
}

/// Well-formed, labelled, finite, without references.
fn check(name: &str, svg: &str) {
    let document = Document::parse(svg).unwrap_or_else(|error| panic!("{name}: {error}"));
    assert_eq!(document.root_element().tag_name().name(), "svg");
    for bad in ["NaN", "inf", "href", "url(", "<script"] {
        assert!(!svg.contains(bad), "{name} contains {bad}");
    }
    let axes: Vec<_> = document.descendants().filter(|n| n.attribute("class") == Some("axis")).collect();
    assert!(axes.len() >= 2 && axes.len() % 2 == 0, "{name}: {} axis labels", axes.len());
    for axis in axes {
        let label = text_of(axis);
        // Rungs have names, no unit.
        let unit = label == "rung" || label.ends_with(')') && label.contains('(');
        assert!(unit, "{name}: `{label}` names no unit");
    }
    for node in document.descendants() {
        assert!(node.attribute("id").is_none(), "{name}: an id could clash in the page");
        let size: Option<f64> = node.attribute("font-size").and_then(|s| s.parse().ok());
        assert!(size.is_none_or(|s| s >= 8.0), "{name}: too small to print");
    }
}

#[test]
fn figures_are_well_formed_labelled_and_complete() {
    let figures = drawn(|_| ());
    let names: Vec<&str> = figures.keys().map(String::as_str).collect();
    let expected = [
        "agreement.svg",
        "convergence.svg",
        "droplet-sizes.svg",
        "ladder.svg",
        "misfit.svg",
        "orders-theta-0.svg",
        "orders-theta-40.svg",
        "orders-theta-70.svg",
        "orders-theta-80.svg",
        "parameters.svg",
        "phase-functions.svg",
        "plane-media.svg",
        "plane-model.svg",
        "quadrature.svg",
        "solver-cost.svg",
    ];
    assert_eq!(names, expected);
    for (name, svg) in &figures {
        check(name, svg);
    }
    for (name, label) in [
        ("convergence.svg", "wall time (s)"),
        ("solver-cost.svg", "streams per hemisphere (number)"),
        ("quadrature.svg", "estimated error"),
        ("droplet-sizes.svg", "number density N(r) (cm−3 µm−1)"),
        ("misfit.svg", "misfit (per incident flux)"),
        ("orders-theta-0.svg", "thickness H (m)"),
        ("parameters.svg", "κc (1/m)"),
        ("plane-media.svg", "view angle θv (degrees)"),
        ("plane-model.svg", "πL/(μlF0) (1)"),
        ("phase-functions.svg", "scattering angle Θ (degrees)"),
    ] {
        let document = Document::parse(&figures[name]).unwrap();
        let found = document.descendants().any(|n| n.has_tag_name("text") && text_of(n) == label);
        assert!(found || figures[name].contains(label), "{name} lacks `{label}`");
    }
}

#[test]
fn every_monte_carlo_point_is_drawn_with_its_error() {
    let svg = &drawn(|_| ())["orders-theta-0.svg"];
    let document = Document::parse(svg).unwrap();
    let markers =
        document.descendants().filter(|n| n.attribute("transform").is_some() && n.has_tag_name("path"));
    let bars = document.descendants().filter(|n| n.attribute("class") == Some("error"));
    let legend = 6;
    assert_eq!(markers.count(), 20 * (5 + 4) + legend);
    assert_eq!(bars.count(), 20 * (5 + 4));
}

#[test]
fn figures_are_the_same_in_every_run() {
    assert_eq!(drawn(|_| ()), drawn(|_| ()));
}

#[test]
fn a_changed_number_changes_its_figure_and_no_other() {
    let before = drawn(|_| ());
    let after = drawn(|dir| {
        let path = dir.join("orders.csv");
        let mut rows: Vec<OrdersRow> = read_csv(&path).unwrap();
        let row = rows.iter_mut().find(|r| r.theta_l_deg == "70" && r.order == "1" && r.thickness_m > 30.0);
        row.unwrap().transmittance += 0.02;
        write_csv(&path, &rows).unwrap();
    });
    let changed: Vec<_> = before.keys().filter(|name| before[*name] != after[*name]).collect();
    assert_eq!(changed, ["orders-theta-70.svg"]);
}

#[test]
fn extreme_numbers_stay_drawable() {
    let figures = drawn(|dir| {
        let path = dir.join("curves.csv");
        let mut rows: Vec<CurvesRow> = read_csv(&path).unwrap();
        for (i, row) in rows.iter_mut().enumerate().filter(|(i, _)| i % 7 == 0) {
            row.value = if i % 2 == 0 { f64::MAX } else { f64::MIN };
        }
        write_csv(&path, &rows).unwrap();
        let path = dir.join("parameters.json");
        let mut document: ParametersDocument = read_json(&path).unwrap();
        let huge = FittedParameter { value: Some(f64::MAX), std_error: Some(f64::MAX), emitted: f64::MAX };
        document.metres.rows[1].c = huge;
        for row in &mut document.metres.rows {
            row.misfit.iter_mut().for_each(|m| (m.rms, m.max) = (0.0, f64::MAX));
        }
        write_json(&path, &document).unwrap();
        let path = dir.join("convergence.csv");
        let mut rows: Vec<ConvergenceRow> = read_csv(&path).unwrap();
        rows.iter_mut().for_each(|row| (row.seconds, row.error, row.std_error) = (0.0, 0.0, f64::MAX));
        write_csv(&path, &rows).unwrap();
        let path = dir.join("optics/optics.json");
        let mut optics: OpticsDocument = read_json(&path).unwrap();
        optics.size_density.number_per_cm3_um.fill(0.0);
        write_json(&path, &optics).unwrap();
    });
    figures.iter().for_each(|(name, svg)| check(name, svg));
}

#[test]
fn the_checks_reject_planted_faults() {
    let good = &drawn(|_| ())["misfit.svg"];
    let faulty = [
        good.replacen("</text>", "", 1),
        good.replacen("M", "MNaN ", 1),
        good.replacen("(per incident flux)", "", 1),
        good.replacen("<g ", "<g id=\"a\" ", 1),
    ];
    for svg in faulty {
        let caught = std::panic::catch_unwind(|| check("planted", &svg)).is_err();
        assert!(caught, "a planted fault went unnoticed");
    }
}
