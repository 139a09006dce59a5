//! Every container read back: KTX2 by the crate `ktx2`, EXR by the crate `exr`'s reader, CSV and JSON by their crates.
//! npz, and all of them from Python and JavaScript: `scripts/read-tables.py`.

#![allow(clippy::unwrap_used, reason = "a test may stop where it fails")]

mod containers_common;

use containers_common::{parameters, set, three};
use half::f16;
use ktx2::dfd;
use stratiform_tables::TablesError;
use stratiform_tables::parameters::COLUMNS;
use stratiform_tables::set::SampledSet;
use stratiform_tables::write::*;

/// (row, texel, channel) of a KTX2's level, and its reader.
fn texels(bytes: &[u8], size: usize) -> (ktx2::Header, Vec<f64>) {
    let reader = ktx2::Reader::new(bytes).unwrap();
    let level = reader.levels().next().unwrap();
    let number = |bytes: &[u8]| match size {
        2 => f16::from_le_bytes(bytes.try_into().unwrap()).to_f64(),
        _ => f64::from(f32::from_le_bytes(bytes.try_into().unwrap())),
    };
    (reader.header(), level.data.chunks(size).map(number).collect())
}

#[test]
fn ktx2_reads_back_by_another_reader() {
    let sampled = three().sample(100).unwrap();
    let formats = [
        (Precision::F32, ktx2::Format::R32G32B32A32_SFLOAT, 4),
        (Precision::F16, ktx2::Format::R16G16B16A16_SFLOAT, 2),
    ];
    for (precision, format, size) in formats {
        let bytes = phase_ktx2(&sampled, precision).unwrap();
        let (header, values) = texels(&bytes, size);
        assert_eq!((header.format, header.type_size), (Some(format), size as u32));
        assert_eq!((header.pixel_width, header.pixel_height, header.level_count), (100, 3, 1));
        for (i, found) in values.iter().enumerate() {
            let (row, texel, channel) = (i / 400, i % 400 / 4, i % 4);
            let expected = sampled.rows[row].get(channel).map_or(0.0, |sample| sample.values[texel]);
            assert_eq!(*found, precision.stored(expected), "{row} {texel} {channel}");
        }
        let reader = ktx2::Reader::new(&bytes[..]).unwrap();
        let (expected, _) = dfd::Basic::from_format(format).unwrap();
        assert_eq!(reader.basic_dfd().unwrap().to_vec(), {
            let mut expected = expected;
            expected.color_primaries = None;
            expected.to_vec()
        });
        let writer = reader.writer().unwrap().trim_end_matches('\0');
        assert_eq!(writer, concat!("stratiform ", env!("CARGO_PKG_VERSION")));
        let (_, metadata) = reader.key_value_data().find(|(key, _)| *key == "stratiform").unwrap();
        let text = std::str::from_utf8(metadata).unwrap().trim_end_matches('\0');
        let metadata: Metadata = serde_json::from_str(text).unwrap();
        assert_eq!(metadata, Metadata::new(&sampled));
    }
}

/// Five channels stand in two groups of rows.
#[test]
fn more_than_four_channels_make_more_rows() {
    let hg = containers_common::henyey_greenstein;
    let sampled = set([0.1, 0.2, 0.3, 0.4, 0.5].map(hg).to_vec()).sample(64).unwrap();
    let (header, values) = texels(&phase_ktx2(&sampled, Precision::F32).unwrap(), 4);
    assert_eq!((header.pixel_width, header.pixel_height), (64, 6));
    let of = |row: usize, texel: usize| &values[4 * (64 * row + texel)..][..4];
    let p =
        |function: usize, channel: usize| Precision::F32.stored(sampled.rows[function][channel].values[9]);
    assert_eq!(of(1, 9), [p(1, 0), p(1, 1), p(1, 2), p(1, 3)]);
    assert_eq!(of(4, 9), [p(1, 4), 0.0, 0.0, 0.0]);
}

type FlatImage = exr::image::Image<exr::image::Layer<exr::image::AnyChannels<exr::image::FlatSamples>>>;

