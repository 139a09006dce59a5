//! `stratiform render`: pictures where there is a device, and clear words where there is none.

#![allow(clippy::unwrap_used, reason = "a test may stop where it fails")]

mod common;

use common::{command, root, run};
use std::process::Output;

/// Exit code 2, nothing on stdout, a message that holds `says`.
fn refused(output: &Output, says: &str) {
    let error = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{error}");
    assert!(output.stdout.is_empty() && error.contains(says), "`{says}` is not in: {error}");
    assert!(!error.contains("panicked"), "{error}");
}

fn scene() -> String {
    root().join("fit-configs/scenes/stratocumulus.toml").display().to_string()
}

#[test]
fn a_size_is_two_numbers() {
    let dir = tempfile::tempdir().unwrap();
    refused(&run(dir.path(), &["render", &scene(), "--out", "a.png", "--size", "480"]), "WIDTHxHEIGHT");
}

#[cfg(not(feature = "gpu"))]
#[test]
fn without_the_feature_it_says_how_to_get_it() {
    let dir = tempfile::tempdir().unwrap();
    let output = command(dir.path(), &["render", &scene(), "--out", "a.png"]).output().unwrap();
    refused(&output, "--features gpu");
    assert!(!dir.path().join("a.png").exists());
}

#[cfg(feature = "gpu")]
mod drawn {
    use super::*;
    use common::stdout;
    use stratiform_gpu::{Gpu, GpuError};
    use stratiform_imaging::{read_exr, read_png};

    /// A loud skip without a device, a failure where one is demanded.
    fn device() -> bool {
        match Gpu::new() {
            Ok(_) => true,
            Err(error @ GpuError::NoAdapter { .. })
                if std::env::var_os("STRATIFORM_REQUIRE_GPU").is_none() =>
            {
                use std::io::Write as _;
                let _ = std::io::stderr().write_all(format!("SKIPPED: {error}\n").as_bytes());
                false
            }
            Err(error) => panic!("{error}"),
        }
    }

    #[test]
    fn a_scene_becomes_a_png_and_an_exr() {
        let dir = tempfile::tempdir().unwrap();
        if !device() {
            return;
        }
        let args = ["render", &scene(), "--size", "32x18", "--out", "a.png", "--exr", "a.exr"];
        assert_eq!(stdout(dir.path(), &args), "a.png\na.exr\n");
        let linear = read_exr(&dir.path().join("a.exr")).unwrap().image;
        let shown = read_png(&dir.path().join("a.png")).unwrap();
        assert_eq!((linear.width(), linear.height(), shown.width(), shown.height()), (32, 18, 32, 18));
        let timed =
            stdout(dir.path(), &["render", &scene(), "--size", "32x18", "--out", "b.png", "--timings"]);
        assert!(timed.starts_with("pass,seconds\n"), "{timed}");
        let bytes = |name: &str| std::fs::read(dir.path().join(name)).unwrap();
        assert_eq!(bytes("a.png"), bytes("b.png"));
    }

    #[test]
    fn what_cannot_be_drawn_is_named_and_nothing_is_written() {
        let dir = tempfile::tempdir().unwrap();
        let refuse = |more: &[&str], says: &str| {
            let scene = scene();
            let args = [&["render", scene.as_str(), "--size", "32x18"], more].concat();
            refused(&run(dir.path(), &args), says);
        };
        refuse(&["--out", "a.png", "--only", "glory"], "no contribution is called `glory`");
        refuse(&["--out", "nowhere/a.png"], "no folder nowhere");
        refuse(&["--out", "a.png", "--time", "nan"], "finite");
        refused(&run(dir.path(), &["render", "thin-veil", "--out", "a.png"]), "no picture");
        assert_eq!(
            std::fs::read_dir(dir.path()).unwrap().filter(|e| e.as_ref().unwrap().path().is_file()).count(),
            0
        );
    }

    #[test]
    fn a_machine_without_adapter_is_told() {
        let dir = tempfile::tempdir().unwrap();
        let mut command = command(dir.path(), &["render", &scene(), "--size", "32x18", "--out", "a.png"]);
        let output = command.env("VK_ICD_FILENAMES", "/nonexistent.json").output().unwrap();
        refused(&output, "no Vulkan adapter");
        assert!(!dir.path().join("a.png").exists());
    }
}
