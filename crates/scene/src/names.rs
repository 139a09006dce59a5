//! The scenes that come with the program.

use crate::{Scene, SceneError};
use std::path::Path;

macro_rules! scenes {
    ($($name:literal),* $(,)?) => {
        /// Their names, as the files in `fit-configs/scenes/` are called.
        pub const NAMES: &[&str] = &[$($name),*];

        const TEXTS: &[&str] = &[$(include_str!(concat!("../../../fit-configs/scenes/", $name, ".toml"))),*];
    };
}

scenes!(
    "thin-veil",
    "stratocumulus-above",
    "stratocumulus-below",
    "low-sun",
    "glory-view",
    "fogbow-view",
    "thick-overcast",
);

/// The scene of that name.
///
/// # Errors
/// [`SceneError::Unknown`].
pub fn named(name: &str) -> Result<Scene, SceneError> {
    let place = NAMES.iter().position(|known| *known == name);
    let place =
        place.ok_or_else(|| SceneError::Unknown { name: name.to_owned(), known: NAMES.join(", ") })?;
    Scene::parse(TEXTS[place], name)
}

/// A named scene, or the one in the file of that name; with the name that it goes by, a file's stem.
///
/// # Errors
/// [`SceneError`]; [`SceneError::Unknown`] if it is neither.
pub fn find(name_or_file: &str) -> Result<(String, Scene), SceneError> {
    let path = Path::new(name_or_file);
    if !NAMES.contains(&name_or_file) && path.exists() {
        let stem = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        return Ok((stem, Scene::load(path)?));
    }
    Ok((name_or_file.to_owned(), named(name_or_file)?))
}
