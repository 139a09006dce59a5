//! Linear images, the files they live in, and what tells two of them apart.

mod image;

pub use image::{Image, ImagingError};
