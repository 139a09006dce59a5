//! Fields and grounds: bounds, period, drift, evolution, files.

#![allow(clippy::unwrap_used, reason = "a test may stop where it fails")]

use std::path::Path;
use stratiform_imaging::{Image, write_exr};
use stratiform_scene::Scene;
use stratiform_world::{HeightField, Map, World};

const SCENES: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../fit-configs/scenes");

/// The default scene with these tables in place of its clouds and ground, its tables by their full path.
fn scene(clouds: &str, ground: &str) -> Result<Scene, String> {
    let text = std::fs::read_to_string(format!("{SCENES}/stratocumulus.toml")).unwrap();
    let (before, rest) = text.split_once("[clouds]").unwrap();
    let (_, after) = rest.split_once("[droplets]").unwrap();
    let (after, _) = after.split_once("[ground]").unwrap();
    let tables = format!("{SCENES}/../appendix-b");
    let text =
        format!("{before}[clouds]\ntables = {tables:?}\n{clouds}\n[droplets]{after}[ground]\n{ground}\n");
    Scene::parse(&text, "a.toml").map_err(|error| error.to_string())
}

fn build(folder: &Path, clouds: &str, ground: &str, moment_s: f64) -> Result<World, String> {
    World::build(&scene(clouds, ground)?, folder, moment_s).map_err(|error| error.to_string())
}

fn field(clouds: &str, moment_s: f64) -> HeightField {
    build(Path::new(""), clouds, "albedo = 0.2", moment_s).unwrap().field
}

fn places() -> impl Iterator<Item = (f64, f64)> {
    (0..300).map(|i| (53.7 * f64::from(i), 16_000.0 - 31.9 * f64::from(i * 7 % 300)))
}

const PATTERNS: [&str; 2] = ["pattern = \"stratocumulus\"\nside = 256", "pattern = \"ripples\"\nside = 256"];

/// The sum over the plane, by a lattice finer than the texels.
fn fine_mean(map: &Map<f64>) -> f64 {
    let many = 4 * map.side();
    let place = |i: usize| (i as f64 + 0.5) * map.extent_m() / many as f64;
    (0..many * many).map(|i| map.value(place(i % many), place(i / many))).sum::<f64>() / (many * many) as f64
}

#[test]
fn patterns_keep_their_bounds_their_cover_and_their_period() {
    for pattern in PATTERNS {
        for cover in [0.3, 0.6, 0.9] {
            let field = field(&format!("{pattern}\ncover = {cover}"), 0.0);
            let values = field.map().values();
            assert!(values.iter().all(|h| (0.0..=500.0).contains(h)) && field.most() > 495.0);
            let covered = values.iter().filter(|h| **h > 0.0).count() as f64 / values.len() as f64;
            assert!((covered - cover).abs() < 0.01, "{pattern}: {covered}, not {cover}");
            for (x, y) in places() {
                assert!((field.thickness(x, y) - field.thickness(x + 16_000.0, y - 32_000.0)).abs() < 1e-6);
            }
            let texels = values.iter().sum::<f64>() / values.len() as f64;
            assert!((fine_mean(field.map()) / texels - 1.0).abs() < 1e-12);
        }
    }
}

#[test]
fn a_closed_layer_is_nowhere_thinner_than_it_says() {
    let field = field("thickness_m = { min = 80.0, max = 300.0 }\nside = 64", 0.0);
    let least = field.map().values().iter().copied().fold(f64::INFINITY, f64::min);
    assert!((80.0..82.0).contains(&least) && field.most() <= 300.0);
}

#[test]
fn a_pattern_has_no_seam_and_no_step_at_the_texels() {
    for pattern in PATTERNS {
        let field = field(pattern, 0.0);
        let (n, h) = (field.map().side(), field.map().values());
        let step = |a: usize, b: usize| (h[a] - h[b]).abs();
        let across = |x: usize| (0..n).map(|y| step(y * n + x, y * n + (x + 1) % n)).fold(0.0, f64::max);
        let inside = (0..n - 1).map(across).fold(0.0, f64::max);
        assert!(inside < 150.0 && across(n - 1) <= inside, "{pattern}: {inside}");
    }
}

