//! OpenEXR: 32-bit floats, scan lines, ZIP, one part. The picture is R, G, B; a further layer `name` is `name.R`, `name.G`, `name.B`.
//!
//! The attribute `comments` says the unit in words. There is no further attribute of our own: the library writes those in an order that
//! changes from run to run.

use super::{bytes, fault, size};
use crate::{Image, ImagingError};
use ::exr::prelude::{
    AnyChannel, AnyChannels, Blocks, Compression, Encoding, FlatSamples, Layer, LayerAttributes, LineOrder,
    ReadChannels, ReadLayers, Text, WritableImage, read,
};
use std::io::Cursor;
use std::path::Path;
use stratiform_artifact::write_atomic;

const UNIT: &str = "Linear sRGB primaries, D65 white. Radiance in units of the sun's irradiance normal to its beam above the cloud \
                    (luminance 1), 1/sr.";

/// What an EXR holds.
#[derive(Clone, Debug, PartialEq)]
pub struct Layers {
    /// R, G, B.
    pub image: Image,
    /// Layers by name.
    pub further: Vec<(String, Image)>,
    /// The attribute `comments`.
    pub comments: String,
}

impl Layers {
    /// The layer called `name`.
    pub fn layer(&self, name: &str) -> Option<&Image> {
        self.further.iter().find(|(found, _)| found == name).map(|(_, image)| image)
    }
}

/// Writes `image` with `further` layers of the same size; `comment` follows the statement of the unit. The same input gives the same
/// bytes.
///
/// # Errors
/// [`ImagingError::NotFinite`] names a pixel; [`ImagingError::Unlike`] for a layer of another size; [`ImagingError::File`] for a name
/// that EXR cannot hold; [`ImagingError::Artifact`] if the file cannot be written.
pub fn write_exr(
    path: &Path,
    image: &Image,
    further: &[(&str, &Image)],
    comment: &str,
) -> Result<(), ImagingError> {
    let mut channels = planes("", image);
    image.must_be_finite()?;
    for (name, layer) in further {
        image.must_be_like(layer)?;
        layer.must_be_finite()?;
        channels.extend(planes(&format!("{name}."), layer));
    }
    let text = |value: &str| {
        Text::new_or_none(value).ok_or_else(|| fault(path, format!("`{value}` is not Latin-1")))
    };
    let channels = channels
        .into_iter()
        .map(|(name, values)| Ok(AnyChannel::new(text(&name)?, FlatSamples::F32(values))))
        .collect::<Result<Vec<_>, ImagingError>>()?;
    let attributes = LayerAttributes {
        software_name: Some(Text::from("stratiform")),
        comments: Some(text(format!("{UNIT} {comment}").trim())?),
        ..LayerAttributes::default()
    };
    let encoding = Encoding {
        compression: Compression::ZIP16,
        blocks: Blocks::ScanLines,
        line_order: LineOrder::Increasing,
    };
    let size = (image.width(), image.height());
    let layer = Layer::new(size, attributes, encoding, AnyChannels::sort(channels.into()));
    let mut out = Cursor::new(Vec::new());
    let written = ::exr::prelude::Image::from_layer(layer).write().non_parallel().to_buffered(&mut out);
    written.map_err(|error| fault(path, error))?;
    Ok(write_atomic(path, &out.into_inner())?)
}

fn planes(prefix: &str, image: &Image) -> Vec<(String, Vec<f32>)> {
    let plane = |c: usize| image.pixels().iter().map(|pixel| pixel[c]).collect();
    ["R", "G", "B"].iter().enumerate().map(|(c, name)| (format!("{prefix}{name}"), plane(c))).collect()
}

/// The channels of a file's first part.
pub(super) struct Planes {
    pub width: usize,
    pub height: usize,
    /// By name, row by row.
    pub named: Vec<(String, Vec<f32>)>,
    pub comments: String,
}

impl Planes {
    fn take(&mut self, name: &str) -> Option<Vec<f32>> {
        let at = self.named.iter().position(|(found, _)| found == name)?;
        Some(self.named.swap_remove(at).1)
    }

    fn colour(&mut self, prefix: &str) -> Option<Vec<[f32; 3]>> {
        let [red, green, blue] = ["R", "G", "B"].map(|c| self.take(&format!("{prefix}{c}")));
        let joined = red?.into_iter().zip(green?).zip(blue?);
        Some(joined.map(|((r, g), b)| [r, g, b]).collect())
    }
}

/// Reads the channels of the first part.
pub(super) fn planes_of(path: &Path) -> Result<Planes, ImagingError> {
    let data = bytes(path)?;
    // The sizes that the headers claim, before memory is set aside for them.
    let meta = ::exr::meta::MetaData::read_from_buffered(Cursor::new(&data), false);
    for header in &meta.map_err(|error| fault(path, error))?.headers {
        size(path, header.layer_size.width(), header.layer_size.height())?;
    }
    let reader = read().no_deep_data().largest_resolution_level().all_channels().first_valid_layer();
    let image = reader.all_attributes().non_parallel().from_buffered(Cursor::new(data));
    let layer = image.map_err(|error| fault(path, error))?.layer_data;
    let (width, height) = (layer.size.width(), layer.size.height());
    let plane = |channel: &AnyChannel<FlatSamples>| {
        (channel.name.to_string(), channel.sample_data.values_as_f32().collect::<Vec<_>>())
    };
    let named: Vec<_> = layer.channel_data.list.iter().map(plane).collect();
    if let Some((name, _)) = named.iter().find(|(_, values)| values.len() != width * height) {
        return Err(fault(path, format!("channel {name} is not sampled at every pixel")));
    }
    let comments = layer.attributes.comments.map(|text| text.to_string()).unwrap_or_default();
    Ok(Planes { width, height, named, comments })
}

/// Reads R, G, B and every further layer that has the three. A file with Y alone is grey.
///
/// # Errors
/// [`ImagingError::File`] if it is not there, no EXR, damaged, too large or without colour; [`ImagingError::NotFinite`] names a pixel.
pub fn read_exr(path: &Path) -> Result<Layers, ImagingError> {
    let mut planes = planes_of(path)?;
    let (width, height) = (planes.width, planes.height);
    let grey = |planes: &mut Planes| Some(planes.take("Y")?.into_iter().map(|y| [y; 3]).collect());
    let pixels = planes.colour("").or_else(|| grey(&mut planes));
    let pixels = pixels.ok_or_else(|| fault(path, "no channels R, G, B"))?;
    let finite = |image: Image| image.must_be_finite().map(|()| image);
    let image = finite(Image::new(width, height, pixels)?)?;
    let prefixes: Vec<String> =
        planes.named.iter().filter_map(|(name, _)| name.strip_suffix('R').map(str::to_owned)).collect();
    let mut further = Vec::new();
    for prefix in prefixes.iter().filter(|prefix| prefix.ends_with('.')) {
        if let Some(pixels) = planes.colour(prefix) {
            further
                .push((prefix.trim_end_matches('.').to_owned(), finite(Image::new(width, height, pixels)?)?));
        }
    }
    further.sort_by(|a, b| a.0.cmp(&b.0));
    Ok(Layers { image, further, comments: planes.comments })
}
