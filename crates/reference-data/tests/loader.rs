//! The loader hands out what was transcribed, and nothing else.

#![allow(clippy::unwrap_used, reason = "a test may stop where it fails")]

use std::fs;
use std::path::Path;
use stratiform_reference_data::{ReferenceError, read_in, rows, rows_in, sha256};
use tempfile::TempDir;

const TABLE: &str = "# a comment\nx,y\n1,2.5\n-3,4e2\n";

fn source_toml(title: &str, file: &str, hash: &str) -> String {
    format!(
        "title = '{title}'\ncitation = 'c'\norigin = 'o'\nlicence = 'l'\ndigits = 'all'\n[files]\n'{file}' = '{hash}'\n"
    )
}

/// A root with one source `s`, its `SOURCE.toml` and `a.csv`.
fn root(source: &str, table: &[u8]) -> TempDir {
    let root = tempfile::tempdir().unwrap();
    fs::create_dir(root.path().join("s")).unwrap();
    fs::write(root.path().join("s/SOURCE.toml"), source).unwrap();
    fs::write(root.path().join("s/a.csv"), table).unwrap();
    root
}

fn good() -> TempDir {
    root(&source_toml("t", "a.csv", &sha256(TABLE.as_bytes())), TABLE.as_bytes())
}

/// The empty message's digest (FIPS 180-4 examples) and that of "abc".
#[test]
fn the_hash_is_sha_256() {
    assert_eq!(sha256(b""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    assert_eq!(sha256(b"abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

#[test]
fn a_listed_file_is_read_as_text_and_as_rows() {
    let root = good();
    assert_eq!(read_in(root.path(), "s", "a.csv").unwrap(), TABLE);
    assert_eq!(rows_in::<(i32, f64)>(root.path(), "s", "a.csv").unwrap(), vec![(1, 2.5), (-3, 400.0)]);
    assert_eq!(rows_in::<Vec<String>>(root.path(), "s", "a.csv").unwrap()[1], ["-3", "4e2"]);
}

#[test]
fn one_changed_byte_is_refused_with_both_hashes() {
    let root = good();
    let changed = TABLE.replace("2.5", "2.6");
    fs::write(root.path().join("s/a.csv"), &changed).unwrap();
    let error = read_in(root.path(), "s", "a.csv").unwrap_err();
    let message = error.to_string();
    assert!(matches!(error, ReferenceError::Hash { .. }), "{message}");
    assert!(message.contains(&sha256(TABLE.as_bytes())) && message.contains(&sha256(changed.as_bytes())));
}

#[test]
fn what_is_not_listed_is_refused_even_if_it_is_there() {
    let root = good();
    fs::write(root.path().join("s/b.csv"), TABLE).unwrap();
    for file in ["b.csv", "SOURCE.toml", "../s/a.csv", "", "A.csv"] {
        let error = read_in(root.path(), "s", file).unwrap_err();
        assert!(matches!(error, ReferenceError::NotListed { .. }), "{file}: {error}");
    }
}

fn refusal(root: &Path) -> ReferenceError {
    read_in(root, "s", "a.csv").unwrap_err()
}

#[test]
fn a_source_that_says_nothing_is_refused() {
    let hash = sha256(TABLE.as_bytes());
    let whole = source_toml("t", "a.csv", &hash);
    for (text, part) in [
        (source_toml(" ", "a.csv", &hash), "title is empty"),
        (whole.replace("licence = 'l'\n", ""), "licence"),
        (whole.replace("digits", "digit"), "digit"),
        (whole.replace("[files]", ""), "a.csv"),
    ] {
        let error = refusal(root(&text, TABLE.as_bytes()).path());
        assert!(matches!(error, ReferenceError::Source { .. }), "{error}");
        assert!(error.to_string().contains(part), "{error}");
    }
}

#[test]
fn missing_files_and_what_is_no_table_are_refused() {
    let nowhere = tempfile::tempdir().unwrap();
    assert!(matches!(refusal(nowhere.path()), ReferenceError::Read { .. }));
    let gone = good();
    fs::remove_file(gone.path().join("s/a.csv")).unwrap();
    assert!(matches!(refusal(gone.path()), ReferenceError::Read { .. }));
    let binary = [0xff, 0xfe];
    let root = root(&source_toml("t", "a.csv", &sha256(&binary)), &binary);
    assert!(matches!(refusal(root.path()), ReferenceError::NotText { .. }));
    let error = rows_in::<(u32, f64)>(good().path(), "s", "a.csv").unwrap_err();
    assert!(matches!(error, ReferenceError::Row { .. }) && error.to_string().contains("line: 4"), "{error}");
}

#[test]
fn the_workspaces_own_folder_is_found() {
    let table: Vec<Vec<f64>> = rows("bouthors-2006", "appendix-b.csv").unwrap();
    assert_eq!(table.len(), 10);
    assert_eq!(table[0], [0.0, 1.1796, 0.0138, 0.0265, 0.8389, 0.0547]);
}
