//! PNG: written as 8-bit sRGB with the exposure beside it, read at 8 or 16 bits a channel, grey or colour; transparency is left out.

use super::{bytes, fault, size};
use crate::{Image, ImagingError, Tone, srgb};
use std::io::Cursor;
use std::path::Path;
use stratiform_artifact::write_atomic;

impl Image {
    /// Writes what `tone` makes of it. The text chunks `Exposure` and `Tone curve` say which that was.
    ///
    /// # Errors
    /// [`ImagingError::NotFinite`] names a pixel; [`ImagingError::Domain`] for the exposure; [`ImagingError::Artifact`] if the file
    /// cannot be written.
    pub fn write_png(&self, path: &Path, tone: &Tone) -> Result<(), ImagingError> {
        let text = [
            (
                "Exposure",
                format!("{} EV; at 0 EV a white diffuser that faces the sun is white", tone.exposure_ev),
            ),
            ("Tone curve", tone.curve.name().to_owned()),
        ];
        Ok(write_atomic(path, &encode_png((self.width(), self.height()), &tone.bytes(self)?, &text)?)?)
    }

    /// The same file in memory.
    ///
    /// # Errors
    /// As [`write_png`](Self::write_png).
    pub fn to_png(&self, tone: &Tone) -> Result<Vec<u8>, ImagingError> {
        encode_png((self.width(), self.height()), &tone.bytes(self)?, &[])
    }
}

/// A PNG of stored sRGB bytes.
pub(crate) fn encode_png(
    (width, height): (usize, usize),
    rgb: &[u8],
    text: &[(&str, String)],
) -> Result<Vec<u8>, ImagingError> {
    let refuse = |error: png::EncodingError| fault(Path::new("PNG"), error);
    let side = |n: usize| u32::try_from(n).map_err(|error| fault(Path::new("PNG"), error));
    let mut out = Vec::new();
    let mut encoder = png::Encoder::new(&mut out, side(width)?, side(height)?);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_source_srgb(png::SrgbRenderingIntent::RelativeColorimetric);
    encoder.add_text_chunk("Software".to_owned(), "stratiform".to_owned()).map_err(refuse)?;
    for (key, value) in text {
        encoder.add_text_chunk((*key).to_owned(), value.clone()).map_err(refuse)?;
    }
    let mut writer = encoder.write_header().map_err(refuse)?;
    writer.write_image_data(rgb).map_err(refuse)?;
    writer.finish().map_err(refuse)?;
    Ok(out)
}

/// Samples in [0, 1] as stored, `channels` of them a pixel (1 to 4).
pub(super) struct Stored {
    pub width: usize,
    pub height: usize,
    pub channels: usize,
    pub samples: Vec<f64>,
}

/// Reads the samples. Palettes and fewer than 8 bits are expanded.
pub(super) fn stored(path: &Path) -> Result<Stored, ImagingError> {
    let data = bytes(path)?;
    let mut decoder = png::Decoder::new(Cursor::new(data));
    decoder.set_transformations(png::Transformations::EXPAND);
    let refuse = |error: png::DecodingError| fault(path, error);
    let mut reader = decoder.read_info().map_err(refuse)?;
    let (width, height) = (reader.info().width as usize, reader.info().height as usize);
    size(path, width, height)?;
    let length = reader.output_buffer_size().ok_or_else(|| fault(path, "too large for memory"))?;
    let mut buffer = vec![0; length];
    reader.next_frame(&mut buffer).map_err(refuse)?;
    let (colour, depth) = reader.output_color_type();
    let samples = match depth {
        png::BitDepth::Sixteen => {
            buffer.chunks_exact(2).map(|b| f64::from(u16::from_be_bytes([b[0], b[1]])) / 65_535.0).collect()
        }
        _ => buffer.iter().map(|b| f64::from(*b) / 255.0).collect(),
    };
    Ok(Stored { width, height, channels: colour.samples(), samples })
}

/// Reads a picture as linear light in [0, 1] by the sRGB curve, whatever its profile says; grey becomes equal channels.
///
/// # Errors
/// [`ImagingError::File`] if it is not there, no PNG, damaged or too large.
pub fn read_png(path: &Path) -> Result<Image, ImagingError> {
    let Stored { width, height, channels, samples } = stored(path)?;
    let colour = |pixel: &[f64]| if channels < 3 { [pixel[0]; 3] } else { [pixel[0], pixel[1], pixel[2]] };
    let pixels = samples.chunks_exact(channels).map(|p| colour(p).map(|s| srgb::decode(s) as f32)).collect();
    Image::new(width, height, pixels)
}
