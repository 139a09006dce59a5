//! Sights (mu_l, mu_v, v, tau) from stdin; nanoseconds per evaluation of the function that `cost_function` names to stdout,
//! one line per repeat.
#![allow(unexpected_cfgs)]

mod stratiform;
mod stratiform_halo;
mod stratiform_phase;
mod stratiform_radiance;
mod stratiform_shade;
mod stratiform_weights;

use std::hint::black_box;
use std::io::Read;
use std::time::Instant;

const WARM: usize = 50;
const REPEATS: usize = 401;

#[cfg(cost_function = "stratiform_radiance_top")]
fn function(s: &[f32; 4]) -> f32 {
    stratiform_radiance::stratiform_radiance_top(s[0], s[1], s[2], s[3], stratiform_radiance::STRATIFORM_LAMBERTIAN)
}

#[cfg(cost_function = "stratiform_radiance_bottom")]
fn function(s: &[f32; 4]) -> f32 {
    stratiform_radiance::stratiform_radiance_bottom(s[0], s[1], s[2], s[3], stratiform_radiance::STRATIFORM_ESCAPE)
}

#[cfg(cost_function = "stratiform_halo")]
fn function(s: &[f32; 4]) -> f32 {
    stratiform_halo::stratiform_halo(s[0], s[1], s[2], s[3])
}

#[cfg(cost_function = "stratiform_shade_top")]
fn function(s: &[f32; 4]) -> f32 {
    stratiform_shade::stratiform_shade_top(s[0], s[1], s[2], s[3])
}

#[cfg(cost_function = "stratiform_shade_bottom")]
fn function(s: &[f32; 4]) -> f32 {
    stratiform_shade::stratiform_shade_bottom(s[0], s[1], s[2], s[3])
}

// All sights share a thickness, so that its factors are computed once.
#[cfg(cost_function = "stratiform_shade_top_with")]
fn function(s: &[f32; 4]) -> f32 {
    let k = stratiform_shade::stratiform_shade_of_top(5.0 * stratiform_shade::STRATIFORM_SIMILARITY);
    stratiform_shade::stratiform_shade_top_with(k, s[0], s[1], s[2], 5.0)
}

fn main() -> std::io::Result<()> {
    let mut input = Vec::new();
    std::io::stdin().read_to_end(&mut input)?;
    let float = |four: &[u8]| f32::from_le_bytes([four[0], four[1], four[2], four[3]]);
    let sight = |s: &[u8]| [float(&s[..4]), float(&s[4..8]), float(&s[8..12]), float(&s[12..])];
    let sights: Vec<[f32; 4]> = input.chunks_exact(16).map(sight).collect();
    for repeat in 0..WARM + REPEATS {
        let start = Instant::now();
        let mut sum = 0.0;
        for sight in black_box(&sights) {
            sum += function(sight);
        }
        black_box(sum);
        if repeat >= WARM {
            println!("{:.3}", start.elapsed().as_nanos() as f64 / sights.len() as f64);
        }
    }
    Ok(())
}
