//! The shape of the project: which crate may see which, and how large files may grow.

#![allow(clippy::unwrap_used, reason = "a test may stop where it fails")]

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;
use stratiform_tests::{root, sources};

/// crate -> crates it may depend on. ARCHITECTURE.md draws the same table.
const ALLOWED: &[(&str, &[&str])] = &[
    ("quantities", &[]),
    ("stats", &[]),
    ("reference-data", &[]),
    ("artifact", &["quantities", "stats"]),
    ("optics", &["quantities", "artifact"]),
    ("tables", &["quantities", "artifact", "optics"]),
    ("transport", &["quantities", "stats", "optics"]),
    ("model", &["quantities"]),
    ("fit", &["quantities", "stats", "artifact", "model"]),
    ("codegen", &["quantities", "artifact", "model"]),
    ("methods", &["quantities", "stats", "artifact", "optics", "tables", "transport", "model"]),
    ("scene", &["quantities", "artifact"]),
    ("chart", &["quantities", "stats", "artifact", "optics", "transport", "model", "methods", "scene"]),
    ("advise", &["quantities", "artifact", "scene"]),
    ("gpu", &[]),
    ("gputrace", &["quantities", "stats", "transport", "gpu"]),
    ("imaging", &["quantities", "artifact"]),
    ("world", &["quantities", "artifact", "optics", "tables", "scene", "imaging"]),
    ("pathtrace", &["quantities", "stats", "optics", "imaging", "world"]),
    ("render", &["quantities", "artifact", "model", "optics", "gpu", "imaging", "world"]),
    ("viewer", &["gpu", "scene", "world", "render"]),
    ("report", &["quantities", "artifact"]),
    (
        "cli",
        &[
            "quantities",
            "gpu",
            "gputrace",
            "stats",
            "reference-data",
            "artifact",
            "optics",
            "tables",
            "transport",
            "model",
            "fit",
            "codegen",
            "methods",
            "scene",
            "chart",
            "advise",
            "imaging",
            "world",
            "pathtrace",
            "render",
            "viewer",
            "report",
        ],
    ),
    ("mpi", &["transport", "cli"]),
];

fn dependencies(manifest: &Path) -> BTreeSet<String> {
    let text = fs::read_to_string(manifest).unwrap();
    let table: toml::Table = text.parse().unwrap();
    let names = table.get("dependencies").and_then(|d| d.as_table()).into_iter().flat_map(|d| d.keys());
    names.filter_map(|name| name.strip_prefix("stratiform-")).map(str::to_owned).collect()
}

fn crates() -> Vec<String> {
    let mut names: Vec<_> = fs::read_dir(root().join("crates"))
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    names.sort();
    names
}

#[test]
fn crates_see_only_what_the_table_allows() {
    let allowed: BTreeMap<_, _> = ALLOWED.iter().copied().collect();
    for name in crates() {
        let may = allowed.get(name.as_str()).unwrap_or_else(|| panic!("crate {name} is not in the table"));
        for seen in dependencies(&root().join("crates").join(&name).join("Cargo.toml")) {
            assert!(may.contains(&seen.as_str()), "{name} may not depend on {seen}");
        }
    }
    assert_eq!(crates().len(), ALLOWED.len(), "the table lists a crate that does not exist");
}

#[test]
fn the_architecture_page_names_every_crate_and_stays_short() {
    let page = fs::read_to_string(root().join("ARCHITECTURE.md")).unwrap();
    for name in crates() {
        assert!(page.contains(&format!("`{name}`")), "ARCHITECTURE.md does not mention `{name}`");
    }
    assert!(page.lines().count() <= 200);
}

/// Paths that the pages name in backquotes lead somewhere.
#[test]
fn the_pages_name_only_files_that_exist() {
    let mut named = 0;
    for page in ["ARCHITECTURE.md", "CONTRIBUTING.md", "README.md"] {
        let text = fs::read_to_string(root().join(page)).unwrap();
        for word in text.split('`').skip(1).step_by(2) {
            let path = word.split_whitespace().next().unwrap_or_default();
            if ["crates/", "tests/", "scripts/", "fit-configs/"].iter().any(|folder| path.starts_with(folder))
            {
                assert!(root().join(path).exists(), "{page} names {path}");
                named += 1;
            }
        }
    }
    assert!(named > 5, "guard against checking nothing");
}

#[test]
fn files_stay_small() {
    let files = sources(&root());
    assert!(files.len() > 20, "guard against checking nothing");
    let mut lengths: Vec<_> =
        files.iter().map(|path| (fs::read_to_string(path).unwrap().lines().count(), path)).collect();
    lengths.sort();
    let (longest, path) = lengths[lengths.len() - 1];
    assert!(longest <= 600, "{} has {longest} lines", path.display());
    let (median, _) = lengths[lengths.len() / 2];
    assert!(median <= 200, "the median file has {median} lines");
}

#[test]
fn the_project_stands_alone() {
    let files = sources(&root());
    for path in files.iter().filter(|path| !path.ends_with("tests/architecture.rs")) {
        let text = fs::read_to_string(path).unwrap();
        assert!(!text.contains("../shared"), "{} refers to a folder outside the project", path.display());
    }
}
