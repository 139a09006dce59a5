//! Figures and page of a made-up chart.

#![allow(clippy::unwrap_used, reason = "a test may stop where it fails")]

use std::path::Path;
use stratiform_artifact::{
    ChartDocument, ChartMethod, ChartRow, ChartScene, KnobRow, Provenance, write_csv, write_json,
};
use stratiform_report::build_chart;

fn row(method: &str, quantity: &str, ns: f64, median: f64, pareto: bool) -> ChartRow {
    ChartRow {
        scene: "a-scene".to_owned(),
        method: method.to_owned(),
        knob: None,
        class: "mixed".to_owned(),
        quantity: quantity.to_owned(),
        points: 10,
        excluded: 0,
        refused: 0,
        not_finite: 0,
        median: Some(median),
        p95: Some(2.0 * median),
        worst: Some(3.0 * median),
        bias: Some(-median),
        cost: "f32".to_owned(),
        ns_per_evaluation: Some(ns),
        table_bytes: Some(64),
        pareto,
    }
}

fn folder(rows: &[ChartRow], title: &str) -> tempfile::TempDir {
    let dir = tempfile::tempdir().unwrap();
    let method = |name: &str| ChartMethod {
        name: name.to_owned(),
        title: title.to_owned(),
        source: "a paper".to_owned(),
        class: "mixed".to_owned(),
    };
    let manifest = ChartDocument {
        schema: ChartDocument::SCHEMA.to_owned(),
        provenance: Provenance::new("00".to_owned(), None, "made up"),
        quick: true,
        largest_truth_error: 0.01,
        scenes: vec![ChartScene {
            name: "a-scene".to_owned(),
            title: "A scene".to_owned(),
            hash: "00".to_owned(),
            clouds: Vec::new(),
        }],
        methods: ["quick", "good"].map(method).into(),
    };
    write_json(&dir.path().join("manifest.json"), &manifest).unwrap();
    write_csv(&dir.path().join("chart.csv"), rows).unwrap();
    dir
}

fn rows() -> Vec<ChartRow> {
    vec![
        row("quick", "radiance_top", 5.0, 0.3, true),
        row("good", "radiance_top", 50.0, 0.05, true),
        row("quick", "reflectance", 5.0, 0.2, true),
        row("good", "reflectance", 50.0, 0.0, true),
    ]
}

fn knob(setting: f64) -> KnobRow {
    KnobRow {
        scene: "a-scene".to_owned(),
        method: "quick".to_owned(),
        knob: "orders".to_owned(),
        setting,
        quantity: "radiance_top".to_owned(),
        points: 10,
        refused: 0,
        median: Some(1.0 / setting),
        p95: Some(1.0),
        worst: Some(1.0),
        ns_per_evaluation: Some(setting),
        table_bytes: None,
    }
}

fn read(dir: &Path, name: &str) -> String {
    std::fs::read_to_string(dir.join(name)).unwrap()
}

#[test]
fn every_scene_and_knob_has_a_figure_with_its_methods() {
    let dir = folder(&rows(), "A method");
    write_csv(&dir.path().join("knobs.csv"), &[knob(1.0), knob(2.0)]).unwrap();
    let summary = build_chart(dir.path()).unwrap();
    assert_eq!(summary.figures.len(), 3);
    for path in &summary.figures {
        roxmltree::Document::parse(&std::fs::read_to_string(path).unwrap()).unwrap();
    }
    let svg = read(dir.path(), "chart-a-scene.svg");
    assert!(svg.contains(">quick<") && svg.contains(">good<") && !svg.contains("NaN"), "{svg}");
    assert_eq!(
        svg.matches("stroke-dasharray=\"2 3\"").count(),
        3,
        "the front in two panels and the legend: {svg}"
    );
    assert!(read(dir.path(), "knob-quick-orders.svg").contains("orders"));
    let shaders = read(dir.path(), "shaders-a-scene.svg");
    assert!(shaders.contains("Radiance above") && !shaders.contains("Reflectance"), "{shaders}");
}

#[test]
fn the_page_stands_alone_and_switches_every_method() {
    let dir = folder(&rows(), "</script><b>");
    let page = read(build_chart(dir.path()).unwrap().page.parent().unwrap(), "chart.html");
    for outside in ["http://", "src=", "@import", "url(", "fetch("] {
        let there = page.replace("http://www.w3.org/2000/svg", "");
        assert!(!there.contains(outside), "{outside}");
    }
    assert_eq!(page.matches("data-method=").count(), 2);
    assert_eq!(page.matches("</script>").count(), 2);
    let data = page.split_once("id=\"data\">").unwrap().1.split_once("</script>").unwrap().0;
    assert!(data.contains("\"ns_per_evaluation\": 50.0") && data.contains("\"knob\": null"));
}

#[test]
fn impossible_numbers_and_missing_files_are_refused_by_name() {
    let mut bad = rows();
    bad[1].ns_per_evaluation = Some(-1.0);
    let dir = folder(&bad, "A method");
    let message = build_chart(dir.path()).unwrap_err().to_string();
    assert!(message.contains("chart.csv:3: ns_per_evaluation = -1 is outside"), "{message}");
    assert!(!dir.path().join("chart.html").exists());
    std::fs::remove_file(dir.path().join("manifest.json")).unwrap();
    assert!(build_chart(dir.path()).unwrap_err().to_string().contains("manifest.json"));
}
