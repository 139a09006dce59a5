//! Files that appear whole or not at all.

use crate::ArtifactError;
use std::fs::{self, File};
use std::io::Write;
use std::path::Path;

fn io(action: &'static str, path: &Path) -> impl FnOnce(std::io::Error) -> ArtifactError {
    let path = path.to_owned();
    move |source| ArtifactError::Io { action, path, source }
}

/// Creates `folder` and its parents.
///
/// # Errors
/// [`ArtifactError::Io`] if it cannot be created or is a file.
pub fn create_folder(folder: &Path) -> Result<(), ArtifactError> {
    fs::create_dir_all(folder).map_err(io("create", folder))
}

/// Writes `bytes` beside `path`, flushes them to the disk, and renames: an interrupted or failed write leaves
/// the old file, or none. A symbolic link stays, and the file that it names is written.
///
/// # Errors
/// [`ArtifactError::Io`] if any step fails, the temporary file being removed; or if `path` is there and is no regular
/// file.
pub fn write_atomic(path: &Path, bytes: &[u8]) -> Result<(), ArtifactError> {
    let target = fs::canonicalize(path).unwrap_or_else(|_| path.to_owned());
    let path = target.as_path();
    if fs::metadata(path).is_ok_and(|found| !found.is_file()) {
        return Err(io("write", path)(std::io::Error::other("it is no regular file")));
    }
    let mut name = path.file_name().unwrap_or_default().to_owned();
    name.push(format!(".{}.partial", std::process::id()));
    let partial = path.with_file_name(name);
    let write = || {
        let mut file = File::create(&partial)?;
        file.write_all(bytes)?;
        file.sync_all()?;
        drop(file);
        fs::rename(&partial, path)
    };
    write().map_err(|source| {
        // The write's own error is the one to report, whether or not the remains can be removed.
        let _ = fs::remove_file(&partial);
        io("write", path)(source)
    })
}

/// Reads a UTF-8 text file.
///
/// # Errors
/// [`ArtifactError::Io`] if it cannot be read, [`ArtifactError::Format`] if it is empty or not UTF-8.
pub fn read_text(path: &Path) -> Result<String, ArtifactError> {
    let bytes = fs::read(path).map_err(io("read", path))?;
    let text = String::from_utf8(bytes).map_err(|error| {
        let line =
            error.as_bytes()[..error.utf8_error().valid_up_to()].iter().filter(|b| **b == b'\n').count();
        ArtifactError::format(path, Some(line as u64 + 1), "not a text file (invalid UTF-8)")
    })?;
    if text.trim().is_empty() {
        return Err(ArtifactError::format(path, None, "the file is empty"));
    }
    Ok(text)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_failed_write_leaves_the_old_file_and_no_remains() {
        let dir = tempfile::tempdir().unwrap();
        let path = dir.path().join("a.txt");
        write_atomic(&path, b"old").unwrap();
        assert!(write_atomic(&dir.path().join("missing/b.txt"), b"x").is_err());
        write_atomic(&path, b"new").unwrap();
        assert_eq!(read_text(&path).unwrap(), "new");
        assert_eq!(fs::read_dir(dir.path()).unwrap().count(), 1);
    }

    #[test]
    fn empty_and_binary_files_are_refused() {
        let dir = tempfile::tempdir().unwrap();
        let path = dir.path().join("a.txt");
        fs::write(&path, "").unwrap();
        assert!(read_text(&path).unwrap_err().to_string().ends_with("the file is empty"));
        fs::write(&path, [b'a', b'\n', 0xff, 0xfe]).unwrap();
        assert!(read_text(&path).unwrap_err().to_string().contains(":2: not a text file"));
    }
}
