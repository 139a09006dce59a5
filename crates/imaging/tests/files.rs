//! What is written comes back, and what is no image is refused.

#![allow(clippy::unwrap_used, reason = "a test may stop where it fails")]

use std::fs;
use std::path::{Path, PathBuf};
use stratiform_imaging::{Curve, Image, ImagingError, Tone, read_exr, read_grey, read_png, srgb, write_exr};

fn folder() -> tempfile::TempDir {
    tempfile::tempdir().unwrap()
}

/// Of awkward size, with values from 0 to 3 and one negative.
fn picture() -> Image {
    let value = |i: usize| {
        [i as f32 * 0.02, 1.0 / (1.0 + i as f32), if i == 7 { -1e-3 } else { 3.0 / (i + 1) as f32 }]
    };
    Image::new(13, 7, (0..91).map(value).collect()).unwrap()
}

fn png(path: &Path, (width, height): (u32, u32), colour: png::ColorType, depth: png::BitDepth, data: &[u8]) {
    let mut out = Vec::new();
    let mut encoder = png::Encoder::new(&mut out, width, height);
    encoder.set_color(colour);
    encoder.set_depth(depth);
    encoder.write_header().unwrap().write_image_data(data).unwrap();
    fs::write(path, out).unwrap();
}

#[test]
fn exr_keeps_every_bit_and_layer() {
    let dir = folder();
    let path = dir.path().join("a.exr");
    let error = picture().map(|p| p.map(|v| v * 0.01));
    write_exr(&path, &picture(), &[("std_error", &error), ("multiple", &picture())], "seed 1").unwrap();
    let read = read_exr(&path).unwrap();
    assert_eq!(read.image, picture());
    assert_eq!(read.layer("std_error"), Some(&error));
    assert_eq!(read.further.len(), 2);
    assert!(read.comments.contains("irradiance") && read.comments.ends_with("seed 1"), "{}", read.comments);
    let again = dir.path().join("b.exr");
    write_exr(&again, &picture(), &[("std_error", &error), ("multiple", &picture())], "seed 1").unwrap();
    assert_eq!(fs::read(path).unwrap(), fs::read(again).unwrap(), "same input, same bytes");
}

/// Half a step of 8 bits is all that is lost, and the chunks say the exposure.
#[test]
fn png_is_the_tone_in_srgb() {
    let dir = folder();
    let path = dir.path().join("a.png");
    let tone = Tone { exposure_ev: -1.5, curve: Curve::Shoulder };
    picture().write_png(&path, &tone).unwrap();
    let read = read_png(&path).unwrap();
    for (shown, pixel) in read.pixels().iter().zip(picture().pixels()) {
        for (found, meant) in shown.iter().zip(tone.stored(*pixel)) {
            assert!((srgb::encode(f64::from(*found)) - meant).abs() < 0.5 / 255.0 + 1e-6);
        }
    }
    let decoder = png::Decoder::new(std::io::Cursor::new(fs::read(&path).unwrap()));
    let info = decoder.read_info().unwrap();
    let text: Vec<_> =
        info.info().uncompressed_latin1_text.iter().map(|t| (t.keyword.as_str(), t.text.as_str())).collect();
    assert!(text.iter().any(|(key, value)| *key == "Exposure" && value.starts_with("-1.5 EV")), "{text:?}");
    assert!(text.contains(&("Tone curve", "shoulder")));
}

