//! Writing the generated files, and finding out whether a folder still holds them.

use crate::{CodegenError, Files};
use std::io::ErrorKind;
use std::path::{Path, PathBuf};
use std::{fmt, fs};
use stratiform_artifact::{ArtifactError, create_folder, write_atomic};

/// The command that brings stale files up to date.
pub const REGENERATE: &str = "stratiform codegen CONFIG";

/// Lines of a difference that are shown.
const SHOWN: usize = 12;

/// A file that is not what would be generated now.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Stale {
    /// Its name.
    pub file: String,
    /// Whether nothing generates it.
    pub left_over: bool,
    /// What differs, line by line.
    pub diff: String,
}

impl fmt::Display for Stale {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.left_over {
            return writeln!(f, "{} is not generated, perhaps no longer: delete it", self.file);
        }
        write!(f, "{} is stale: run `{REGENERATE}`\n{}", self.file, self.diff)
    }
}

/// Writes every file into `folder`: first all of them beside their places, then each into its own, so that a full disk
/// or a place that is taken leaves the folder as it was.
///
/// # Errors
/// [`CodegenError::Artifact`] if the folder or a file cannot be written.
pub fn write(files: &Files, folder: &Path) -> Result<(), CodegenError> {
    create_folder(folder)?;
    let beside = folder.join(format!(".{}.partial", std::process::id()));
    let written = write_beside(files, folder, &beside);
    // The writing's own error is the one to report, whether or not the remains can be removed.
    let _ = fs::remove_dir_all(&beside);
    Ok(written?)
}

fn write_beside(files: &Files, folder: &Path, beside: &Path) -> Result<(), ArtifactError> {
    create_folder(beside)?;
    files.iter().try_for_each(|(name, bytes)| write_atomic(&beside.join(name), bytes))?;
    let refused = |path: PathBuf, source| ArtifactError::Io { action: "write", path, source };
    if let Some(path) = files.names().map(|name| folder.join(name)).find(|path| path.is_dir()) {
        return Err(refused(path, ErrorKind::IsADirectory.into()));
    }
    files.names().try_for_each(|name| {
        let path = folder.join(name);
        fs::rename(beside.join(name), &path).map_err(|source| refused(path, source))
    })
}

/// The files in `folder` that differ from `files`, cannot be read, or are not generated.
///
/// # Errors
/// All of them, if there are any.
pub fn check(files: &Files, folder: &Path) -> Result<(), Vec<Stale>> {
    let stale = |(name, expected): (&str, &[u8])| {
        let diff = match (fs::read(folder.join(name)), std::str::from_utf8(expected)) {
            (Ok(found), _) if found == expected => return None,
            (Ok(found), Ok(text)) => difference(&String::from_utf8_lossy(&found), text),
            (Ok(found), Err(_)) => format!("{} bytes differ from {}\n", found.len(), expected.len()),
            (Err(error), _) if error.kind() == ErrorKind::NotFound => "it is missing\n".to_owned(),
            (Err(error), _) => format!("cannot read it: {error}\n"),
        };
        Some(Stale { file: name.to_owned(), left_over: false, diff })
    };
    let mut all: Vec<_> = files.iter().filter_map(stale).collect();
    all.extend(left_over(files, folder));
    if all.is_empty() { Ok(()) } else { Err(all) }
}

/// Files in `folder` that nothing generates, in order.
pub fn left_over(files: &Files, folder: &Path) -> Vec<Stale> {
    let entries = fs::read_dir(folder).into_iter().flatten().flatten();
    let mut names: Vec<_> = entries.map(|entry| entry.file_name().to_string_lossy().into_owned()).collect();
    names.sort_unstable();
    let unknown = names.into_iter().filter(|name| files.bytes(name).is_none());
    unknown.map(|file| Stale { file, left_over: true, diff: String::new() }).collect()
}

/// The lines between the common start and the common end: `-` what stands there, `+` what belongs there.
fn difference(found: &str, expected: &str) -> String {
    let (old, new): (Vec<_>, Vec<_>) = (found.split('\n').collect(), expected.split('\n').collect());
    let start = old.iter().zip(&new).take_while(|(a, b)| a == b).count();
    let rest = old[start..].iter().rev().zip(new[start..].iter().rev());
    let end = rest.take_while(|(a, b)| a == b).count();
    let mut text = format!("@@ line {} @@\n", start + 1);
    for (sign, lines) in [('-', &old[start..old.len() - end]), ('+', &new[start..new.len() - end])] {
        for line in lines.iter().take(SHOWN) {
            text.push_str(&format!("{sign}{line}\n"));
        }
        if lines.len() > SHOWN {
            text.push_str(&format!("{sign}... {} more lines\n", lines.len() - SHOWN));
        }
    }
    text
}
