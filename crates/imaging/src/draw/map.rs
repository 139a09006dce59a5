//! A number per pixel as colours, with the scale that tells which.

use super::Scale;
use super::svg::{Bar, framed};
use crate::file::encode_png;
use crate::{Grey, ImagingError};
use std::path::Path;
use stratiform_artifact::write_atomic;

/// Steps of the scale bar.
const STEPS: usize = 64;

/// A map and its legend.
#[derive(Clone, Copy, Debug)]
pub struct ErrorMap<'a> {
    /// Heading.
    pub title: &'a str,
    /// What the numbers are, with unit, under the scale bar.
    pub label: &'a str,
    /// The numbers, finite.
    pub values: &'a Grey,
    /// Their colours; numbers beyond its ends have the end's colour.
    pub scale: Scale,
}

impl ErrorMap<'_> {
    /// The map as SVG: title, pixels, scale bar with its ends and middle.
    ///
    /// # Errors
    /// [`ImagingError::File`] if it is too large for PNG.
    pub fn to_svg(&self) -> Result<String, ImagingError> {
        let (least, most) = (self.scale.least(), self.scale.most);
        let at = |share: f64| least + share * (most - least);
        let steps = (0..STEPS).map(|i| self.scale.colour(at((i as f64 + 0.5) / STEPS as f64))).collect();
        let bar = Bar { steps, ends: [0.0, 0.5, 1.0].map(at), label: self.label.to_owned() };
        let size = (self.values.width(), self.values.height());
        Ok(framed(self.title, size, &self.png(&[])?, Some(&bar)))
    }

    /// Writes the pixels alone; the text chunk `Scale` says what the colours mean.
    ///
    /// # Errors
    /// [`ImagingError::Artifact`] if the file cannot be written.
    pub fn write_png(&self, path: &Path) -> Result<(), ImagingError> {
        let scale = format!(
            "{:?} from {} to {}: {}",
            self.scale.colours,
            self.scale.least(),
            self.scale.most,
            self.label
        );
        Ok(write_atomic(path, &self.png(&[("Scale", scale)])?)?)
    }

    fn png(&self, text: &[(&str, String)]) -> Result<Vec<u8>, ImagingError> {
        let pixels = self.values.values().iter().flat_map(|value| self.scale.colour(f64::from(*value)));
        encode_png((self.values.width(), self.values.height()), &pixels.collect::<Vec<u8>>(), text)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::draw::Colours;

    #[test]
    fn a_map_has_its_pixels_and_says_its_scale() {
        let values = Grey::new(2, 1, vec![-0.1, 0.2]).unwrap();
        let scale = Scale { colours: Colours::Diverging, most: 0.2 };
        let map = ErrorMap { title: "a < b", label: "difference", values: &values, scale };
        let svg = map.to_svg().unwrap();
        for needed in ["a &lt; b", "data:image/png;base64,", ">-0.2<", ">0<", ">0.2<", "difference"] {
            assert!(svg.contains(needed), "{needed} in {svg}");
        }
        let dir = tempfile::tempdir().unwrap();
        map.write_png(&dir.path().join("a.png")).unwrap();
        let read = crate::read_png(&dir.path().join("a.png")).unwrap();
        let meant = scale.colour(0.2).map(|byte| crate::srgb::decode(f64::from(byte) / 255.0) as f32);
        assert_eq!(read.at(1, 0), meant);
    }
}
