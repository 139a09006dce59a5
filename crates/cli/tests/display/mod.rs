//! A display without a screen: Xvfb, whose pixels lie in a file, and keys by xdotool.

use std::io::{BufRead as _, BufReader, ErrorKind, Write as _};
use std::process::{Child, Command, Stdio};
use std::sync::atomic::{AtomicUsize, Ordering};
use tempfile::TempDir;

static SKIPPED: AtomicUsize = AtomicUsize::new(0);

/// What the machine has; or, where it has not, a loud skip. With this variable set that is a failure.
pub fn available<T>(found: Result<T, String>, required_by: &str) -> Option<T> {
    match found {
        Ok(value) => Some(value),
        Err(reason) if std::env::var_os(required_by).is_none() => {
            let count = SKIPPED.fetch_add(1, Ordering::Relaxed) + 1;
            // Past the test harness's capture: a skipped test must be seen.
            let _ = std::io::stderr().write_all(format!("SKIPPED ({count}): {reason}\n").as_bytes());
            None
        }
        Err(reason) => panic!("{reason}"),
    }
}

/// A process that ends with it.
pub struct Process(pub Child);

impl Drop for Process {
    fn drop(&mut self) {
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}

/// The display.
pub struct Display {
    _server: Process,
    folder: TempDir,
    name: String,
}

impl Display {
    /// Starts one.
    pub fn start() -> Result<Self, String> {
        let folder = TempDir::new().unwrap();
        let server = Command::new("Xvfb")
            .args(["-displayfd", "1", "-screen", "0", "320x240x24", "-nolisten", "tcp", "-fbdir"])
            .arg(folder.path())
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn();
        let mut server = server.map(Process).map_err(|error| missing("Xvfb", &error))?;
        let mut number = String::new();
        BufReader::new(server.0.stdout.take().unwrap()).read_line(&mut number).unwrap();
        assert!(!number.trim().is_empty(), "Xvfb has no display for us");
        Ok(Self { _server: server, folder, name: format!(":{}", number.trim()) })
    }

    /// Puts a command on it.
    pub fn show<'a>(&self, command: &'a mut Command) -> &'a mut Command {
        command.env("DISPLAY", &self.name).env_remove("WAYLAND_DISPLAY").env_remove("WAYLAND_SOCKET")
    }

    /// Red, green and blue of the `width` x `height` pixels at its top left, from the dump format of xwd that Xvfb keeps.
    pub fn pixels(&self, width: usize, height: usize) -> Vec<u8> {
        let dump = std::fs::read(self.folder.path().join("Xvfb_screen0")).unwrap();
        let word = |i: usize| u32::from_be_bytes(dump[4 * i..][..4].try_into().unwrap()) as usize;
        let (header, row, colours) = (word(0), word(12), word(19));
        assert_eq!(word(11), 32, "bits of a pixel");
        let pixel = |x: usize, y: usize| &dump[header + 12 * colours + y * row + 4 * x..][..4];
        let rgb = |x: usize, y: usize| [pixel(x, y)[2], pixel(x, y)[1], pixel(x, y)[0]];
        (0..height).flat_map(|y| (0..width).flat_map(move |x| rgb(x, y))).collect()
    }

    /// Gives the window of that name the focus and touches keys.
    pub fn touch(&self, window: &str, keys: &[&str]) -> Result<(), String> {
        let mut tool = Command::new("xdotool");
        tool.args(["search", "--name", window, "windowfocus", "--sync", "key"]).args(keys);
        let output = self.show(&mut tool).output().map_err(|error| missing("xdotool", &error))?;
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        Ok(())
    }
}

fn missing(tool: &str, error: &std::io::Error) -> String {
    assert_eq!(error.kind(), ErrorKind::NotFound, "{tool}: {error}");
    format!("{tool} is not installed")
}
