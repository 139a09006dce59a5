//! `check` accepts what `write` wrote and nothing else.
#![allow(clippy::unwrap_used, reason = "a test may stop where it fails")]

mod common;

use std::fs;

#[test]
fn fresh_files_pass_and_changed_or_missing_ones_are_named() {
    let files = stratiform_codegen::generate(&common::inputs(), &stratiform_codegen::Target::ALL).unwrap();
    let folder = tempfile::tempdir().unwrap();
    stratiform_codegen::write(&files, folder.path()).unwrap();
    assert_eq!(stratiform_codegen::check(&files, folder.path()), Ok(()));

    let shader = folder.path().join("stratiform.wgsl");
    let edited = files.text("stratiform.wgsl").unwrap().replacen("0.84", "0.85", 1);
    assert_ne!(edited, files.text("stratiform.wgsl").unwrap());
    fs::write(&shader, edited).unwrap();
    fs::remove_file(folder.path().join("parameters.csv")).unwrap();
    let stale = stratiform_codegen::check(&files, folder.path()).unwrap_err();
    let [missing, changed] = &stale[..] else { panic!("{stale:?}") };
    assert_eq!((missing.file.as_str(), changed.file.as_str()), ("parameters.csv", "stratiform.wgsl"));
    assert!(missing.diff.starts_with("it is missing"), "{missing}");
    let lines: Vec<_> = changed.diff.lines().collect();
    assert!(
        matches!(lines[..], [place, old, new]
        if place.starts_with("@@ line ") && old.starts_with('-') && new.starts_with('+')),
        "{changed}"
    );
    assert!(changed.to_string().contains("stratiform codegen"));
}

#[test]
fn a_file_that_is_not_generated_is_named() {
    let files = stratiform_codegen::generate(&common::inputs(), &stratiform_codegen::Target::ALL).unwrap();
    let folder = tempfile::tempdir().unwrap();
    stratiform_codegen::write(&files, folder.path()).unwrap();
    fs::write(folder.path().join("old.wgsl"), "").unwrap();
    let stale = stratiform_codegen::check(&files, folder.path()).unwrap_err();
    let [left_over] = &stale[..] else { panic!("{stale:?}") };
    assert_eq!(left_over.file, "old.wgsl");
}

#[test]
fn a_changed_parameter_makes_the_shader_and_its_self_test_stale() {
    let mut inputs = common::inputs();
    let folder = tempfile::tempdir().unwrap();
    stratiform_codegen::write(
        &stratiform_codegen::generate(&inputs, &stratiform_codegen::Target::ALL).unwrap(),
        folder.path(),
    )
    .unwrap();
    inputs.parameters.optical.rows[3].t.emitted *= 1.02;
    let files = stratiform_codegen::generate(&inputs, &stratiform_codegen::Target::ALL).unwrap();
    let stale: Vec<_> =
        stratiform_codegen::check(&files, folder.path()).unwrap_err().into_iter().map(|s| s.file).collect();
    for name in ["parameters.json", "self_test.json", "stratiform.wgsl"] {
        assert!(stale.iter().any(|file| file == name), "{name} in {stale:?}");
    }
    assert!(!stale.iter().any(|file| file.ends_with(".csv")), "{stale:?}");
}
