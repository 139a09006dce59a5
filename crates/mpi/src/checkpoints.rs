//! Where ranks keep their counts: rank K of N in `FILE.rank-K-of-N`, K from 1.

use std::ffi::OsString;
use std::fs;
use std::path::{Path, PathBuf};
use stratiform_cli::CliError;
use stratiform_transport::Share;

/// The checkpoint of the rank that has `share`.
pub fn of_rank(file: &Path, share: Share) -> PathBuf {
    beside(file, &format!("{}-of-{}", share.number(), share.of()))
}

/// Refuses to start beside checkpoints of another number of ranks: they would be neither used nor noticed.
///
/// # Errors
/// [`CliError::Input`] naming one of them.
pub fn refuse_other_sizes(file: &Path, ranks: u64) -> Result<(), CliError> {
    let folder = file.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    for entry in fs::read_dir(folder).into_iter().flatten().flatten() {
        let name = entry.file_name();
        if let Some(other) = size(file, &name).filter(|size| *size != ranks) {
            let (file, name) = (file.display(), name.display());
            return Err(CliError::Input(format!(
                "{file}: {name} is of {other} ranks, not {ranks}: start {other} ranks to go on, or remove the \
                 checkpoints to start anew"
            )));
        }
    }
    Ok(())
}

fn beside(file: &Path, which: &str) -> PathBuf {
    let mut name = file.file_name().unwrap_or_default().to_owned();
    name.push(".rank-");
    name.push(which);
    file.with_file_name(name)
}

/// N, if `name` is that of a rank's checkpoint.
fn size(file: &Path, name: &OsString) -> Option<u64> {
    let start = beside(file, "").file_name()?.to_string_lossy().into_owned();
    let (rank, size) = name.to_str()?.strip_prefix(&start)?.split_once("-of-")?;
    rank.parse::<u64>().ok()?;
    size.parse().ok()
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "a test may stop where it fails")]
mod tests {
    use super::*;

    #[test]
    fn checkpoints_of_other_sizes_are_seen_and_nothing_else() {
        let dir = tempfile::tempdir().unwrap();
        let file = dir.path().join("run.ckpt");
        for name in ["run.ckpt", "run.ckpt.rank-1-of-3.lock", "other.rank-1-of-4", "run.ckpt.rank-x-of-4"] {
            fs::write(dir.path().join(name), "").unwrap();
        }
        fs::write(of_rank(&file, Share::new(2, 3).unwrap()), "").unwrap();
        assert!(refuse_other_sizes(&file, 3).is_ok());
        let error = refuse_other_sizes(&file, 4).unwrap_err().to_string();
        assert!(error.contains("run.ckpt.rank-2-of-3 is of 3 ranks, not 4"), "{error}");
        assert!(refuse_other_sizes(&dir.path().join("absent/run.ckpt"), 4).is_ok());
    }
}
