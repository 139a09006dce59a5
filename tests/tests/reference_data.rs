//! Every published figure has a source, and is what was transcribed.

#![allow(clippy::unwrap_used, reason = "a test may stop where it fails")]

use sha2::{Digest, Sha256};
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;
use stratiform_tests::root;

#[derive(serde::Deserialize)]
#[serde(deny_unknown_fields)]
struct Source {
    title: String,
    citation: String,
    origin: String,
    licence: String,
    digits: String,
    files: BTreeMap<String, String>,
}

fn sha256(bytes: &[u8]) -> String {
    Sha256::digest(bytes).iter().map(|byte| format!("{byte:02x}")).collect()
}

/// What is wrong with a folder of reference data; empty if nothing is.
fn faults(folder: &Path) -> Vec<String> {
    let text = match fs::read_to_string(folder.join("SOURCE.toml")) {
        Ok(text) => text,
        Err(error) => return vec![format!("SOURCE.toml: {error}")],
    };
    let source: Source = match toml::from_str(&text) {
        Ok(source) => source,
        Err(error) => return vec![format!("SOURCE.toml: {error}")],
    };
    let mut faults: Vec<String> =
        [&source.title, &source.citation, &source.origin, &source.licence, &source.digits]
            .iter()
            .filter(|field| field.trim().is_empty())
            .map(|_| "SOURCE.toml has an empty field".to_owned())
            .collect();
    let present: BTreeSet<_> =
        fs::read_dir(folder).unwrap().map(|e| e.unwrap().file_name().into_string().unwrap()).collect();
    faults.extend(
        present
            .iter()
            .filter(|name| *name != "SOURCE.toml" && !source.files.contains_key(*name))
            .map(|name| format!("{name} has no hash in SOURCE.toml")),
    );
    for (name, hash) in &source.files {
        match fs::read(folder.join(name)) {
            Ok(bytes) if sha256(&bytes) == *hash => {}
            Ok(bytes) => faults.push(format!("{name} has SHA-256 {}, not {hash}", sha256(&bytes))),
            Err(error) => faults.push(format!("{name}: {error}")),
        }
    }
    faults
}

#[test]
fn every_folder_has_a_source_and_matches_its_hashes() {
    let folders: Vec<_> =
        fs::read_dir(root().join("reference-data")).unwrap().map(|entry| entry.unwrap().path()).collect();
    assert!(folders.len() >= 5, "guard against checking nothing");
    for folder in folders {
        assert_eq!(faults(&folder), Vec::<String>::new(), "{}", folder.display());
    }
}

#[test]
fn a_changed_file_and_a_file_without_hash_are_found() {
    let folder = tempfile::tempdir().unwrap();
    let write = |name: &str, text: &str| fs::write(folder.path().join(name), text).unwrap();
    assert_eq!(faults(folder.path()).len(), 1);
    let hash = sha256(b"1,2\n");
    write("a.csv", "1,2\n");
    write(
        "SOURCE.toml",
        &format!(
            "title = 't'\ncitation = 'c'\norigin = 'o'\nlicence = 'l'\ndigits = 'all'\n[files]\n'a.csv' = '{hash}'\n"
        ),
    );
    assert_eq!(faults(folder.path()), Vec::<String>::new());
    write("a.csv", "1,3\n");
    write("b.csv", "");
    assert_eq!(faults(folder.path()).len(), 2);
}
