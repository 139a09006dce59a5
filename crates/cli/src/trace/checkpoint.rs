//! A file that a trace goes on from after it was killed.
//!
//! It is replaced whole, so at any moment the file is one of the states that the trace went through; at the end it is
//! the complete one and stays: started again, the command prints at once, so that nothing is lost between the last
//! photon and the reader of stdout. Two processes are kept apart by a lock on `FILE.lock`, which the system gives up
//! when a process dies. Where the file system has no locks they survive each other: both write sound states.

use super::parts::{RunParts, Snapshot};
use crate::CliError;
use crate::args::SpreadArgs;
use crate::output::Talk;
use std::fs::{self, File, TryLockError};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};
use stratiform_artifact::{ArtifactError, write_atomic};

/// An open checkpoint.
pub struct Checkpoint {
    path: PathBuf,
    every: Duration,
    stored: Instant,
    talk: Talk,
    _lock: Option<Lock>,
}

impl Checkpoint {
    /// The checkpoint that `args` name, if they do, after `parts` took over what it holds.
    ///
    /// # Errors
    /// As [`open`](Self::open) and [`resume`](Self::resume).
    pub fn resumed(args: &SpreadArgs, parts: &mut RunParts, talk: Talk) -> Result<Option<Self>, CliError> {
        let Some(path) = &args.checkpoint else { return Ok(None) };
        let checkpoint = Self::open(path, args.checkpoint_every, talk)?;
        checkpoint.resume(parts)?;
        Ok(Some(checkpoint))
    }

    /// Takes the file `path` for this process; it may not be there yet.
    ///
    /// # Errors
    /// [`CliError::Input`] if another process has it, or if its folder cannot be written.
    pub fn open(path: &Path, every: Duration, talk: Talk) -> Result<Self, CliError> {
        let lock = Lock::take(path)?;
        remove_remains(path);
        Ok(Self { path: path.to_owned(), every, stored: Instant::now(), talk, _lock: lock })
    }

    /// Puts what the file holds into `parts`, which have nothing yet; if there is no file, writes one.
    ///
    /// # Errors
    /// [`CliError::Input`] if the file is damaged or of another trace, which leaves it as it is.
    pub fn resume(&self, parts: &mut RunParts) -> Result<(), CliError> {
        if fs::symlink_metadata(&self.path).is_err() {
            return parts.write(&self.path);
        }
        let held = RunParts::read(&self.path)?;
        parts.take_over(held).map_err(|error| error.at(&self.path.display().to_string()))?;
        if parts.photons() > 0 {
            let (path, photons) = (self.path.display(), parts.photons());
            self.talk.say(format!("{path}: goes on after {photons} photons"));
        }
        Ok(())
    }

    /// Stores `snapshot` if it is time. A failure is said and tried again later.
    pub fn keep(&mut self, snapshot: &Snapshot<'_>) {
        if self.stored.elapsed() >= self.every {
            self.store(snapshot.to_bytes());
        }
    }

    /// Stores `parts` now; a failure is said.
    pub fn keep_now(&mut self, parts: &RunParts) {
        self.store(parts.to_bytes());
    }

    fn store(&mut self, bytes: Result<Vec<u8>, CliError>) {
        let stored = bytes.and_then(|bytes| Ok(write_atomic(&self.path, &bytes)?));
        if let Err(error) = stored {
            self.talk.say(format!("warning: no checkpoint: {error}"));
        }
        self.stored = Instant::now();
    }
}

/// Sole use of a checkpoint for as long as it lives.
struct Lock {
    path: PathBuf,
    _file: File,
}

impl Lock {
    fn take(checkpoint: &Path) -> Result<Option<Self>, CliError> {
        let path = beside(checkpoint, ".lock");
        let io = |source| ArtifactError::Io { action: "write", path: path.clone(), source };
        let file = File::create(&path).map_err(io)?;
        match file.try_lock() {
            Ok(()) => Ok(Some(Self { path, _file: file })),
            Err(TryLockError::WouldBlock) => {
                let name = checkpoint.display();
                Err(CliError::Input(format!("{name}: another process uses this checkpoint")))
            }
            Err(TryLockError::Error(_)) => Ok(None),
        }
    }
}

impl Drop for Lock {
    fn drop(&mut self) {
        // Only tidiness: a lock file that stays locks nobody out.
        let _ = fs::remove_file(&self.path);
    }
}

/// `path` with `ending` put behind its name.
fn beside(path: &Path, ending: &str) -> PathBuf {
    let mut name = path.file_name().unwrap_or_default().to_owned();
    name.push(ending);
    path.with_file_name(name)
}

/// Removes what killed processes left of half-written checkpoints.
fn remove_remains(path: &Path) {
    let start = beside(path, ".");
    let start = start.file_name().unwrap_or_default().to_string_lossy().into_owned();
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let is_remains = |name: &str| {
        let middle = name.strip_prefix(&start).and_then(|rest| rest.strip_suffix(".partial"));
        middle.is_some_and(|process| !process.is_empty() && process.bytes().all(|b| b.is_ascii_digit()))
    };
    for entry in fs::read_dir(folder).into_iter().flatten().flatten() {
        if is_remains(&entry.file_name().to_string_lossy()) {
            // Only tidiness here too.
            let _ = fs::remove_file(entry.path());
        }
    }
}
