//! Maps of errors as pictures with a scale, and pictures with a title: PNG and SVG.

mod base64;
mod colours;
mod map;
mod scale;
mod svg;

pub use colours::Colours;
pub use map::ErrorMap;
pub use scale::Scale;
pub use svg::picture_svg;
