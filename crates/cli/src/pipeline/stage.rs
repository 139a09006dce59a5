//! Stages and the manifest: a stage whose inputs' hash is unchanged, and whose files still are what it wrote, is not
//! run again. Stages may run side by side.

use crate::{CliError, output::Talk};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::path::{Component, Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::Instant;
use stratiform_artifact::{
    Provenance, create_folder, hash_bytes, hash_of, read_json, write_atomic, write_json,
};

/// What a stage left behind.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct StageRecord {
    /// Hash of everything the stage depends on.
    pub inputs_hash: String,
    /// Wall time when it last ran.
    pub seconds: f64,
    /// Files relative to the folder, with the hash of each.
    pub files: BTreeMap<String, String>,
}

/// `manifest.json`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Manifest {
    /// `stratiform/manifest/1`.
    pub schema: String,
    /// The config's title.
    pub title: String,
    /// Hash of the whole config, seed, version.
    pub provenance: Provenance,
    /// By name.
    pub stages: BTreeMap<String, StageRecord>,
}

/// The folder a pipeline writes to.
pub struct Workspace {
    dir: PathBuf,
    manifest: Mutex<Manifest>,
    talk: Talk,
}

impl Workspace {
    /// Creates `dir` if needed and proves that it can be written before any work is done. Records of earlier runs
    /// are kept where they still hold.
    ///
    /// # Errors
    /// [`CliError::Input`] if the folder cannot be created or written.
    pub fn open(dir: &Path, title: &str, provenance: Provenance, talk: Talk) -> Result<Self, CliError> {
        create_folder(dir)?;
        // A manifest that cannot be read proves nothing: every stage then runs.
        let stages = read_json::<Manifest>(&dir.join("manifest.json")).map(|m| m.stages).unwrap_or_default();
        let manifest = Manifest {
            schema: "stratiform/manifest/1".to_owned(),
            title: title.to_owned(),
            provenance,
            stages,
        };
        let probe = dir.join(format!(".stratiform.{}", std::process::id()));
        write_atomic(&probe, b"")?;
        // The probe was written: that it cannot be removed is no reason to stop.
        let _ = std::fs::remove_file(&probe);
        Ok(Self { dir: dir.to_owned(), manifest: Mutex::new(manifest), talk })
    }

    /// The folder.
    pub fn dir(&self) -> &Path {
        &self.dir
    }

    /// The inputs' hash of a stage that ran, to hand on to those that depend on it.
    pub fn hash_of_stage(&self, name: &str) -> String {
        self.record(name).map_or_else(String::new, |record| hash_of(&record.files))
    }

    /// Runs stage `name` unless it is fresh. `run` writes into the folder and returns the files it wrote.
    ///
    /// # Errors
    /// Those of `run`, and [`CliError::Input`] if a file cannot be read back or the manifest not be written.
    pub fn stage(
        &self,
        name: &str,
        inputs: &impl Serialize,
        run: impl FnOnce(&Path) -> Result<Vec<String>, CliError>,
    ) -> Result<(), CliError> {
        let inputs_hash = hash_of(&(env!("CARGO_PKG_VERSION"), name, inputs));
        if self.is_fresh(name, &inputs_hash) {
            self.talk.say(format!("{name}: unchanged"));
            return Ok(());
        }
        let start = Instant::now();
        let written = run(&self.dir)?;
        let mut files = BTreeMap::new();
        for file in written {
            let bytes =
                std::fs::read(self.dir.join(&file)).map_err(|e| CliError::Input(format!("{file}: {e}")))?;
            files.insert(file, hash_bytes(&bytes));
        }
        self.remove_files(name, |file| !files.contains_key(file));
        let seconds = start.elapsed().as_secs_f64();
        self.talk.say(format!("{name}: {seconds:.2} s"));
        let record = StageRecord { inputs_hash, seconds, files };
        self.manifest().stages.insert(name.to_owned(), record);
        self.save()
    }