/// Ten texels in 625 s at 1 m/s: the same numbers ten columns to the east.
#[test]
fn wind_alone_shifts_the_pattern() {
    let clouds = format!("{}\nwind_m_per_s = [1.0, -2.0]", PATTERNS[0]);
    let (before, after) = (field(&clouds, 0.0), field(&clouds, 625.0));
    let (n, far) = (256, 10);
    for i in 0..n * n {
        let (x, y) = (i % n, i / n);
        let moved = after.map().values()[(y + n - 2 * far) % n * n + (x + far) % n];
        assert!((moved - before.map().values()[i]).abs() < 1e-6);
    }
}

#[test]
fn evolution_is_continuous_changes_the_pattern_and_keeps_its_cover() {
    for pattern in PATTERNS {
        let at = |moment_s: f64| field(&format!("{pattern}\ncover = 0.7\nevolution_s = 1000.0"), moment_s);
        let apart = |a: &HeightField, b: &HeightField| {
            let pairs = a.map().values().iter().zip(b.map().values());
            pairs.fold(0.0_f64, |most, (a, b)| most.max((a - b).abs()))
        };
        let now = at(400.0);
        assert!(apart(&now, &at(400.01)) < 0.2 && apart(&at(999.995), &at(1000.005)) < 0.2);
        assert!(apart(&now, &at(600.0)) > 200.0 && apart(&now, &at(1400.0)) < 1e-6);
        let values = now.map().values();
        let covered = values.iter().filter(|h| **h > 0.0).count() as f64 / values.len() as f64;
        assert!((covered - 0.7).abs() < 0.05, "{pattern}: {covered}");
    }
}

#[test]
fn a_flat_layer_is_flat() {
    let field = field("pattern = \"flat\"\nthickness_m = 120.0", 5.0);
    assert_eq!((field.map().values(), field.most()), (&[120.0][..], 120.0));
}

fn grey(folder: &Path, side: usize, values: &[f32]) {
    let pixels = values.iter().map(|value| [*value; 3]).collect();
    let image = Image::new(side, values.len() / side, pixels).unwrap();
    write_exr(&folder.join("a.exr"), &image, &[], "").unwrap();
}

/// An EXR of the one channel Y.
fn heights(folder: &Path, side: usize, values: &[f32]) {
    use exr::prelude::{
        AnyChannel, AnyChannels, Encoding, FlatSamples, Image, Layer, LayerAttributes, WritableImage,
    };
    let channel = AnyChannel::new("Y", FlatSamples::F32(values.to_vec()));
    let channels = AnyChannels::sort([channel].into_iter().collect());
    let layer = Layer::new(
        (side, values.len() / side),
        LayerAttributes::default(),
        Encoding::FAST_LOSSLESS,
        channels,
    );
    Image::from_layer(layer).write().to_file(folder.join("heights.exr")).unwrap();
}

fn png(folder: &Path, depth: png::BitDepth, bytes: &[u8]) {
    let file = std::fs::File::create(folder.join("a.png")).unwrap();
    let mut encoder = png::Encoder::new(file, 2, 2);
    encoder.set_color(png::ColorType::Grayscale);
    encoder.set_depth(depth);
    encoder.write_header().unwrap().write_image_data(bytes).unwrap();
}

#[test]
fn a_picture_of_heights_has_north_at_its_top() {
    let folder = tempfile::tempdir().unwrap();
    let clouds = "file = \"a.png\"\nscale_m = 100.0\n[layer]\noptical_thickness = { min = 1, max = 5 }";
    png(folder.path(), png::BitDepth::Sixteen, &[0, 0, 255, 255, 0, 1, 128, 0]);
    let world = build(folder.path(), clouds, "albedo = 0.2", 0.0).unwrap();
    let expected = [100.0 / 65_535.0, 100.0 * 32_768.0 / 65_535.0, 0.0, 100.0];
    for (found, expected) in world.field.map().values().iter().zip(expected) {
        assert!((found - expected).abs() < 1e-5);
    }
    png(folder.path(), png::BitDepth::Eight, &[0, 255, 51, 0]);
    let drift = format!("wind_m_per_s = [1.0, 0.0]\n{clouds}");
    let world = build(folder.path(), &drift, "albedo = 0.2", 8000.0).unwrap();
    for (found, expected) in world.field.map().values().iter().zip([0.0, 20.0, 100.0, 0.0]) {
        assert!((found - expected).abs() < 1e-5);
    }
}