#[test]
fn heights_come_from_png_and_exr() {
    let dir = folder();
    let file = |name: &str| dir.path().join(name);
    let sixteen: Vec<u8> = [0_u16, 1, 32_768, 65_535].iter().flat_map(|v| v.to_be_bytes()).collect();
    png(&file("16.png"), (2, 2), png::ColorType::Grayscale, png::BitDepth::Sixteen, &sixteen);
    let read = read_grey(&file("16.png")).unwrap();
    assert_eq!((read.width(), read.height()), (2, 2));
    assert_eq!(read.values(), [0.0, (1.0 / 65_535.0) as f32, (32_768.0 / 65_535.0) as f32, 1.0]);
    png(&file("8.png"), (2, 1), png::ColorType::Grayscale, png::BitDepth::Eight, &[51, 255]);
    assert_eq!(read_grey(&file("8.png")).unwrap().values(), [0.2, 1.0]);
    png(&file("bits.png"), (2, 1), png::ColorType::Grayscale, png::BitDepth::One, &[0b0100_0000]);
    assert_eq!(read_grey(&file("bits.png")).unwrap().values(), [0.0, 1.0]);
    png(&file("equal.png"), (1, 1), png::ColorType::Rgba, png::BitDepth::Eight, &[51, 51, 51, 9]);
    assert_eq!(read_grey(&file("equal.png")).unwrap().values(), [0.2]);
    // As a picture, the same byte is light through the curve of sRGB.
    assert!((f64::from(read_png(&file("equal.png")).unwrap().at(0, 0)[1]) - srgb::decode(0.2)).abs() < 1e-7);
    exr::prelude::write_rgb_file(file("c.exr"), 2, 2, |_, _| (1.0_f32, 2.0_f32, 3.0_f32)).unwrap();
    assert!(read_grey(&file("c.exr")).unwrap_err().to_string().contains("Y or a single one"));
    heights(&file("y.exr"), [0.0, 12.5, 250.0, 1.0]);
    assert_eq!(read_grey(&file("y.exr")).unwrap().values(), [0.0, 12.5, 250.0, 1.0]);
    assert_eq!(read_exr(&file("y.exr")).unwrap().image.at(1, 0), [12.5; 3]);
    heights(&file("nan.exr"), [0.0, 1.0, 2.0, f32::NAN]);
    assert!(read_grey(&file("nan.exr")).unwrap_err().to_string().contains("(1, 1)"));
}

fn heights(path: &PathBuf, values: [f32; 4]) {
    use exr::prelude::*;
    let channel = AnyChannel::new("Y", FlatSamples::F32(values.to_vec()));
    let channels = AnyChannels::sort(vec![channel].into());
    Image::from_channels((2, 2), channels).write().non_parallel().to_file(path).unwrap();
}

#[test]
fn pixels_that_are_no_numbers_are_not_written() {
    let dir = folder();
    let bad = picture().map(|p| if p[0] == 0.02 * 14.0 { [f32::INFINITY; 3] } else { p });
    let path = dir.path().join("a");
    let refused = [
        bad.write_png(&path, &Tone::default()),
        write_exr(&path, &bad, &[], ""),
        write_exr(&path, &picture(), &[("std_error", &bad)], ""),
    ];
    for result in refused {
        assert!(matches!(result, Err(ImagingError::NotFinite { x: 1, y: 1, .. })), "{result:?}");
    }
    let small = Image::new(1, 1, vec![[0.0; 3]]).unwrap();
    assert!(matches!(write_exr(&path, &picture(), &[("a", &small)], ""), Err(ImagingError::Unlike { .. })));
    assert_eq!(fs::read_dir(dir.path()).unwrap().count(), 0);
}

#[test]
fn what_is_no_image_is_refused_with_its_name() {
    let dir = folder();
    let path = dir.path().join("x.png");
    for content in [&b""[..], b"text", &[0x76, 0x2f, 0x31, 0x01, 2, 0, 0, 0]] {
        fs::write(&path, content).unwrap();
        for error in [read_png(&path).err(), read_exr(&path).err(), read_grey(&path).err()] {
            assert!(error.unwrap().to_string().contains("x.png"));
        }
    }
    assert!(read_png(&dir.path().join("none.png")).unwrap_err().to_string().contains("none.png"));
    picture().write_png(&path, &Tone::default()).unwrap();
    assert!(read_grey(&path).unwrap_err().to_string().contains("in colour"));
    let whole = fs::read(&path).unwrap();
    fs::write(&path, &whole[..whole.len() / 2]).unwrap();
    assert!(read_png(&path).is_err(), "cut in half");
}

/// A header that claims 100 000 columns is refused before memory is asked for.
#[test]
fn a_claim_of_too_many_pixels_is_refused() {
    let dir = folder();
    let path = dir.path().join("x.png");
    png(&path, (1, 1), png::ColorType::Grayscale, png::BitDepth::Eight, &[0]);
    let mut data = fs::read(&path).unwrap();
    data[16..20].copy_from_slice(&100_000_u32.to_be_bytes());
    let crc = crc32(&data[12..29]);
    data[29..33].copy_from_slice(&crc.to_be_bytes());
    fs::write(&path, data).unwrap();
    assert!(read_grey(&path).unwrap_err().to_string().contains("100000 x 1"));
}

/// As PNG wants it (ISO 3309).
fn crc32(data: &[u8]) -> u32 {
    !data.iter().fold(!0_u32, |mut crc, byte| {
        crc ^= u32::from(*byte);
        (0..8).for_each(|_| crc = if crc & 1 == 1 { crc >> 1 ^ 0xedb8_8320 } else { crc >> 1 });
        crc
    })
}
