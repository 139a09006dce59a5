//! `SOURCE.toml`: where figures come from, and what they were when they were transcribed.

use crate::ReferenceError;
use serde::Deserialize;
use sha2::{Digest, Sha256};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// A source of figures: its `SOURCE.toml`. No field is empty.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Source {
    /// What the figures are.
    pub title: String,
    /// Who published them, and where.
    pub citation: String,
    /// From where they were transcribed, or how they were computed.
    pub origin: String,
    /// Under which terms they may be passed on.
    pub licence: String,
    /// Which digits are to be trusted.
    pub digits: String,
    /// File name -> SHA-256 in hexadecimal.
    pub files: BTreeMap<String, String>,
    #[serde(skip)]
    folder: PathBuf,
}

impl Source {
    /// The source in `root/name`.
    ///
    /// # Errors
    /// [`ReferenceError::Read`] and [`ReferenceError::Source`].
    pub fn load(root: &Path, name: &str) -> Result<Self, ReferenceError> {
        let folder = root.join(name);
        let path = folder.join("SOURCE.toml");
        let text = match std::fs::read_to_string(&path) {
            Ok(text) => text,
            Err(source) => return Err(ReferenceError::Read { path, source }),
        };
        match toml::from_str::<Self>(&text) {
            Ok(source) => source.placed(folder, path),
            Err(error) => Err(ReferenceError::Source { path, message: error.to_string() }),
        }
    }

    fn placed(self, folder: PathBuf, path: PathBuf) -> Result<Self, ReferenceError> {
        let fields = [
            ("title", &self.title),
            ("citation", &self.citation),
            ("origin", &self.origin),
            ("licence", &self.licence),
            ("digits", &self.digits),
        ];
        match fields.iter().find(|(_, value)| value.trim().is_empty()) {
            Some((name, _)) => Err(ReferenceError::Source { path, message: format!("{name} is empty") }),
            None => Ok(Self { folder, ..self }),
        }
    }

    /// The text of a file that is listed and has the listed hash.
    ///
    /// # Errors
    /// [`ReferenceError`] otherwise.
    pub fn read(&self, file: &str) -> Result<String, ReferenceError> {
        let Some(listed) = self.files.get(file) else {
            return Err(ReferenceError::NotListed {
                path: self.folder.join("SOURCE.toml"),
                file: file.to_owned(),
                listed: self.files.keys().cloned().collect::<Vec<_>>().join(", "),
            });
        };
        let path = self.folder.join(file);
        let bytes = match std::fs::read(&path) {
            Ok(bytes) => bytes,
            Err(source) => return Err(ReferenceError::Read { path, source }),
        };
        let found = sha256(&bytes);
        if found != *listed {
            return Err(ReferenceError::Hash { path, listed: listed.clone(), found });
        }
        String::from_utf8(bytes).map_err(|source| ReferenceError::NotText { path, source })
    }
}

/// SHA-256 in lower-case hexadecimal, as `SOURCE.toml` lists it and `sha256sum` prints it.
pub fn sha256(bytes: &[u8]) -> String {
    Sha256::digest(bytes).iter().map(|byte| format!("{byte:02x}")).collect()
}
