//! Scattering events per second by the number of threads, and the memory that photons take:
//! `cargo bench -p stratiform-transport --bench threads [-- ROUNDS]`. Prints figures, asserts nothing.
//!
//! HG 0.85, τ = 16, light from the zenith. Each round times every number of threads once, one after the other; beside it a loop
//! of random numbers that shares nothing, which tells what the machine had to give. Two rates are printed: on the wall, and with
//! the time taken off that threads were ready and waited for a processor (mean over the threads; Linux counts it), because
//! the machine had other work. What threads wait for each other stays in. The second says nothing of what threads on
//! two processors do to each other where they seldom ran at once: then the wall's best ratio is low.

#![allow(clippy::unwrap_used, clippy::print_stdout, reason = "a benchmark stops where it fails and prints")]

use rand::Rng;
use rand_pcg::Pcg32;
use rayon::prelude::*;
use rayon::{ThreadPool, ThreadPoolBuilder};
use std::sync::Arc;
use std::time::Instant;
use stratiform_optics::phase::HenyeyGreenstein;
use stratiform_quantities::{Asymmetry, Incidence, SingleScatteringAlbedo};
use stratiform_transport::{Control, Stop, TraceMedium, TraceRequest, trace_half_space};

/// One round of the tracer.
const PHOTONS: u64 = 1 << 20;
/// Random numbers of the loop, in pieces that threads take.
const WORDS: u64 = 1 << 26;
const PIECES: u64 = 256;

/// Work, and how much of it a second does with each number of threads, by round.
struct Scaling {
    unit: &'static str,
    work: fn(&TraceMedium) -> f64,
    rates: Vec<Vec<Rates>>,
}

/// Work per second.
struct Rates {
    wall: f64,
    /// Without waits for a processor.
    given: f64,
}

fn main() {
    // Cargo passes `--bench`.
    let rounds = std::env::args().skip(1).find_map(|argument| argument.parse().ok()).unwrap_or(25);
    let phase = Arc::new(HenyeyGreenstein::new(Asymmetry::new(0.85).unwrap()));
    let medium = TraceMedium::full(phase, SingleScatteringAlbedo::CONSERVATIVE);
    let pools = pools();
    let mut scalings = [
        Scaling {
            unit: "scattering events",
            work: scatterings,
            rates: pools.iter().map(|_| Vec::new()).collect(),
        },
        Scaling {
            unit: "random numbers",
            work: random_numbers,
            rates: pools.iter().map(|_| Vec::new()).collect(),
        },
    ];
    for _ in 0..rounds {
        for scaling in &mut scalings {
            for (pool, rates) in pools.iter().zip(&mut scaling.rates) {
                rates.push(pool.install(|| rate(|| (scaling.work)(&medium))));
            }
        }
    }
    scalings.iter().for_each(|scaling| scaling.print(&pools));
    memory(&medium);
}

/// What `work` says it did, per second.
fn rate(work: impl FnOnce() -> f64) -> Rates {
    let (start, waits) = (Instant::now(), waited());
    let done = work();
    let wall = start.elapsed().as_secs_f64();
    let waits = (waited() - waits) / rayon::current_num_threads() as f64;
    Rates { wall: done / wall, given: done / (wall - waits) }
}

/// Seconds that the threads of this pool were ready to run and did not; 0 where the system does not tell.
fn waited() -> f64 {
    let of_this_thread = || {
        let text = std::fs::read_to_string("/proc/thread-self/schedstat").ok()?;
        text.split_whitespace().nth(1)?.parse::<u64>().ok()
    };
    rayon::broadcast(|_| of_this_thread().unwrap_or(0)).iter().sum::<u64>() as f64 * 1e-9
}

/// Of 1, 2, 4 … threads and of one for each processor.
fn pools() -> Vec<ThreadPool> {
    let all = std::thread::available_parallelism().unwrap().get();
    let powers =
        std::iter::successors(Some(1), |threads| Some(2 * threads)).take_while(|&threads| threads < all);
    powers
        .chain([all])
        .map(|threads| ThreadPoolBuilder::new().num_threads(threads).build().unwrap())
        .collect()
}

fn scatterings(medium: &TraceMedium) -> f64 {
    let traced = trace_half_space(medium, &request(16.0, PHOTONS), Control::default()).unwrap();
    traced.mean_scatterings(0).value * traced.photons() as f64
}

fn request(tau: f64, photons: u64) -> TraceRequest {
    let (incidence, stop) = (Incidence::beam(1.0).unwrap(), Stop::Photons(photons));
    TraceRequest { tau: vec![tau], incidence, stop, max_order: 2, seed: 1, stream: 0 }
}

fn random_numbers(_: &TraceMedium) -> f64 {
    let piece = |piece| {
        let mut rng = Pcg32::new(piece, piece);
        (0..WORDS / PIECES).fold(0, |mixed, _| mixed ^ rng.next_u32())
    };
    let mixed: Vec<u32> = (0..PIECES).into_par_iter().map(piece).collect();
    std::hint::black_box(mixed);
    WORDS as f64
}

impl Scaling {
    fn print(&self, pools: &[ThreadPool]) {
        println!("{}, millions per second, and ratio to one thread", self.unit);
        println!("{:>8}{:>18}{:>18}{:>18}", "threads", "wall, best", "wall, median", "no waits, median");
        let views: [fn(&[Rates]) -> f64; 3] = [
            |rates| quantile(rates, |rates| rates.wall, 1),
            |rates| quantile(rates, |rates| rates.wall, 2),
            |rates| quantile(rates, |rates| rates.given, 2),
        ];
        for (pool, rates) in pools.iter().zip(&self.rates) {
            print!("{:>8}", pool.current_num_threads());
            for view in views {
                print!("{:>10.1}{:>8.3}", view(rates) * 1e-6, view(rates) / view(&self.rates[0]));
            }
            println!();
        }
    }
}

/// The best rate for `part` 1, the median for 2.
fn quantile(rates: &[Rates], of: fn(&Rates) -> f64, part: usize) -> f64 {
    let mut ascending: Vec<f64> = rates.iter().map(of).collect();
    ascending.sort_by(f64::total_cmp);
    ascending[(rates.len() - 1) / part]
}

/// The most memory that the process has held after ever more photons.
fn memory(medium: &TraceMedium) {
    println!("photons, tau 1: peak resident memory so far");
    for photons in [1_000_000, 10_000_000, 100_000_000] {
        trace_half_space(medium, &request(1.0, photons), Control::default()).unwrap();
        println!("{photons:>12}{:>12}", peak_memory().as_deref().unwrap_or("unknown"));
    }
}

/// Linux only.
fn peak_memory() -> Option<String> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"))?;
    Some(line.trim().to_owned())
}
