//! OpenEXR: 32-bit floats, scan lines, ZIP. A row per function (full, squared, modified), a column per texel, a channel
//! per wavelength (`550nm`) or R, G, B.
//!
//! The attribute `comments` says the conventions in words, `stratiform` holds the metadata as JSON. The library keeps further
//! attributes in an order that changes from run to run, so there is one only.

use super::{Metadata, Precision};
use crate::TablesError;
use crate::set::SampledSet;
use ::exr::prelude::{
    AnyChannel, AnyChannels, AttributeValue, Blocks, Compression, Encoding, FlatSamples, Image, Layer,
    LayerAttributes, LineOrder, Text, WritableImage,
};
use std::io::Cursor;

/// One channel: its name and its texels, row after row.
pub(super) struct Plane {
    pub(super) name: String,
    pub(super) values: Vec<f32>,
}

/// The set as EXR.
///
/// # Errors
/// [`TablesError::Domain`] for values that f32 cannot hold, [`TablesError::Container`] if the library refuses.
pub fn phase_exr(set: &SampledSet) -> Result<Vec<u8>, TablesError> {
    Precision::F32.check_set(set)?;
    let planes = set.channels.iter().enumerate().map(|(i, channel)| Plane {
        name: channel.name(),
        values: set.rows.iter().flat_map(|row| row[i].values.iter().map(|value| *value as f32)).collect(),
    });
    let metadata = Metadata::new(set);
    let rows: Vec<_> =
        metadata.rows.iter().map(|row| format!("{}: {}", row.function.name(), row.definition)).collect();
    let comments = format!(
        "Phase functions. {}. {}. {}; {}. Rows from the top: {}.",
        metadata.units,
        metadata.normalisation,
        metadata.angle_map.coordinate,
        metadata.angle_map.texels,
        rows.join("; ")
    );
    image((set.texels, set.functions.len()), planes.collect(), &comments, &metadata.line()?)
}

/// An image of `planes` with the two attributes.
pub(super) fn image(
    size: (usize, usize),
    planes: Vec<Plane>,
    comments: &str,
    metadata: &str,
) -> Result<Vec<u8>, TablesError> {
    let mut attributes = LayerAttributes {
        software_name: Some(Text::from("stratiform")),
        comments: Some(text(comments)?),
        ..LayerAttributes::default()
    };
    attributes.other.insert(Text::from("stratiform"), AttributeValue::Text(text(&ascii(metadata))?));
    let channels = planes
        .into_iter()
        .map(|plane| Ok(AnyChannel::new(text(&plane.name)?, FlatSamples::F32(plane.values))));
    let channels = channels.collect::<Result<Vec<_>, TablesError>>()?;
    let encoding = Encoding {
        compression: Compression::ZIP16,
        blocks: Blocks::ScanLines,
        line_order: LineOrder::Increasing,
    };
    let layer = Layer::new(size, attributes, encoding, AnyChannels::sort(channels.into()));
    let mut bytes = Cursor::new(Vec::new());
    let refuse = |error: ::exr::error::Error| refusal(error.to_string());
    Image::from_layer(layer).write().non_parallel().to_buffered(&mut bytes).map_err(refuse)?;
    Ok(bytes.into_inner())
}

/// JSON with everything beyond ASCII as `\u` escapes: readers differ in what they take a byte above 127 for.
fn ascii(json: &str) -> String {
    let escaped = json.chars().map(|character| match character {
        ' '..='~' => character.to_string(),
        other => other.encode_utf16(&mut [0; 2]).iter().map(|unit| format!("\\u{unit:04x}")).collect(),
    });
    escaped.collect()
}

/// EXR's texts are Latin-1.
fn text(value: &str) -> Result<Text, TablesError> {
    Text::new_or_none(value).ok_or_else(|| refusal(format!("`{value}` is not Latin-1")))
}

fn refusal(reason: String) -> TablesError {
    TablesError::Container { format: "EXR", reason }
}
