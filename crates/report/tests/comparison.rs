//! The page of a comparison: everything in one file, and what cannot be is refused with its file and line.

#![allow(clippy::unwrap_used, reason = "tests")]

use std::fs;
use std::path::Path;
use stratiform_artifact::{
    AblationRow, ComparisonDocument, ComparisonPicture, ComparisonRow, Provenance, RenderCostRow, write_csv,
    write_json,
};
use stratiform_report::{build_comparison, draw_costs};

fn row(contribution: &str, band: &str) -> ComparisonRow {
    ComparisonRow {
        scene: "thin-veil".to_owned(),
        model: "fitted".to_owned(),
        contribution: contribution.to_owned(),
        band: band.to_owned(),
        pixels: 576,
        mean_truth: 0.1,
        mean_picture: 0.101,
        bias: 0.001,
        bias_error: 0.0001,
        floor: 0.001,
        median: 0.0123,
        p95: 0.04,
        worst: 0.5,
        noise_median: 0.01,
        rms: 0.003,
        noise: 0.001,
        excess_rms: 0.0028,
        share: 0.028,
        beyond_3_sigma: 0.1,
        flip: (band == "luminance").then_some(0.0456),
    }
}

fn cost(width: u64, passes: Option<u64>, pass: &str, ms: f64) -> RenderCostRow {
    RenderCostRow {
        scene: "thin-veil".to_owned(),
        adapter: "llvmpipe".to_owned(),
        width,
        height: width / 2,
        model: "fitted".to_owned(),
        radiosity_side: 16,
        radiosity_passes: passes,
        pass: pass.to_owned(),
        ms,
    }
}

fn costs() -> Vec<RenderCostRow> {
    let sizes =
        [160, 320, 640].into_iter().flat_map(|width| [Some(0), Some(2), None].map(|passes| (width, passes)));
    sizes
        .flat_map(|(width, passes)| {
            let exchange = passes.unwrap_or(3) as f64;
            [
                cost(width, passes, "shade", width as f64 * 0.01),
                cost(width, passes, "radiosity", 0.1 * exchange),
            ]
        })
        .collect()
}

fn write(dir: &Path) {
    let picture = |kind: &str| ComparisonPicture {
        model: "fitted".to_owned(),
        contribution: "all".to_owned(),
        kind: kind.to_owned(),
        file: format!("all-fitted-{kind}.svg"),
    };
    let document = ComparisonDocument {
        schema: ComparisonDocument::SCHEMA.to_owned(),
        provenance: Provenance::new("blake3:0".to_owned(), Some(1), "path tracing; standard errors"),
        scene: "thin-veil".to_owned(),
        title: "A thin veil".to_owned(),
        width: 32,
        height: 18,
        exposure_ev: 0.5,
        pixels_per_degree: 67.0,
        floor_share: 0.01,
        truth: "64 paths a pixel".to_owned(),
        adapter: "llvmpipe".to_owned(),
        pictures: ["picture", "difference"].map(picture).to_vec(),
    };
    for picture in &document.pictures {
        fs::write(
            dir.join(&picture.file),
            format!("<svg viewBox=\"0 0 1 1\"><title>{}</title></svg>\n", picture.kind),
        )
        .unwrap();
    }
    write_json(&dir.join("comparison.json"), &document).unwrap();
    let rows = ["all", "halo"].iter().flat_map(|part| ["luminance", "red"].map(|band| row(part, band)));
    write_csv(&dir.join("comparison.csv"), &rows.collect::<Vec<_>>()).unwrap();
    let changed = |change: &str, rise: f64| AblationRow {
        scene: "thin-veil".to_owned(),
        change: change.to_owned(),
        error: 0.03 + rise,
        noise: 0.01,
        rise,
        difference: 0.02,
        flip: 0.05,
        width: 128,
        height: 72,
        ms: None,
        ms_saved: None,
    };
    write_csv(&dir.join("ablation.csv"), &[changed("nothing", 0.0), changed("without halo", -0.001)])
        .unwrap();
    write_csv(&dir.join("render-costs.csv"), &costs()).unwrap();
}

#[test]
fn the_page_holds_pictures_numbers_and_figures() {
    let dir = tempfile::tempdir().unwrap();
    write(dir.path());
    let page = fs::read_to_string(build_comparison(dir.path()).unwrap()).unwrap();
    for needed in
        ["<title>difference</title>", "0.0456", "2.80", "without halo", "−0.10", "Cost of a frame", "seed 1"]
    {
        assert!(page.contains(needed), "{needed}");
    }
    for outside in ["src=", "href=\"http", "<link"] {
        assert!(!page.contains(outside), "{outside}");
    }
    assert!(dir.path().join("render-costs.svg").exists());
    let again = fs::read_to_string(build_comparison(dir.path()).unwrap()).unwrap();
    assert_eq!(page, again);
}

#[test]
fn costs_are_sums_over_passes() {
    let [(name, svg)] = &draw_costs(&costs())[..] else { panic!("one scene, one device") };
    assert_eq!(name, "render-costs.svg");
    let svg = roxmltree::Document::parse(svg).unwrap();
    let texts: Vec<_> = svg.descendants().filter_map(|node| node.text()).collect();
    assert!(texts.iter().any(|text| text.contains("fitted, 2 passes")), "{texts:?}");
}

#[test]
fn what_cannot_be_is_refused_by_name() {
    let refused = |change: &dyn Fn(&Path), named: &str| {
        let dir = tempfile::tempdir().unwrap();
        write(dir.path());
        change(dir.path());
        let error = build_comparison(dir.path()).expect_err(named).to_string();
        assert!(error.contains(named), "{error}");
        assert!(!dir.path().join("comparison.html").exists());
    };
    refused(&|dir| fs::remove_file(dir.join("comparison.csv")).unwrap(), "comparison.csv");
    refused(
        &|dir| fs::remove_file(dir.join("all-fitted-difference.svg")).unwrap(),
        "all-fitted-difference.svg",
    );
    refused(
        &|dir| fs::write(dir.join("all-fitted-picture.svg"), "<svg ><script/></svg>").unwrap(),
        "without script",
    );
    let negative = |dir: &Path| {
        let text = fs::read_to_string(dir.join("comparison.csv")).unwrap();
        fs::write(dir.join("comparison.csv"), text.replacen("0.0123", "-0.5", 1)).unwrap();
    };
    refused(&negative, "comparison.csv:2: median = -0.5");
    let outside = |dir: &Path| {
        let text = fs::read_to_string(dir.join("comparison.json")).unwrap();
        fs::write(dir.join("comparison.json"), text.replacen("all-fitted", "../all-fitted", 1)).unwrap();
    };
    refused(&outside, "lies in the folder itself");
}
