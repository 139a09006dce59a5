//! Linear images, the files they live in, and what tells two of them apart.
//!
//! | file | written | read |
//! | --- | --- | --- |
//! | EXR | [`write_exr`]: f32, linear, with further layers | [`read_exr`], [`read_grey`] |
//! | PNG | [`Image::write_png`]: 8-bit sRGB through a [`Tone`] | [`read_png`], [`read_grey`] |
//!
//! Files appear whole or not at all; pixels that are not finite are refused by name.

pub mod compare;
pub mod draw;
mod error;
mod file;
mod grey;
mod image;
pub mod profile;
pub mod srgb;
mod tone;

pub use error::ImagingError;
pub use file::{Layers, read_exr, read_grey, read_png, write_exr};
pub use grey::Grey;
pub use image::Image;
pub use tone::{Curve, Tone};
