//! Images in files.

mod exr;
mod grey;
mod png;

pub use exr::{Layers, read_exr, write_exr};
pub use grey::read_grey;
pub(crate) use png::encode_png;
pub use png::read_png;

use crate::ImagingError;
use std::path::Path;

/// Columns and rows beyond which nothing is read: a header alone can claim any size.
const LARGEST_SIDE: usize = 32_768;
/// Pixels beyond which nothing is read.
const MOST_PIXELS: usize = 1 << 27;

fn fault(path: &Path, message: impl ToString) -> ImagingError {
    ImagingError::File { path: path.to_owned(), message: message.to_string() }
}

fn bytes(path: &Path) -> Result<Vec<u8>, ImagingError> {
    std::fs::read(path).map_err(|error| fault(path, format!("cannot be read: {error}")))
}

fn size(path: &Path, width: usize, height: usize) -> Result<(), ImagingError> {
    let most = width.max(height) <= LARGEST_SIDE && width.saturating_mul(height) <= MOST_PIXELS;
    if most && width > 0 && height > 0 {
        return Ok(());
    }
    let limits = format!("at most {LARGEST_SIDE} a side and {MOST_PIXELS} in all");
    Err(fault(path, format!("{width} x {height} pixels, where {limits} can be read")))
}
