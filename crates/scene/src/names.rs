//! The scenes that come with the program.

use crate::{Scene, SceneError};
use std::path::Path;

macro_rules! scenes {
    ($(#[$doc:meta])* $names:ident, $texts:ident: $($name:literal),* $(,)?) => {
        $(#[$doc])*
        pub const $names: &[&str] = &[$($name),*];

        const $texts: &[&str] = &[$(include_str!(concat!("../../../fit-configs/scenes/", $name, ".toml"))),*];
    };
}

scenes!(
    /// Names of those that are ranges, which methods are charted over, as the files in `fit-configs/scenes/` are called.
    NAMES, TEXTS:
    "thin-veil",
    "stratocumulus-above",
    "stratocumulus-below",
    "low-sun",
    "glory-view",
    "fogbow-view",
    "thick-overcast",
);

scenes!(
    /// Names of those that are pictures.
    PICTURES, PICTURE_TEXTS:
    "stratocumulus",
    "stratocumulus-from-below",
    "glory",
    "fogbow",
    "pseudo-specular",
    "silver-lining",
    "water-sky",
    "ice-blink",
    "sun-disc",
);

/// The scene of that name.
///
/// # Errors
/// [`SceneError::Unknown`].
pub fn named(name: &str) -> Result<Scene, SceneError> {
    let mut all = NAMES.iter().zip(TEXTS).chain(PICTURES.iter().zip(PICTURE_TEXTS));
    match all.find(|(known, _)| **known == name) {
        Some((_, text)) => Scene::parse(text, name),
        None => {
            let known = [NAMES, PICTURES].concat().join(", ");
            Err(SceneError::Unknown { name: name.to_owned(), known })
        }
    }
}

/// A named scene, or the one in the file of that name; with the name that it goes by, a file's stem.
///
/// # Errors
/// [`SceneError`]; [`SceneError::Unknown`] if it is neither.
pub fn find(name_or_file: &str) -> Result<(String, Scene), SceneError> {
    let path = Path::new(name_or_file);
    if ![NAMES, PICTURES].concat().contains(&name_or_file) && path.exists() {
        let stem = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        return Ok((stem, Scene::load(path)?));
    }
    Ok((name_or_file.to_owned(), named(name_or_file)?))
}
