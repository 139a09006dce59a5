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

/// One changed byte or line of any file, the binary one included, is found in that file and in no other.
#[test]
fn an_edit_of_any_file_is_named() {
    let files = stratiform_codegen::generate(&common::inputs(), &stratiform_codegen::Target::ALL).unwrap();
    let folder = tempfile::tempdir().unwrap();
    stratiform_codegen::write(&files, folder.path()).unwrap();
    assert!(files.names().any(|name| name.ends_with(".spv")));
    for (name, bytes) in files.iter() {
        let path = folder.path().join(name);
        let mut edited = bytes.to_vec();
        *edited.last_mut().unwrap() ^= 1;
        fs::write(&path, edited).unwrap();
        let stale = stratiform_codegen::check(&files, folder.path()).unwrap_err();
        assert_eq!(stale.iter().map(|s| s.file.as_str()).collect::<Vec<_>>(), [name]);
        fs::write(&path, bytes).unwrap();
    }
    assert_eq!(stratiform_codegen::check(&files, folder.path()), Ok(()));
}

/// The files of a target that is no longer asked for.
#[test]
fn the_files_of_a_removed_target_are_named() {
    use stratiform_codegen::Target;
    let folder = tempfile::tempdir().unwrap();
    let all = stratiform_codegen::generate(&common::inputs(), &Target::ALL).unwrap();
    stratiform_codegen::write(&all, folder.path()).unwrap();
    for removed in Target::ALL {
        let rest: Vec<_> = Target::ALL.into_iter().filter(|target| *target != removed).collect();
        let fewer = stratiform_codegen::generate(&common::inputs(), &rest).unwrap();
        let stale = stratiform_codegen::check(&fewer, folder.path()).unwrap_err();
        let extension = removed.extension().unwrap_or("spv");
        assert!(stale.iter().all(|s| s.file.ends_with(extension) && s.left_over));
        assert_eq!(stale.len(), all.names().len() - fewer.names().len());
    }
}

/// A place that is taken: the folder stays as it was.
#[test]
fn a_failed_write_leaves_nothing_half_written() {
    let files = stratiform_codegen::generate(&common::inputs(), &stratiform_codegen::Target::ALL).unwrap();
    let folder = tempfile::tempdir().unwrap();
    fs::create_dir(folder.path().join("stratiform.wgsl")).unwrap();
    fs::write(folder.path().join("stratiform.h"), "old").unwrap();
    let error = stratiform_codegen::write(&files, folder.path()).unwrap_err().to_string();
    assert!(error.contains("cannot write") && error.contains("stratiform.wgsl"), "{error}");
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 2);
    assert_eq!(fs::read_to_string(folder.path().join("stratiform.h")).unwrap(), "old");
}
