//! The height field of a scene, procedural or from a file, at a moment.

mod file;
pub(crate) mod hash;
pub(crate) mod noise;
mod pattern;

pub(crate) use file::square;
pub(crate) use pattern::whole;

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
    let (pattern, file) = (clouds.pattern_keys(), clouds.file.as_ref().zip(clouds.scale_m));
    match (pattern, file) {
        (Some(keys), _) => pattern::field(clouds, &keys, moment_s),
        (None, Some((file, scale_m))) => file::field(clouds, &folder.join(file), scale_m, moment_s),
        (None, None) => Err(WorldError::Contents("clouds.scale_m is missing: a file needs it".to_owned())),
    }
}
