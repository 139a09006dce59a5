//! Paths a second over a bumpy layer, and the samples that a median error of 2 % takes. Prints figures; asserts nothing.

#![allow(clippy::unwrap_used, clippy::print_stdout, reason = "a program that prints figures")]

#[path = "../tests/worlds/mod.rs"]
mod worlds;

use glam::DVec3;
use stratiform_pathtrace::{Request, Stop, trace};
use stratiform_world::{HeightField, Map, Sky, World};

fn from_below(field: HeightField) -> World {
    let mut world = worlds::world(field, [worlds::paper(), worlds::paper(), worlds::paper()]);
    world.camera = worlds::camera(DVec3::new(0.0, 0.0, 2.0), worlds::towards(60.0, 20.0), 0.5, 64, 36);
    world.sky = Sky::Uniform([0.25 / std::f64::consts::PI; 3]);
    world.ground.albedo = worlds::ground([0.2; 3]);
    world
}

fn from_above(field: HeightField) -> World {
    let mut world = from_below(field);
    world.camera = worlds::camera(DVec3::new(0.0, 0.0, 3000.0), worlds::towards(120.0, 20.0), 0.5, 64, 36);
    world
}

fn wide() -> HeightField {
    let small = worlds::bumpy(512);
    HeightField::new(Map::new(512, 16_000.0, small.map().values().to_vec()).unwrap()).unwrap()
}

/// Seconds that all threads of this process have run (Linux: proc(5), clock ticks of 10 ms).
fn processor_seconds() -> f64 {
    let text = std::fs::read_to_string("/proc/self/stat").unwrap();
    let fields: Vec<f64> =
        text.rsplit(')').next().unwrap().split_whitespace().skip(11).map_while(|f| f.parse().ok()).collect();
    (fields[0] + fields[1]) / 100.0
}

fn main() {
    let samples: u64 = std::env::args().filter_map(|a| a.parse().ok()).next().unwrap_or(16);
    let flat = || HeightField::flat(250.0, 1000.0).unwrap();
    for (name, world) in [
        ("flat, below", from_below(flat())),
        ("bumps of 2 km, below", from_below(worlds::bumpy(64))),
        ("bumps of 2 km, above", from_above(worlds::bumpy(64))),
        ("bumps of 16 km, below", from_below(wide())),
        ("bumps of 16 km, above", from_above(wide())),
    ] {
        let run =
            |samples| trace(&world, &Request { stop: Stop::Samples(samples), crop: None, seed: 1 }).unwrap();
        let start = processor_seconds();
        run(2);
        let ready = processor_seconds() - start;
        let truth = run(samples);
        let seconds = processor_seconds() - start - 2.0 * ready;
        let paths = samples as f64 * (64 * 36) as f64;
        let wanted = samples as f64 * (truth.median_error / 0.02) * (truth.median_error / 0.02);
        let largest = truth.largest_share.iter().copied().fold(0.0, f32::max);
        let two_cores = 0.5 * wanted * 320.0 * 180.0 * seconds / paths;
        println!(
            "{name}: {:.0} paths a core second, median error {:.4} after {samples}; 2 % takes {wanted:.0} samples, at 320x180 \
             {two_cores:.0} s on two cores; largest share of one path {largest:.3}; ready in {ready:.2} s",
            paths / seconds,
            truth.median_error
        );
    }
}
