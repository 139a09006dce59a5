//! The truth: traced, or read from an EXR.

use crate::CliError;
use crate::pipeline::input_error;
use std::path::Path;
use stratiform_artifact::read_json;
use stratiform_imaging::{Image, Layers, read_exr, write_exr};
use stratiform_pathtrace as pathtrace;
use stratiform_world::Contribution;

/// Mean and standard error of the whole and of every contribution, all of one size.
pub struct Truth {
    /// All light.
    pub mean: Image,
    /// Its standard error.
    pub std_error: Image,
    parts: Vec<(Contribution, Image, Image)>,
    /// Where it comes from.
    pub words: String,
}

/// The layer of a standard error.
fn error_layer(part: &str) -> String {
    format!("{part}_std_error")
}

impl Truth {
    /// Of what was traced.
    pub fn of(traced: pathtrace::Truth, seed: u64) -> Self {
        let pathtrace::Truth { mean, std_error, parts, samples, .. } = traced;
        let words = format!("path tracing, {samples} paths a pixel, seed {seed}");
        Self { mean, std_error, parts, words }
    }

    /// Of images made otherwise; a mean and a standard error for each contribution.
    pub fn new(
        (mean, std_error): (Image, Image),
        parts: Vec<(Contribution, Image, Image)>,
        words: &str,
    ) -> Self {
        Self { mean, std_error, parts, words: words.to_owned() }
    }

    /// Reads an EXR with the layers `std_error`, and of each contribution its name and `NAME_std_error`, as `stratiform truth` writes it.
    ///
    /// # Errors
    /// [`CliError::Input`] if it cannot be read, lacks a layer, or is a crop by the `truth.json` beside it.
    pub fn read(path: &Path) -> Result<Self, CliError> {
        let layers = read_exr(path).map_err(input_error)?;
        whole(path, [layers.image.width(), layers.image.height()])?;
        let parts = Contribution::ALL.into_iter().map(|part| {
            let name = part.name();
            Ok((part, layer(path, &layers, name)?, layer(path, &layers, &error_layer(name))?))
        });
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        Ok(Self {
            parts: parts.collect::<Result<_, CliError>>()?,
            std_error: layer(path, &layers, "std_error")?,
            words: format!("{name}: {}", layers.comments),
            mean: layers.image,
        })
    }

    /// Writes what [`read`](Self::read) reads.
    ///
    /// # Errors
    /// [`CliError::Input`] if it cannot be written.
    pub fn write(&self, path: &Path) -> Result<(), CliError> {
        let names: Vec<_> =
            self.parts.iter().map(|(part, ..)| (part.name(), error_layer(part.name()))).collect();
        let mut layers = vec![("std_error", &self.std_error)];
        for ((name, error_name), (_, mean, error)) in names.iter().zip(&self.parts) {
            layers.extend([(*name, mean), (error_name.as_str(), error)]);
        }
        write_exr(path, &self.mean, &layers, &self.words).map_err(input_error)
    }

    /// Mean and standard error of a contribution.
    ///
    /// # Errors
    /// [`CliError::Input`] if there is none.
    pub fn part(&self, part: Contribution) -> Result<(&Image, &Image), CliError> {
        let found = self.parts.iter().find(|(known, ..)| *known == part);
        let missing = || CliError::Input(format!("the truth has no part `{}`", part.name()));
        found.map(|(_, mean, error)| (mean, error)).ok_or_else(missing)
    }
}

/// What `truth.json` says of the whole picture.
#[derive(serde::Deserialize)]
struct Whole {
    width: usize,
    height: usize,
}

/// Refuses a crop, whose pixels would be taken for those of a whole picture.
fn whole(path: &Path, size: [usize; 2]) -> Result<(), CliError> {
    let beside = path.with_file_name("truth.json");
    if !beside.exists() {
        return Ok(());
    }
    let Whole { width, height } = read_json(&beside)?;
    if [width, height] == size {
        return Ok(());
    }
    Err(CliError::Input(format!(
        "{}: {} x {} pixels of a picture of {width} x {height}: a crop cannot be compared",
        path.display(),
        size[0],
        size[1]
    )))
}

fn layer(path: &Path, layers: &Layers, name: &str) -> Result<Image, CliError> {
    let missing = || {
        let there: Vec<_> = layers.further.iter().map(|(name, _)| name.as_str()).collect();
        CliError::Input(format!("{}: no layer `{name}`; there are {}", path.display(), there.join(", ")))
    };
    layers.layer(name).cloned().ok_or_else(missing)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::fs;

    #[test]
    fn what_is_written_is_read_and_what_lacks_is_named() {
        let dir = tempfile::tempdir().unwrap();
        let path = dir.path().join("truth.exr");
        let image = |value: f32| Image::new(3, 2, vec![[value; 3]; 6]).unwrap();
        let parts = Contribution::ALL.map(|part| (part, image(part.index() as f32), image(0.1)));
        let truth = Truth {
            mean: image(21.0),
            std_error: image(0.5),
            parts: parts.to_vec(),
            words: "7 paths".to_owned(),
        };
        truth.write(&path).unwrap();
        let read = Truth::read(&path).unwrap();
        assert_eq!((&read.mean, &read.std_error, &read.parts), (&truth.mean, &truth.std_error, &truth.parts));
        assert!(read.words.ends_with("7 paths"), "{}", read.words);
        fs::write(dir.path().join("truth.json"), "{\"width\": 30, \"height\": 2, \"seed\": 1}").unwrap();
        assert!(Truth::read(&path).err().unwrap().to_string().contains("a crop"));
        fs::remove_file(dir.path().join("truth.json")).unwrap();
        write_exr(&path, &image(1.0), &[("halo", &image(1.0))], "").unwrap();
        let error = Truth::read(&path).err().unwrap().to_string();
        assert!(error.contains("no layer") && error.contains("halo"), "{error}");
    }
}