fn read_exr(bytes: &[u8]) -> FlatImage {
    use exr::prelude::*;
    read()
        .no_deep_data()
        .largest_resolution_level()
        .all_channels()
        .first_valid_layer()
        .all_attributes()
        .from_buffered(std::io::Cursor::new(bytes))
        .unwrap()
}

#[test]
fn exr_reads_back() {
    use exr::prelude::*;
    let sampled = three().sample(256).unwrap();
    let bytes = phase_exr(&sampled).unwrap();
    let image = read_exr(&bytes);
    let layer = &image.layer_data;
    assert_eq!((layer.size, layer.encoding.blocks), (Vec2(256, 3), Blocks::ScanLines));
    let names: Vec<_> = layer.channel_data.list.iter().map(|channel| channel.name.to_string()).collect();
    assert_eq!(names, ["532,5nm", "550nm", "650nm"]);
    for (channel, plane) in [2, 1, 0].into_iter().zip(&layer.channel_data.list) {
        let expected = sampled.rows.iter().flat_map(|row| row[channel].values.iter().map(|v| *v as f32));
        let FlatSamples::F32(found) = &plane.sample_data else { unreachable!("not f32") };
        assert_eq!(*found, expected.collect::<Vec<_>>());
    }
    let AttributeValue::Text(text) = &layer.attributes.other[&Text::from("stratiform")] else {
        unreachable!("no text")
    };
    assert_eq!(serde_json::from_str::<Metadata>(&text.to_string()).unwrap(), Metadata::new(&sampled));
}

#[test]
fn csv_and_json_keep_every_bit() {
    let sampled = three().sample(64).unwrap();
    let document: PhaseDocument = serde_json::from_slice(&phase_json(&sampled).unwrap()).unwrap();
    let values = |s: &SampledSet| -> Vec<Vec<Vec<f64>>> {
        s.rows.iter().map(|row| row.iter().map(|sample| sample.values.clone()).collect()).collect()
    };
    assert_eq!(document.p, values(&sampled));
    assert_eq!((document.theta_deg[0], document.theta_deg[63]), (0.0, 180.0));
    let bytes = phase_csv(&sampled).unwrap();
    let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).from_reader(&bytes[..]);
    assert_eq!(reader.headers().unwrap().get(5), Some("full_532p5nm"));
    for (i, row) in reader.deserialize().enumerate() {
        let row: Vec<f64> = row.unwrap();
        let expected = sampled.rows.iter().flatten().map(|sample| sample.values[i]);
        assert_eq!(row[3..], expected.collect::<Vec<_>>());
        assert_eq!(row[2], document.theta_deg[i]);
    }
}

#[test]
fn the_same_set_gives_the_same_bytes() {
    type Writer = fn(&SampledSet) -> Result<Vec<u8>, TablesError>;
    let writers: [Writer; 6] = [
        phase_csv,
        phase_json,
        phase_npz,
        phase_exr,
        |set| phase_ktx2(set, Precision::F32),
        |set| phase_ktx2(set, Precision::F16),
    ];
    for writer in writers {
        let write = || writer(&three().sample(128).unwrap()).unwrap();
        assert_eq!(write(), write());
    }
}

/// The table's columns in EXR and KTX2, and what a linear filter makes of them half-way.
#[test]
fn parameters_read_back_and_filter_as_emitted_code_does() {
    let table = parameters();
    let (header, values) = texels(&parameters_ktx2(&table, Precision::F32).unwrap(), 4);
    assert_eq!((header.pixel_width, header.pixel_height), (11, 2));
    let bytes = parameters_exr(&table).unwrap();
    let image = read_exr(&bytes);
    for (i, row) in table.rows.iter().enumerate() {
        let [mu_l, b, c, t, kappa_c, r] = row.columns().map(|value| Precision::F32.stored(value));
        assert_eq!(values[4 * i..][..4], [b, c, t, mu_l]);
        assert_eq!(values[4 * (11 + i)..][..4], [kappa_c, r, 0.0, mu_l]);
        for (name, value) in COLUMNS.iter().zip([mu_l, b, c, t, kappa_c, r]) {
            let plane =
                image.layer_data.channel_data.list.iter().find(|p| p.name.to_string() == *name).unwrap();
            assert_eq!(f64::from(plane.sample_data.value_by_flat_index(i).to_f32()), value, "{name}");
        }
    }
    // Emitted code mixes c as p q / (q + (p - q) w).
    let (p, q, w) = (table.rows[3].c, table.rows[4].c, 0.3);
    let filtered = 1.0 / ((1.0 - w) * table.rows[3].columns()[2] + w * table.rows[4].columns()[2]);
    assert!((filtered / (p * q / (q + (p - q) * w)) - 1.0).abs() < 1e-14);
}