#[test]
fn files_that_are_missing_odd_or_impossible_are_named() {
    let folder = tempfile::tempdir().unwrap();
    let layer = "[layer]\noptical_thickness = { min = 1, max = 5 }";
    let of = |file: &str, ground: &str| {
        build(folder.path(), &format!("file = \"{file}\"\nscale_m = 10.0\n{layer}"), ground, 0.0).unwrap_err()
    };
    assert!(of("b.png", "albedo = 0.2").contains("b.png"));
    png(folder.path(), png::BitDepth::Eight, &[0, 255, 51, 0]);
    let image = |values: &[f32], side: usize| {
        grey(folder.path(), side, values);
        build(folder.path(), "pattern = \"flat\"", "image = \"a.exr\"", 0.0)
    };
    assert!(image(&[0.5; 6], 3).unwrap_err().contains("a.exr: 3 x 2 pixels are not square"));
    let error = image(&[0.5, 0.5, -0.5, 0.5], 2).unwrap_err();
    assert!(error.contains("a.exr: albedo in column 0 of row 1") && error.contains("= -0.5"), "{error}");
    let error = image(&[0.5, 1.5, 0.5, 0.5], 2).unwrap_err();
    assert!(error.contains("column 1 of row 0"), "{error}");
    let ground = image(&[0.1, 0.2, 0.3, 0.4], 2).unwrap().ground.albedo;
    assert!((ground.values()[0][0] - 0.3).abs() < 1e-7 && (ground.values()[3][2] - 0.2).abs() < 1e-7);
}

#[test]
fn heights_that_are_impossible_are_named_with_their_place() {
    let folder = tempfile::tempdir().unwrap();
    let clouds = "file = \"heights.exr\"\nscale_m = 10.0\n[layer]\noptical_thickness = { min = 1, max = 5 }";
    let of = |values: &[f32]| {
        heights(folder.path(), 2, values);
        build(folder.path(), clouds, "albedo = 0.2", 0.0)
    };
    assert_eq!(of(&[1.0, 2.0, 3.0, 4.0]).unwrap().field.map().values(), [30.0, 40.0, 10.0, 20.0]);
    for (bad, says) in [(-1.0, "= -10"), (f32::NAN, "NaN"), (f32::INFINITY, "inf")] {
        let error = of(&[1.0, bad, 3.0, 4.0]).unwrap_err();
        assert!(error.contains("heights.exr") && error.contains(says), "{error}");
    }
    assert!(of(&[1.0, 2.0]).unwrap_err().contains("2 x 1 pixels are not square"));
}

#[test]
fn fields_refuse_what_is_no_thickness_and_name_the_texel() {
    for bad in [-1.0, f64::NAN, f64::INFINITY] {
        let error = HeightField::new(Map::new(2, 1.0, vec![0.0, 1.0, bad, 1.0]).unwrap()).unwrap_err();
        assert!(error.to_string().contains("texel (0, 1)"), "{error}");
    }
}

#[test]
fn patterns_of_the_ground_are_half_and_half() {
    let water = [0.04, 0.06, 0.08];
    for pattern in ["water-ice", "coast", "floes", "checker"] {
        let ground = format!("pattern = \"{pattern}\"\nalbedos = [[0.04, 0.06, 0.08], 0.6]\nside = 128");
        let albedo = build(Path::new(""), "pattern = \"flat\"", &ground, 0.0).unwrap().ground.albedo;
        let wet = albedo.values().iter().filter(|albedo| **albedo == water).count() as f64;
        assert!((wet / 16_384.0 - 0.5).abs() < 0.01, "{pattern}: {wet}");
        assert!(albedo.values().iter().all(|a| *a == water || *a == [0.6; 3]));
    }
    let ground = "pattern = \"water-ice\"\nextent_m = 32000.0";
    let albedo = build(Path::new(""), "pattern = \"flat\"", ground, 0.0).unwrap().ground.albedo;
    assert_eq!((albedo.value(8000.0, 5.0), albedo.value(24_000.0, 5.0)), (water, [0.6; 3]));
}
