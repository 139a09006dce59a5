//! Every published figure has a source, is what was transcribed, and is read through the one loader.

#![allow(clippy::unwrap_used, reason = "a test may stop where it fails")]

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use stratiform_reference_data::{ReferenceError, Source, read_in, sha256};
use stratiform_tests::{root, sources};

/// What is wrong with `root/name`; empty if nothing is.
fn faults(root: &Path, name: &str) -> Vec<String> {
    let source = match Source::load(root, name) {
        Ok(source) => source,
        Err(error) => return vec![error.to_string()],
    };
    let unreadable = source.files.keys().filter_map(|file| match source.read(file) {
        Ok(_) => None,
        Err(error) => Some(error.to_string()),
    });
    let present: BTreeSet<_> = fs::read_dir(root.join(name))
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    let unlisted = present.iter().filter(|file| *file != "SOURCE.toml" && !source.files.contains_key(*file));
    unreadable.chain(unlisted.map(|file| format!("{file} has no hash in SOURCE.toml"))).collect()
}

#[test]
fn every_folder_has_a_source_and_matches_its_hashes() {
    let root = stratiform_reference_data::root();
    let folders: Vec<_> = fs::read_dir(&root).unwrap().map(Result::unwrap).collect();
    assert!(folders.len() >= 5, "guard against checking nothing");
    for folder in folders {
        let name = folder.file_name().into_string().unwrap();
        assert_eq!(faults(&root, &name), Vec::<String>::new(), "{name}");
    }
}

#[test]
fn a_changed_file_and_a_file_without_hash_are_found() {
    let root = tempfile::tempdir().unwrap();
    let write = |name: &str, text: &str| fs::write(root.path().join("s").join(name), text).unwrap();
    fs::create_dir(root.path().join("s")).unwrap();
    assert_eq!(faults(root.path(), "s").len(), 1);
    let hash = sha256(b"1,2\n");
    write("a.csv", "1,2\n");
    write(
        "SOURCE.toml",
        &format!(
            "title = 't'\ncitation = 'c'\norigin = 'o'\nlicence = 'l'\ndigits = 'all'\n[files]\n'a.csv' = '{hash}'\n"
        ),
    );
    assert_eq!(faults(root.path(), "s"), Vec::<String>::new());
    write("a.csv", "1,3\n");
    write("b.csv", "");
    assert_eq!(faults(root.path(), "s").len(), 2);
    assert!(matches!(read_in(root.path(), "s", "a.csv"), Err(ReferenceError::Hash { .. })));
}

/// Tables that a library carries, so that the program needs no folder. A unit test beside each compares it with the loader's.
const BUILT_IN: [&str; 4] = [
    "crates/optics/src/water.rs",
    "crates/cli/src/pipeline/published.rs",
    "crates/methods/src/rivals/bouthors/tables.rs",
    "crates/tables/src/colour/observer.rs",
];

/// The loader, and the tests of the folder and of this rule.
const LOADER: [&str; 3] =
    ["crates/reference-data/src/lib.rs", "tests/tests/reference_data.rs", "tests/tests/architecture.rs"];

/// Lines of code that lead into `reference-data/` past the loader.
fn spelled_paths(file: &str, text: &str) -> Vec<String> {
    let built_in = |line: &str| BUILT_IN.contains(&file) && line.contains("include_str!");
    let code = text.lines().filter(|line| !line.trim_start().starts_with("//"));
    code.filter(|line| line.contains("reference-data") && !built_in(line)).map(str::to_owned).collect()
}

#[test]
fn only_the_loader_spells_a_path_into_the_folder() {
    let files: Vec<PathBuf> =
        sources(&root()).into_iter().filter(|p| p.extension().unwrap() == "rs").collect();
    assert!(files.len() > 20, "guard against checking nothing");
    for path in files {
        let name = path.strip_prefix(root()).unwrap().to_str().unwrap().replace('\\', "/");
        if !LOADER.contains(&name.as_str()) {
            let found = spelled_paths(&name, &fs::read_to_string(&path).unwrap());
            assert_eq!(found, Vec::<String>::new(), "{name} opens reference data past the loader");
        }
    }
    for name in BUILT_IN {
        let text = fs::read_to_string(root().join(name)).unwrap();
        assert!(text.contains("stratiform_reference_data::read("), "{name} does not check what it carries");
    }
}

#[test]
fn a_path_past_the_loader_is_found() {
    let line = "let file = root().join(\"reference-data/s/a.csv\");";
    assert_eq!(spelled_paths("crates/model/tests/x.rs", line).len(), 1);
    let carried = "const A: &str = include_str!(\"../../../reference-data/s/a.csv\");";
    assert_eq!(spelled_paths("crates/model/src/x.rs", carried).len(), 1);
    assert_eq!(spelled_paths(BUILT_IN[0], carried).len(), 0);
    assert_eq!(
        spelled_paths("crates/model/src/x.rs", "// see reference-data/s\nuse stratiform_reference_data;")
            .len(),
        0
    );
}
