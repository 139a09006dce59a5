//! The height field of a scene, procedural or from a file, at a moment.

mod hash;
mod noise;
mod pattern;

use crate::{HeightField, WorldError};
use std::path::Path;
use stratiform_quantities::Range;
use stratiform_scene::Clouds;

/// The thickness of `clouds` at `moment_s`; their files are named from `folder`.
///
/// # Errors
/// [`WorldError::Domain`] for a moment that is no number; those of the file.
pub fn height_field(clouds: &Clouds, folder: &Path, moment_s: f64) -> Result<HeightField, WorldError> {
    Range::closed(-1e9, 1e9).check("moment_s", moment_s)?;
    match (clouds.pattern_keys(), &clouds.file) {
        (Some(keys), _) => pattern::field(clouds, &keys, moment_s),
        (None, Some(file)) => {
            Err(WorldError::Contents(format!("{}: not read yet", folder.join(file).display())))
        }
        (None, None) => Err(WorldError::Contents("the clouds have neither pattern nor file".to_owned())),
    }
}
