//! z of the half-space tracer against every published flux of `reference-data`.
//!
//! Arguments: photons (default 1e7), seed, part of the cases' names. Exit code 1 if any |z| exceeds 4.

#![expect(
    clippy::print_stdout,
    clippy::unwrap_used,
    reason = "a program that prints, or stops where it fails"
)]

#[path = "../tests/common/mod.rs"]
mod common;

use common::published::published;
use common::{exact, full, request};
use std::process::ExitCode;
use stratiform_quantities::Order;
use stratiform_stats::{Estimate, z_score};
use stratiform_transport::{Control, TraceRequest, trace_half_space};

fn line(name: &str, got: Estimate, published: f64) -> f64 {
    let z = z_score(got, exact(published));
    println!("{name:<32}{published:>12.6}{:>12.6}{:>12.1e}{z:>8.2}", got.value, got.std_error);
    z.abs()
}

fn main() -> ExitCode {
    let photons = std::env::args().nth(1).map_or(1e7, |text| text.parse().unwrap()) as u64;
    let seed = std::env::args().nth(2).map_or(1, |text| text.parse().unwrap());
    let part = std::env::args().nth(3).unwrap_or_default();
    println!("{:<32}{:>12}{:>12}{:>12}{:>8}", "case", "published", "traced", "std error", "z");
    let mut worst = 0.0_f64;
    for (stream, case) in (0..).zip(published()).filter(|(_, case)| case.name.contains(&part)) {
        let request = TraceRequest { stream, seed, ..request(&[case.tau], case.incidence, photons) };
        let medium = full(case.phase.clone(), case.omega);
        let traced = trace_half_space(&medium, &request, Control::default()).unwrap();
        let (r, t) = traced.estimate(0, Order::Total);
        worst = worst.max(line(&format!("{} R", case.name), r, case.reflectance));
        worst = worst.max(line(&format!("{} T", case.name), t, case.transmittance));
    }
    println!("largest |z| {worst:.2}, photons {photons}");
    if worst > 4.0 { ExitCode::FAILURE } else { ExitCode::SUCCESS }
}
