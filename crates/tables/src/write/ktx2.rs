//! KTX2 (Khronos KTX File Format Specification 2.0): one uncompressed 2-D level of four channels, f32 or f16.
//!
//! Texel (i, j) is texel i of row j. Channels stand four to a texel; of n functions row j holds function j mod n and the
//! channels from 4⌊j/n⌋ on. Components without a channel are 0. Key `stratiform` holds the metadata as JSON,
//! `stratiformRows` what each row's R, G, B and A are.

use super::metadata::line;
use super::precision::half;
use super::{Metadata, Precision};
use crate::TablesError;
use crate::set::{Channel, SampledSet};

const MAGIC: [u8; 12] = *b"\xABKTX 20\xBB\r\n\x1A\n";
/// Magic, header, and the index of one level.
const BEFORE_DESCRIPTOR: usize = 104;
/// Khronos Data Format: RGBSDA, linear, float and signed.
const MODEL_RGBSDA: u8 = 1;
const TRANSFER_LINEAR: u8 = 1;
const FLOAT_SIGNED: u8 = 0xC0;

/// Four channels in rows.
pub(super) struct Texture {
    width: usize,
    /// RGBA after RGBA, row after row.
    values: Vec<f64>,
    /// BT.709 primaries, or none.
    srgb: bool,
    /// Keys in rising order.
    texts: [(&'static str, String); 4],
}

/// The set as KTX2, `VK_FORMAT_R32G32B32A32_SFLOAT` or `VK_FORMAT_R16G16B16A16_SFLOAT`.
///
/// # Errors
/// [`TablesError::Domain`] for values that the format cannot hold: f16 ends at 65504, which the peak of droplets
/// beyond some 25 µm at 0.45 µm exceeds; [`TablesError::Container`] for f64, which is no texture format.
pub fn phase_ktx2(set: &SampledSet, precision: Precision) -> Result<Vec<u8>, TablesError> {
    precision.check_set(set)?;
    let groups: Vec<usize> = (0..set.channels.len()).step_by(4).collect();
    let (mut values, mut rows) = (Vec::new(), Vec::new());
    for &first in &groups {
        for (function, row) in set.functions.iter().zip(&set.rows) {
            for i in 0..set.texels {
                values.extend((first..first + 4).map(|c| row.get(c).map_or(0.0, |sample| sample.values[i])));
            }
            let names = set.channels.iter().skip(first).take(4).map(Channel::name).collect::<Vec<_>>();
            rows.push((function.name().to_owned(), names));
        }
    }
    let srgb = set.channels.iter().all(|channel| matches!(channel, Channel::LinearSrgb(_)));
    let texts = [Metadata::new(set).line()?, line(&rows)?];
    Texture::new(set.texels, values, srgb, texts).bytes(precision)
}

/// A line of `width` texels of linear sRGB and alpha as KTX2, RGBA32F, that says what it is `about`.
pub(crate) fn texels_ktx2(width: usize, values: Vec<f64>, about: &str) -> Result<Vec<u8>, TablesError> {
    let texts = [
        line(&about.to_owned())?,
        line(&vec![("full".to_owned(), ["R", "G", "B", "1"].map(str::to_owned))])?,
    ];
    Texture::new(width, values, true, texts).bytes(Precision::F32)
}

impl Texture {
    /// With the keys `stratiform` and `stratiformRows` beside the format's own.
    pub(super) fn new(width: usize, values: Vec<f64>, srgb: bool, [metadata, rows]: [String; 2]) -> Self {
        let writer = format!("stratiform {}", env!("CARGO_PKG_VERSION"));
        let texts = [
            ("KTXorientation", "rd".to_owned()),
            ("KTXwriter", writer),
            ("stratiform", metadata),
            ("stratiformRows", rows),
        ];
        Self { width, values, srgb, texts }
    }

    pub(super) fn bytes(&self, precision: Precision) -> Result<Vec<u8>, TablesError> {
        let (format, size) = match precision {
            Precision::F16 => (97_u32, 2),
            Precision::F32 => (109, 4),
            Precision::F64 => {
                let reason = "f64 is no texture format: use f32 or f16".to_owned();
                return Err(TablesError::Container { format: "KTX2", reason });
            }
        };
        let descriptor = descriptor(size, self.srgb);
        let texts: Vec<u8> = self.texts.iter().flat_map(|(key, text)| entry(key, text)).collect();
        let texts_at = BEFORE_DESCRIPTOR + descriptor.len();
        // A level starts at a multiple of the texel's bytes.
        let level_at = (texts_at + texts.len()).next_multiple_of(4 * usize::from(size));
        let level: Vec<u8> = self.values.iter().flat_map(|value| component(*value, size)).collect();
        let height = self.values.len() / 4 / self.width;
        let mut file = MAGIC.to_vec();
        // Format, bytes of a component, width, height, no depth, no array, one face, one level, no supercompression.
        for word in [format, u32::from(size), self.width as u32, height as u32, 0, 0, 1, 1, 0] {
            file.extend(word.to_le_bytes());
        }
        for word in [BEFORE_DESCRIPTOR, descriptor.len(), texts_at, texts.len()] {
            file.extend((word as u32).to_le_bytes());
        }
        // No global data; the level's place, its bytes, the same uncompressed.
        for long in [0, 0, level_at, level.len(), level.len()] {
            file.extend((long as u64).to_le_bytes());
        }
        file.extend([descriptor, texts].concat());
        file.resize(level_at, 0);
        file.extend(level);
        Ok(file)
    }
}

fn component(value: f64, size: u8) -> Vec<u8> {
    match size {
        2 => half(value).to_le_bytes().to_vec(),
        _ => (value as f32).to_le_bytes().to_vec(),
    }
}

/// The data format descriptor: one basic block of four samples (Khronos Data Format Specification 1.3, 5).
fn descriptor(size: u8, srgb: bool) -> Vec<u8> {
    const BLOCK: u16 = 24 + 4 * 16;
    let mut bytes = u32::from(BLOCK + 4).to_le_bytes().to_vec();
    // Vendor Khronos, basic type; version 2.
    bytes.extend([0, 0, 0, 0, 2, 0]);
    bytes.extend(BLOCK.to_le_bytes());
    bytes.extend([MODEL_RGBSDA, u8::from(srgb), TRANSFER_LINEAR, 0]);
    // One texel to a block; all bytes in the first plane.
    bytes.extend([0, 0, 0, 0, 4 * size, 0, 0, 0, 0, 0, 0, 0]);
    for (i, channel) in [0_u8, 1, 2, 15].into_iter().enumerate() {
        let bits = 8 * size;
        bytes.extend((i as u16 * u16::from(bits)).to_le_bytes());
        bytes.extend([bits - 1, channel | FLOAT_SIGNED, 0, 0, 0, 0]);
        bytes.extend([(-1.0_f32).to_le_bytes(), 1.0_f32.to_le_bytes()].concat());
    }
    bytes
}

/// Length, key, text, each ended by 0, filled to a multiple of 4.
fn entry(key: &str, text: &str) -> Vec<u8> {
    let mut bytes = ((key.len() + text.len() + 2) as u32).to_le_bytes().to_vec();
    bytes.extend(key.bytes().chain([0]).chain(text.bytes()).chain([0]));
    bytes.resize(bytes.len().next_multiple_of(4), 0);
    bytes
}