#[test]
fn texels_out_of_domain_are_refused() {
    for texels in [0, 63, 1025] {
        let error = three().sample(texels).unwrap_err().to_string();
        assert_eq!(error, format!("texels = {texels} is outside [64, 1024]"));
    }
}

/// A function whose colour at 0° is that of a spectral line (0.5325 µm among 0.45 and 0.65): negative red, which no phase
/// function may have.
#[test]
fn colours_outside_the_gamut_are_refused_with_their_angle() {
    let hg = containers_common::henyey_greenstein;
    let grey = set([0.5, 0.5, 0.5, 0.5].map(hg).to_vec());
    assert!(grey.linear_srgb().is_ok());
    let green = set([0.0, 0.0, 0.9, 0.0].map(hg).to_vec());
    let error = green.linear_srgb().unwrap_err().to_string();
    assert!(error.starts_with("channel of linear sRGB at theta_deg = 0 = -"), "{error}");
    assert!(error.ends_with("is outside [0, infinity)"), "{error}");
    let two = set([0.5, 0.6].map(hg).to_vec()).linear_srgb().unwrap_err().to_string();
    assert_eq!(two, "wavelengths of a colour = 2 is outside [3, infinity)");
}

#[test]
fn values_that_a_container_cannot_hold_are_refused() {
    let sampled = three().sample(64).unwrap();
    let with = |value: f64| {
        let mut set = sampled.clone();
        set.rows[1][2].values[7] = value;
        set
    };
    type Writer = fn(&SampledSet) -> Result<Vec<u8>, TablesError>;
    let writers: [Writer; 5] =
        [phase_csv, phase_json, phase_npz, phase_exr, |set| phase_ktx2(set, Precision::F16)];
    for writer in writers {
        for value in [f64::NAN, f64::INFINITY] {
            let error = writer(&with(value)).unwrap_err();
            assert!(error.to_string().starts_with("p of squared at 532,5nm in f"), "{error}");
        }
    }
    let error = phase_ktx2(&with(65_520.0), Precision::F16).unwrap_err().to_string();
    assert_eq!(error, "p of squared at 532,5nm in f16 = 65520 is outside [-65504, 65504]");
    assert!(phase_ktx2(&with(65_520.0), Precision::F32).is_ok());
    assert!(phase_exr(&with(1e39)).is_err() && phase_npz(&with(1e39)).is_ok());
    assert!(phase_ktx2(&sampled, Precision::F64).is_err());
}

#[test]
fn parameters_out_of_domain_are_refused() {
    use stratiform_artifact::{ParametersDocument, read_json};
    let path = std::path::Path::new(containers_common::ACCEPTED).join("parameters.json");
    let document: ParametersDocument = read_json(&path).unwrap();
    type Damage = fn(&mut ParametersDocument);
    let damages: [(Damage, &str); 4] = [
        (|d| d.optical.rows[2].c.emitted = 0.0, "c = 0 is outside (0, infinity)"),
        (|d| d.optical.rows[2].b.emitted = f64::NAN, "b = NaN is outside"),
        (|d| d.optical.rows.swap(1, 2), "parameters: theta_l_deg must rise over two rows or more"),
        (|d| d.optical.rows.truncate(10), "parameters: the last row, and no other, must be `diffuse`"),
    ];
    for (damage, message) in damages {
        let mut damaged = document.clone();
        damage(&mut damaged);
        let error = stratiform_tables::parameters::ParameterTexels::new(&damaged).unwrap_err().to_string();
        assert!(error.starts_with(message), "{error}");
    }
}
