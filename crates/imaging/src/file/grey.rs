//! One channel of numbers: heights and masks.

use super::exr::planes_of;
use super::png::stored;
use super::{bytes, fault};
use crate::{Grey, ImagingError};
use std::path::Path;

const EXR_MAGIC: [u8; 4] = [0x76, 0x2f, 0x31, 0x01];

/// Reads a PNG or EXR, told apart by their first bytes. PNG: 8 or 16 bits as they are stored, over the largest value, without any
/// transfer curve. EXR: the channel `Y`, or the only one, as it is. A PNG in colour is refused unless its channels are equal.
///
/// # Errors
/// [`ImagingError::File`] if it is not there, neither of both, damaged, too large or in colour, or if a value is not finite.
pub fn read_grey(path: &Path) -> Result<Grey, ImagingError> {
    if bytes(path)?.starts_with(&EXR_MAGIC) { of_exr(path) } else { of_png(path) }
}

fn of_png(path: &Path) -> Result<Grey, ImagingError> {
    let found = stored(path)?;
    let pixels = || found.samples.chunks_exact(found.channels);
    let coloured = |pixel: &[f64]| pixel.len() >= 3 && (pixel[0] != pixel[1] || pixel[0] != pixel[2]);
    if pixels().any(coloured) {
        return Err(fault(path, "a picture in colour, where one number per pixel is needed"));
    }
    Grey::new(found.width, found.height, pixels().map(|pixel| pixel[0] as f32).collect())
}

fn of_exr(path: &Path) -> Result<Grey, ImagingError> {
    let mut planes = planes_of(path)?;
    let names: Vec<String> = planes.named.iter().map(|(name, _)| name.clone()).collect();
    let at = names.iter().position(|name| name == "Y").or((names.len() == 1).then_some(0));
    let at = at.ok_or_else(|| {
        fault(path, format!("channels {}, where Y or a single one is needed", names.join(", ")))
    })?;
    let values = planes.named.swap_remove(at).1;
    if let Some(bad) = values.iter().position(|value| !value.is_finite()) {
        let (x, y) = (bad % planes.width, bad / planes.width);
        return Err(fault(path, format!("pixel ({x}, {y}) is {}: not finite", values[bad])));
    }
    Grey::new(planes.width, planes.height, values)
}
