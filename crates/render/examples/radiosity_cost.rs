//! Device time of the exchange between ground and cloud, by side and pairs of passes.
//!
//! `cargo run --release -p stratiform-render --example radiosity_cost [-- FIELD_SIDE]`

#![allow(
    dead_code,
    clippy::unwrap_used,
    clippy::print_stdout,
    reason = "an example prints, and stops where it fails"
)]

#[path = "../tests/radiosity_common/mod.rs"]
mod radiosity_common;

use radiosity_common::{clouds, ice_in_land, world};
use stratiform_gpu::{Gpu, Pass};
use stratiform_render::radiosity::{Exchange, Step};
use stratiform_render::{Radiosity, Settings};

/// Runs, of which the fastest counts.
const RUNS: usize = 10;

/// Milliseconds of direct light, of sources, and of all gathers.
fn milliseconds(gpu: &Gpu, exchange: &Exchange) -> Option<[f64; 3]> {
    let steps = exchange.steps();
    let passes: Vec<Pass> = steps.iter().map(Step::pass).collect();
    let run = || gpu.time_passes(&passes).unwrap().map(|s| [s[0], s[1], s[2..].iter().sum::<f64>()]);
    let runs: Option<Vec<[f64; 3]>> = (0..RUNS).map(|_| run()).collect();
    runs.map(|runs| [0, 1, 2].map(|i| runs.iter().map(|run| 1e3 * run[i]).fold(f64::INFINITY, f64::min)))
}

fn main() {
    let field = std::env::args().nth(1).map_or(512, |side| side.parse().unwrap());
    let gpu = Gpu::new().unwrap();
    let world = world(clouds(1, field), ice_in_land(2, 256));
    println!("{}; height field {field} x {field}; fastest of {RUNS} runs, ms", gpu.adapter());
    let automatic = Settings::default().radiosity;
    let mut exchange = Exchange::new(&gpu, &world, &automatic).unwrap();
    let update = || {
        let start = std::time::Instant::now();
        exchange.update(&gpu, &world, &automatic).unwrap();
        1e3 * start.elapsed().as_secs_f64()
    };
    let fastest = std::iter::repeat_with(update).take(RUNS).fold(f64::INFINITY, f64::min);
    println!("another moment, on the CPU, {} pairs: {fastest:.2} ms", exchange.plan().passes);
    println!("{:>6}{:>8}{:>12}{:>12}{:>12}", "side", "pairs", "direct", "sources", "gathers");
    for side in [16, 32, 64] {
        for passes in [1, 3, 8] {
            let radiosity = Radiosity { side, passes: Some(passes), ..Settings::default().radiosity };
            let exchange = Exchange::new(&gpu, &world, &radiosity).unwrap();
            match milliseconds(&gpu, &exchange) {
                Some([direct, sources, gathers]) => {
                    println!("{side:>6}{passes:>8}{direct:>12.4}{sources:>12.4}{gathers:>12.4}");
                }
                None => println!("{side:>6}{passes:>8}   no time stamps on this adapter"),
            }
        }
    }
}
