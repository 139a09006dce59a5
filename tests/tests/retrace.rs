//! The path tracer against a stored truth of its own, traced with 20 000 paths a pixel and another seed: a golden, so that a change of the tracer
//! or of a world that moves pictures is seen by whoever makes it. (What the tracer is held against that nobody here wrote is in
//! `pathtrace_against_solve.rs`.) Drawn anew by
//! `stratiform truth stratocumulus --size 32x18 --samples 20000 --seed 1 --out DIR`.
//!
//! Compared are the picture's mean and that of each contribution; a mean over 70 000 paths is normal enough for |z| < 5, so that eight such
//! numbers reject an unchanged tracer with a probability below 1e-5.

#![allow(clippy::unwrap_used, reason = "a test may stop where it fails")]

use stratiform_imaging::{Image, read_exr, srgb::luminance};
use stratiform_pathtrace::{Request, Stop, Truth, trace};
use stratiform_tests::root;
use stratiform_world::World;

fn world() -> World {
    let scene = stratiform_scene::named("stratocumulus").unwrap();
    let mut world = World::build(&scene, &root().join("fit-configs/scenes"), 0.0).unwrap();
    (world.camera.width, world.camera.height) = (32, 18);
    world
}

fn traced(world: &World) -> Truth {
    trace(world, &Request { stop: Stop::Samples(128), crop: None, seed: 2 }).unwrap()
}

/// Mean luminance and its standard error, from those of the pixels.
fn mean(image: &Image, std_error: &Image) -> (f64, f64) {
    let n = image.pixels().len() as f64;
    let light = |pixel: &[f32; 3]| luminance(pixel.map(f64::from));
    let sum: f64 = image.pixels().iter().map(light).sum();
    let squares: f64 = std_error.pixels().iter().map(|pixel| light(pixel) * light(pixel)).sum();
    (sum / n, squares.sqrt() / n)
}

/// The difference of the whole and of every contribution in standard errors; those that neither picture has are left out.
fn deviations(truth: &Truth) -> Vec<(&'static str, f64)> {
    let stored = read_exr(&root().join("fit-configs/render/truth/stratocumulus-32x18.exr")).unwrap();
    let layer = |name: &str| stored.layer(name).unwrap_or_else(|| panic!("no layer {name}"));
    let whole = ("all", mean(&truth.mean, &truth.std_error), mean(&stored.image, layer("std_error")));
    let parts = truth.parts.iter().map(|(part, image, error)| {
        let name = part.name();
        (name, mean(image, error), mean(layer(name), layer(&format!("{name}_std_error"))))
    });
    std::iter::once(whole)
        .chain(parts)
        .filter(|(_, (_, found), (_, stored))| *found > 0.0 && *stored > 0.0)
        .map(|(name, (a, error), (b, stored))| (name, (a - b) / (error * error + stored * stored).sqrt()))
        .collect()
}

#[test]
fn the_stored_truth_is_traced_again_and_a_sun_too_bright_is_seen() {
    let mut world = world();
    let same = deviations(&traced(&world));
    assert!(same.len() >= 6, "{same:?}");
    // The halo of this view is a part in 1e9 of the light, met by a handful of paths.
    for (name, z) in same.iter().filter(|(name, _)| *name != "halo") {
        assert!(z.abs() < 5.0, "{name}: {z}");
    }
    world.sun.irradiance = world.sun.irradiance.map(|e| 1.1 * e);
    let bright = deviations(&traced(&world));
    assert!(bright.iter().any(|(name, z)| *name == "all" && *z > 5.0), "{bright:?}");
}
