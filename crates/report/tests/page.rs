//! The page: complete, self-contained, safe with hostile text, and honest about what it lacks.

#![allow(clippy::unwrap_used, reason = "tests")]

mod folder;

use std::path::Path;
use stratiform_artifact::{
    ConvergenceRow, NotesDocument, OpticsDocument, ParametersDocument, read_csv, read_json, write_csv,
    write_json,
};
use stratiform_report::{LeftOut, build};

fn page(change: impl FnOnce(&Path)) -> (String, Vec<LeftOut>) {
    let dir = tempfile::tempdir().unwrap();
    folder::write(dir.path());
    change(dir.path());
    let summary = build(dir.path()).unwrap();
    (std::fs::read_to_string(summary.page).unwrap(), summary.left_out)
}

/// The values of the attribute `name`.
fn attributes<'a>(page: &'a str, name: &str) -> Vec<&'a str> {
    let opening = format!(" {name}=\"");
    page.split(&opening).skip(1).filter_map(|rest| rest.split('"').next()).collect()
}

/// Whether the page fetches or runs nothing.
fn self_contained(page: &str) -> bool {
    let lower = page.to_lowercase();
    let forbidden =
        ["<script", "<link", "<iframe", "<object", "<img", "<use", "@import", "url(", " src=", "javascript:"];
    let links_stay = attributes(page, "href").iter().all(|target| target.starts_with('#'));
    let addresses = lower.replace("xmlns=\"http://www.w3.org/2000/svg\"", "");
    forbidden.iter().all(|word| !lower.contains(word)) && links_stay && !addresses.contains("http")
}

#[test]
fn the_page_is_self_contained() {
    let (page, left_out) = page(|_| ());
    assert!(left_out.is_empty());
    assert!(self_contained(&page));
    assert!(
        page.starts_with("<!DOCTYPE html>") && page.contains("@media print") && page.contains("viewport")
    );
    let ids = attributes(&page, "id");
    for target in attributes(&page, "href") {
        assert!(ids.contains(&&target[1..]), "{target} leads nowhere");
    }
    let mut unique = ids.clone();
    unique.sort_unstable();
    unique.dedup();
    assert_eq!(unique.len(), ids.len(), "ids clash");
}

#[test]
fn the_check_for_references_rejects_planted_ones() {
    let (page, _) = page(|_| ());
    for planted in [
        "<img src=\"a.png\">",
        "<a href=\"https://example.org\">x</a>",
        "<script>x</script>",
        "<style>@import 'a.css'</style>",
    ] {
        assert!(!self_contained(&page.replace("</main>", &format!("{planted}</main>"))), "{planted}");
    }
}

#[test]
fn the_page_shows_fitted_beside_published_and_explains() {
    let (page, _) = page(|_| ());
    for expected in [
        "1.1630<br><small>± 0.0023</small></td><td class=\"published\">1.1796",
        "– (0.0155)",
        "the data do not determine c",
        "00112233445566778899aabbccddeeff",
        "0.55 µm",
        "<strong>paper</strong>",
        "51.0 %",
        "45.5 %",
        "4.1 %",
        "1.090",
        "0.501",
        "−0.00090 ± 0.00021",
        "0.99612 ± 0.00013",
        "relative reduction below 1e-12 after 9 iterations",
        "<details>",
    ] {
        assert!(page.contains(expected), "the page lacks `{expected}`");
    }
    assert!(!page.contains("NaN"));
}

#[test]
fn the_page_is_the_same_in_every_run() {
    assert_eq!(page(|_| ()), page(|_| ()));
}

#[test]
fn building_again_replaces_the_report() {
    let dir = tempfile::tempdir().unwrap();
    folder::write(dir.path());
    let first = build(dir.path()).unwrap();
    let text = std::fs::read(&first.page).unwrap();
    std::fs::write(&first.page, "old").unwrap();
    assert_eq!(build(dir.path()).unwrap(), first);
    assert_eq!(std::fs::read(&first.page).unwrap(), text);
}

const OPTIONAL: [&str; 11] = [
    "optics/sphere.csv",
    "agreement.json",
    "ladder.csv",
    "convergence.csv",
    "solver_cost.csv",
    "figures/principal-plane.csv",
    "optics/quadrature.csv",
    "angular-books.csv",
    "published.csv",
    "curves.csv",
    "notes.json",
];

/// A disagreement stands in the page as an alarm, agreement as a plain sentence; a rung that was not measured says so.
#[test]
fn disagreement_and_absent_rungs_are_loud() {
    let (calm, _) = page(|_| ());
    assert!(calm.contains("All 21 parameters agree.") && !calm.contains("class=\"alarm\""));
    assert!(calm.contains("<strong>not measured: no adapter</strong>"));
    let (loud, _) = page(|dir| {
        let mut rows = folder::agreement();
        (rows[1].z, rows[1].differs) = (Some(9.0), true);
        write_csv(&dir.join("agreement.csv"), &rows).unwrap();
        write_json(&dir.join("agreement.json"), &folder::verdict(&rows)).unwrap();
    });
    assert!(loud.contains("class=\"alarm\"") && loud.contains("disagree in 1 of 21 parameters"));
}

#[test]
fn optional_files_may_be_absent_and_the_page_says_so() {
    for file in OPTIONAL {
        let (page, left_out) = page(|dir| std::fs::remove_file(dir.join(file)).unwrap());
        assert_eq!(left_out.iter().map(|item| item.file).collect::<Vec<_>>(), [file]);
        assert!(page.contains(&format!("no file <code>{file}</code>")), "{file}");
    }
    let (page, left_out) =
        page(|dir| OPTIONAL.iter().for_each(|f| std::fs::remove_file(dir.join(f)).unwrap()));
    assert_eq!(left_out.len(), OPTIONAL.len());
    assert!(!page.contains("class=\"published\""));
}

#[test]
fn hostile_text_is_escaped() {
    const HOSTILE: &str = "<script>alert(1)</script>\"'&<b onload=x>]]>--><!--";
    let (page, _) = page(|dir| {
        let path = dir.join("optics/optics.json");
        let mut optics: OpticsDocument = read_json(&path).unwrap();
        optics.droplets = HOSTILE.to_owned();
        optics.provenance.method = HOSTILE.to_owned();
        write_json(&path, &optics).unwrap();
        let path = dir.join("parameters.json");
        let mut parameters: ParametersDocument = read_json(&path).unwrap();
        parameters.metres.rows[0].stopped_orders = HOSTILE.to_owned();
        parameters.metres.rows[0].misfit[0].quantity = HOSTILE.to_owned();
        write_json(&path, &parameters).unwrap();
        let path = dir.join("notes.json");
        let mut notes: NotesDocument = read_json(&path).unwrap();
        notes.published_source = HOSTILE.to_owned();
        write_json(&path, &notes).unwrap();
        let path = dir.join("convergence.csv");
        let mut rows: Vec<ConvergenceRow> = read_csv(&path).unwrap();
        rows[0].estimator = HOSTILE.to_owned();
        write_csv(&path, &rows).unwrap();
        let summary = build(dir).unwrap();
        for figure in summary.figures {
            let svg = std::fs::read_to_string(&figure).unwrap();
            roxmltree::Document::parse(&svg).unwrap_or_else(|error| panic!("{}: {error}", figure.display()));
        }
    });
    assert!(self_contained(&page));
    assert!(!page.contains("<b onload") && page.contains("&lt;script&gt;alert(1)"));
}
