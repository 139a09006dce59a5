//! The example workflow for other projects: its steps, as they stand there, do what their names say.
#![cfg(unix)]
#![allow(clippy::unwrap_used, reason = "a test may stop where it fails")]

mod common;

use common::root;
use std::fs;
use std::os::unix::fs::symlink;
use std::path::Path;
use std::process::Command;

/// (name, commands) of every step that runs commands. Understands what the example uses of YAML: `run: text`, `run: |` and
/// `run: >-`.
fn steps(workflow: &str) -> Vec<(String, String)> {
    let indent = |line: &str| line.len() - line.trim_start().len();
    let (mut name, mut steps) = (String::new(), Vec::new());
    let lines: Vec<_> = workflow.lines().collect();
    for (i, line) in lines.iter().enumerate() {
        if let Some(text) = line.trim_start().strip_prefix("- name: ") {
            name = text.to_owned();
        }
        let Some(text) = line.trim_start().strip_prefix("run: ") else { continue };
        let block =
            lines[i + 1..].iter().take_while(|next| indent(next) > indent(line) && !next.trim().is_empty());
        let block: Vec<_> = block.map(|line| line.trim()).collect();
        let script = match text {
            "|" => block.join("\n"),
            ">-" => block.join(" "),
            text => text.to_owned(),
        };
        steps.push((name.clone(), script));
    }
    steps
}

/// Runs a step as the runner does: `bash -e`.
fn run_step(dir: &Path, script: &str) -> std::process::Output {
    let binary = Path::new(env!("CARGO_BIN_EXE_stratiform")).parent().unwrap();
    let path = format!("{}:{}", binary.display(), std::env::var("PATH").unwrap());
    Command::new("bash")
        .args(["-e", "-o", "pipefail", "-c", script])
        .current_dir(dir)
        .env("PATH", path)
        .env("STRATIFORM_CACHE", dir.join("cache"))
        .env("GITHUB_STEP_SUMMARY", dir.join("summary.md"))
        .output()
        .unwrap()
}

#[test]
fn every_step_of_the_example_succeeds_and_the_slip_is_caught() {
    let dir = tempfile::tempdir().unwrap();
    for folder in ["fit-configs", "scripts"] {
        symlink(root().join(folder).canonicalize().unwrap(), dir.path().join(folder)).unwrap();
    }
    let workflow = fs::read_to_string(root().join("scripts/example-check/workflow.yml")).unwrap();
    let steps = steps(&workflow);
    let names: Vec<_> = steps.iter().map(|(name, _)| name.as_str()).collect();
    let expected = [
        "Install stratiform",
        "Evaluate the implementation where the config asks",
        "Hold it against the truth",
        "A planted slip is caught",
    ];
    assert_eq!(names, expected);
    assert_eq!(steps[0].1, "cargo install --locked --path crates/cli");
    for (name, script) in &steps[1..] {
        let output = run_step(dir.path(), script);
        let said = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success(), "{name}: {}{said}", String::from_utf8_lossy(&output.stdout));
    }
    let read = |name: &str| fs::read_to_string(dir.path().join(name)).unwrap();
    assert!(read("summary.md").starts_with("## stratiform check passed\n"));
    assert!(!read("check.xml").contains("<failure") && read("slip.xml").contains("<failure"));
    let slip = read("slip.xml");
    let tree = roxmltree::Document::parse(&slip).unwrap();
    let named: Vec<_> = tree
        .descendants()
        .filter(|node| node.has_tag_name("failure"))
        .filter_map(|node| node.parent().and_then(|case| case.attribute("name")))
        .collect();
    assert!(
        named.contains(&"transmittance order 1") && !named.contains(&"transmittance order 0"),
        "{named:?}"
    );
}
