//! `stratiform advise`: answers, exit codes, the config it writes.

#![allow(clippy::unwrap_used, reason = "a test may stop where it fails")]

mod common;

use common::run;
use std::fs;
use std::path::Path;
use stratiform_advise::Advice;
use stratiform_cli::config::Config;
use stratiform_scene::{NAMES, PICTURES};

fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}

/// Every named scene has an answer within a large cost, in words and as JSON, and its config loads.
#[test]
fn every_scene_has_an_answer_and_a_config() {
    let dir = tempfile::tempdir().unwrap();
    for name in NAMES.iter().chain(PICTURES) {
        let args = ["advise", name, "--max-ns", "1e9", "--emit", "advised.toml"];
        let output = run(dir.path(), &args);
        assert_eq!(output.status.code(), Some(0), "{name}: {}", text(&output.stderr));
        assert!(text(&output.stdout).contains("why not"));
        Config::load(&dir.path().join("advised.toml")).unwrap().check_span().unwrap();
        let json = run(dir.path(), &[&args[..], &["--json"]].concat());
        let advice: Advice = serde_json::from_slice(&json.stdout).unwrap();
        assert!(advice.met && advice.ns > 0.0 && advice.prediction.error > 0.0);
    }
}

/// Codegen takes the config: beside the accepted folder it says that this is of another config, and which to run.
#[test]
fn codegen_reads_what_is_emitted() {
    let dir = tempfile::tempdir().unwrap();
    let emitted = run(dir.path(), &["advise", "thick-overcast", "--max-ns", "1e9", "--emit", "advised.toml"]);
    assert_eq!(emitted.status.code(), Some(0), "{}", text(&emitted.stderr));
    let accepted = concat!(env!("CARGO_MANIFEST_DIR"), "/../../fit-configs/appendix-b/accepted");
    fs::create_dir(dir.path().join("advised-accepted")).unwrap();
    for entry in fs::read_dir(accepted).unwrap().map(Result::unwrap) {
        fs::copy(entry.path(), dir.path().join("advised-accepted").join(entry.file_name())).unwrap();
    }
    let output = run(dir.path(), &["codegen", "advised.toml"]);
    assert_eq!(output.status.code(), Some(1), "{}", text(&output.stderr));
    assert!(text(&output.stderr).contains("stratiform reproduce"));
}

#[test]
fn a_budget_that_nothing_meets_names_the_nearest() {
    let dir = tempfile::tempdir().unwrap();
    let output = run(dir.path(), &["advise", "thin-veil", "--max-error", "0.001%", "--emit", "advised.toml"]);
    assert_eq!(output.status.code(), Some(1));
    assert!(text(&output.stderr).contains("nearest is") && text(&output.stdout).contains("nearest"));
    assert!(!dir.path().join("advised.toml").exists());
}

fn refused(dir: &Path, args: &[&str], says: &str) {
    let output = run(dir, &[&["advise"], args].concat());
    let error = text(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{args:?}: {error}");
    assert!(
        output.stdout.is_empty() && error.contains(says) && !error.contains("panicked"),
        "{args:?}: {error}"
    );
}

#[test]
fn nonsense_is_refused() {
    let dir = tempfile::tempdir().unwrap();
    let budgets = [
        ("0", "max_error = 0"),
        ("-2%", "-0.02"),
        ("150%", "1.5"),
        ("nan", "NaN"),
        ("two", "`two`"),
        ("%", "`%`"),
    ];
    for (budget, says) in budgets {
        refused(dir.path(), &["thin-veil", "--max-error", budget], says);
    }
    for (ns, says) in [("0", "max_ns = 0"), ("-3", "-3"), ("nan", "nan"), ("inf", "inf")] {
        refused(dir.path(), &["thin-veil", "--max-ns", ns], says);
    }
    refused(dir.path(), &["thin-veil"], "no budget");
    refused(dir.path(), &["thin-vail", "--max-error", "2%"], "thin-veil");
    refused(dir.path(), &["thin-veil", "--max-error", "2%", "--ground-albedo", "1.5"], "1.5");
    refused(dir.path(), &["thin-veil", "--max-error", "2%", "--data", "nowhere"], "nowhere");
    let scene = include_str!("../../../fit-configs/scenes/thin-veil.toml");
    let cases = [
        ("title =", "titel =", "titel"),
        ("effective_radius_um = {", "effective_radius_um = { min = 9.0, max = 8.0 } # {", "inverted"),
        (
            "effective_radius_um = {",
            "effective_radius_um = { min = 7.0, max = 50.0 } # {",
            "effective_radius_um",
        ),
        ("optical_thickness = {", "optical_thickness = { min = 1e-5, max = 1.0 } # {", "optical thickness"),
    ];
    for (from, to, says) in cases {
        assert!(scene.contains(from), "{from}");
        fs::write(dir.path().join("scene.toml"), scene.replacen(from, to, 1)).unwrap();
        refused(dir.path(), &["scene.toml", "--max-error", "50%"], says);
    }
}

/// With a table of ablations, what the scene's picture can do without is said; a table of other scenes is refused.
#[test]
fn what_a_picture_does_not_need_is_said() {
    let dir = tempfile::tempdir().unwrap();
    let header = "scene,change,error,noise,rise,difference,flip,width,height,ms,ms_saved\n";
    let rows = "stratocumulus,nothing,0.1,0.01,0,0,0.05,64,36,,\n\
                stratocumulus,without halo,0.1,0.01,0,0.001,0.05,64,36,,\n\
                stratocumulus,without sky,0.3,0.01,0.2,0.25,0.2,64,36,,\n";
    fs::write(dir.path().join("ablation.csv"), format!("{header}{rows}")).unwrap();
    let asked =
        |scene| run(dir.path(), &["advise", scene, "--max-error", "90%", "--ablation", "ablation.csv"]);
    let known = asked("stratocumulus");
    assert_eq!(known.status.code(), Some(0), "{}", text(&known.stderr));
    assert!(text(&known.stdout).contains("leaving out halo, sky changes the picture by at most 25.1 %"));
    let unknown = asked("thin-veil");
    assert_eq!(unknown.status.code(), Some(2));
    assert!(text(&unknown.stderr).contains("no rows of the scene `thin-veil`") && unknown.stdout.is_empty());
}
