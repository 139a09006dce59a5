//! The window, on a display without a screen.

#![allow(clippy::unwrap_used, reason = "a test may stop where it fails")]

mod common;

use common::{command, root};

/// Without a display, or without the feature: one line, and no window.
#[test]
fn no_window_is_one_message() {
    let mut command = command(&root(), &["view", "stratocumulus"]);
    let bare = command.env_remove("DISPLAY").env_remove("WAYLAND_DISPLAY").env_remove("WAYLAND_SOCKET");
    let output = bare.env_remove("STRATIFORM_CACHE").env("RUST_BACKTRACE", "1").output().unwrap();
    let said = String::from_utf8(output.stderr).unwrap();
    assert_eq!((output.status.code(), output.stdout.as_slice()), (Some(2), &b""[..]), "{said}");
    let expected = if cfg!(feature = "view") { "no display" } else { "cargo feature `view`" };
    let error: Vec<&str> = said.lines().filter(|line| line.starts_with("error: ")).collect();
    assert!(error.len() == 1 && error[0].contains(expected), "{said}");
    assert!(!said.contains("panicked") && !said.contains("backtrace"), "{said}");
}

#[cfg(feature = "view")]
mod display;

#[cfg(feature = "view")]
mod shown {
    use super::display::{Display, Process, available};
    use super::{command, root};
    use std::path::Path;
    use std::process::Stdio;
    use std::thread::sleep;
    use std::time::{Duration, Instant};
    use stratiform_imaging::{read_png, srgb};
    use tempfile::TempDir;

    const WIDTH: usize = 96;
    const HEIGHT: usize = 54;

    /// The paper's cloud on a coarse field, in a folder of its own.
    fn scene() -> TempDir {
        let folder = TempDir::new().unwrap();
        let scenes = root().join("fit-configs/scenes");
        let text = std::fs::read_to_string(scenes.join("stratocumulus.toml")).unwrap();
        let tables = format!("\"{}\"", scenes.join("../appendix-b").display());
        let size =
            [("width = 480", format!("width = {WIDTH}")), ("height = 270", format!("height = {HEIGHT}"))];
        let replaced = [("side = 512", "side = 64".to_owned()), ("\"../appendix-b\"", tables)];
        let text = size.iter().chain(&replaced).fold(text, |text, (from, to)| {
            assert!(text.contains(from), "{from}");
            text.replacen(from, to, 1)
        });
        std::fs::write(folder.path().join("scene.toml"), text).unwrap();
        folder
    }

    /// What `render` writes, as bytes; none where there is no adapter.
    fn rendered(folder: &Path) -> Option<Vec<u8>> {
        let output = command(folder, &["render", "scene.toml", "--out", "scene.png"]).output().unwrap();
        let said = String::from_utf8_lossy(&output.stderr).into_owned();
        let found = if said.contains("no Vulkan adapter") { Err(said.clone()) } else { Ok(()) };
        available(found, "STRATIFORM_REQUIRE_GPU")?;
        assert!(output.status.success(), "{said}");
        let picture = read_png(&folder.join("scene.png")).unwrap();
        let byte = |linear: &f32| (255.0 * srgb::encode(f64::from(*linear)) + 0.5) as u8;
        Some(picture.pixels().iter().flatten().map(byte).collect())
    }

    fn display() -> Option<Display> {
        available(Display::start(), "STRATIFORM_REQUIRE_TOOLS")
    }

    /// Greatest and mean difference.
    fn differences(left: &[u8], right: &[u8]) -> (u8, f64) {
        let each = || left.iter().zip(right).map(|(l, r)| l.abs_diff(*r));
        (each().max().unwrap(), each().map(f64::from).sum::<f64>() / left.len() as f64)
    }

    /// Waits until the display is as it should; the last look otherwise.
    fn wait_for(display: &Display, so: impl Fn(&[u8]) -> bool) -> Result<Vec<u8>, Vec<u8>> {
        let start = Instant::now();
        loop {
            let pixels = display.pixels(WIDTH, HEIGHT);
            if so(&pixels) {
                return Ok(pixels);
            } else if start.elapsed() > Duration::from_secs(100) {
                return Err(pixels);
            }
            sleep(Duration::from_millis(50));
        }
    }

    #[test]
    fn the_window_shows_what_render_writes_and_keys_move_the_sun() {
        let folder = scene();
        let (Some(expected), Some(display)) = (rendered(folder.path()), display()) else { return };
        let mut view = command(folder.path(), &["view", "scene.toml", "--quiet"]);
        let mut view = Process(display.show(&mut view).stdout(Stdio::null()).spawn().unwrap());
        let first =
            wait_for(&display, |pixels| differences(pixels, &expected).0 <= 1).unwrap_or_else(|pixels| {
                panic!("(greatest, mean) difference {:?}", differences(&pixels, &expected))
            });
        let sun = display.touch("scene", &["Left", "Left", "Left"]);
        if available(sun, "STRATIFORM_REQUIRE_TOOLS").is_none() {
            return;
        }
        let moved = wait_for(&display, |pixels| differences(pixels, &first).1 > 0.2);
        assert!(moved.is_ok(), "the sun stands still");
        display.touch("scene", &["Escape"]).unwrap();
        assert!(view.0.wait().unwrap().success());
    }

    #[test]
    fn it_closes_after_as_many_pictures_as_are_asked_for() {
        let folder = scene();
        let (Some(_), Some(display)) = (rendered(folder.path()), display()) else { return };
        let mut view = command(folder.path(), &["view", "scene.toml", "--frames", "3", "--size", "64x48"]);
        let output = display.show(&mut view).output().unwrap();
        let said = String::from_utf8(output.stderr).unwrap();
        assert!(output.status.success() && said.contains("3 pictures on "), "{said}");
        assert!(output.stdout.is_empty());
    }
}
