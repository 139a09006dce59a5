//! Completions and manual pages name every command.

#![allow(clippy::unwrap_used, reason = "a test may stop where it fails")]

mod common;

use clap::CommandFactory;
use common::{run, stdout};
use std::fs;
use stratiform_cli::Cli;

fn commands() -> Vec<String> {
    Cli::command().get_subcommands().map(|command| command.get_name().to_owned()).collect()
}

#[test]
fn completions_of_every_shell_name_every_command() {
    let dir = tempfile::tempdir().unwrap();
    for shell in ["bash", "zsh", "fish", "elvish", "powershell"] {
        let script = stdout(dir.path(), &["completions", shell]);
        for command in commands() {
            assert!(script.contains(&command), "{shell} lacks {command}");
        }
    }
    assert_eq!(run(dir.path(), &["completions", "dos"]).status.code(), Some(2));
}

/// The shell itself reads the script, where it is installed.
#[test]
fn bash_takes_its_completions() {
    let dir = tempfile::tempdir().unwrap();
    let script = dir.path().join("stratiform.bash");
    fs::write(&script, stdout(dir.path(), &["completions", "bash"])).unwrap();
    let status = std::process::Command::new("bash").arg("-n").arg(&script).status().unwrap();
    assert!(status.success());
}

#[test]
fn there_is_a_manual_page_of_every_command() {
    let dir = tempfile::tempdir().unwrap();
    let main = stdout(dir.path(), &["man"]);
    for word in ["stratiform", "Exit codes", ".SH NAME", ".SH OPTIONS"] {
        assert!(main.contains(word), "{word} is missing:\n{main}");
    }
    let listed = stdout(dir.path(), &["man", "--out", "man1"]);
    assert_eq!(listed.lines().count(), 1 + commands().len());
    for command in commands() {
        let page = fs::read_to_string(dir.path().join(format!("man1/stratiform-{command}.1"))).unwrap();
        assert!(page.contains(&format!("stratiform-{command}").replace('-', "\\-")), "{page}");
    }
}