    /// Takes away what an earlier run of stage `name` left, because this config has no such stage.
    ///
    /// # Errors
    /// [`CliError::Input`] if the manifest cannot be written.
    pub fn without(&self, name: &str) -> Result<(), CliError> {
        self.remove_files(name, |_| true);
        self.manifest().stages.remove(name);
        self.save()
    }

    /// Removes those files of the stage's last run that are `unwanted`.
    fn remove_files(&self, name: &str, unwanted: impl Fn(&str) -> bool) {
        let files = self.record(name).into_iter().flat_map(|record| record.files.into_keys());
        for file in files.filter(|file| unwanted(file)) {
            // A file that is gone already, or a path that is none of ours, needs no removal.
            if Path::new(&file).components().all(|part| matches!(part, Component::Normal(_))) {
                let _ = std::fs::remove_file(self.dir.join(&file));
            }
        }
    }

    fn is_fresh(&self, name: &str, inputs_hash: &str) -> bool {
        self.record(name).is_some_and(|record| {
            record.inputs_hash == inputs_hash
                && record.files.iter().all(|(file, hash)| {
                    std::fs::read(self.dir.join(file)).is_ok_and(|bytes| hash_bytes(&bytes) == *hash)
                })
        })
    }

    /// Writes the manifest.
    ///
    /// # Errors
    /// [`CliError::Input`] if it cannot be written.
    pub fn save(&self) -> Result<(), CliError> {
        Ok(write_json(&self.dir.join("manifest.json"), &*self.manifest())?)
    }

    fn record(&self, name: &str) -> Option<StageRecord> {
        self.manifest().stages.get(name).cloned()
    }

    /// Held for moments only: nobody computes meanwhile.
    fn manifest(&self) -> MutexGuard<'_, Manifest> {
        self.manifest.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::cell::Cell;

    fn open(dir: &Path) -> Workspace {
        let provenance = Provenance::new("0".to_owned(), None, "test");
        Workspace::open(dir, "test", provenance, Talk { quiet: true }).unwrap()
    }

    #[test]
    fn a_stage_runs_again_only_when_inputs_or_files_change() {
        let dir = tempfile::tempdir().unwrap();
        let runs = Cell::new(0);
        let run = |inputs: u32| {
            let stage = |dir: &Path| {
                runs.set(runs.get() + 1);
                write_atomic(&dir.join("a.txt"), inputs.to_string().as_bytes())?;
                Ok(vec!["a.txt".to_owned()])
            };
            open(dir.path()).stage("a", &inputs, stage).unwrap();
            runs.get()
        };
        assert_eq!((run(1), run(1), run(2), run(2)), (1, 1, 2, 2));
        std::fs::write(dir.path().join("a.txt"), "edited").unwrap();
        assert_eq!(run(2), 3);
        std::fs::write(dir.path().join("manifest.json"), "{").unwrap();
        assert_eq!(run(2), 4);
    }

    #[test]
    fn what_a_stage_no_longer_writes_is_taken_away() {
        let dir = tempfile::tempdir().unwrap();
        let run = |name: &'static str| {
            let stage = |dir: &Path| {
                write_atomic(&dir.join(name), b"x")?;
                Ok(vec![name.to_owned()])
            };
            open(dir.path()).stage("a", &name, stage).unwrap();
        };
        run("old.txt");
        run("new.txt");
        assert!(!dir.path().join("old.txt").exists() && dir.path().join("new.txt").exists());
        open(dir.path()).without("a").unwrap();
        assert!(!dir.path().join("new.txt").exists() && open(dir.path()).manifest().stages.is_empty());
    }

    #[test]
    fn a_failed_stage_leaves_no_record() {
        let dir = tempfile::tempdir().unwrap();
        let workspace = open(dir.path());
        assert!(workspace.stage("a", &1, |_| Err(CliError::Interrupted)).is_err());
        assert!(!dir.path().join("a.txt").exists());
        assert!(workspace.manifest().stages.is_empty());
    }
}
