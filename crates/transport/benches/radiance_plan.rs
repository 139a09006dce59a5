//! Time of the radiances that a radiance model is fitted to: `cargo bench -p stratiform-transport --bench radiance_plan`. Prints
//! figures, asserts nothing.

#![allow(clippy::unwrap_used, clippy::print_stdout, reason = "a benchmark stops where it fails and prints")]

use std::path::Path;
use std::sync::Arc;
use std::time::Instant;
use stratiform_optics::phase::{Norm, PhaseTable};
use stratiform_quantities::{Side, SingleScatteringAlbedo};
use stratiform_transport::solve::{RadianceOrder, RadianceSolver, Radiances, SolveMedium, View};

const TOLERANCE: f64 = 1e-3;

/// Suns and thicknesses in even steps, views scattered; the sun's aureole left out.
fn main() {
    let start = Instant::now();
    let file = concat!(env!("CARGO_MANIFEST_DIR"), "/../../fit-configs/appendix-b/accepted/phase_full.csv");
    let cloud = Arc::new(PhaseTable::read(Path::new(file), Norm::Strict).unwrap());
    let medium = SolveMedium::full(cloud, SingleScatteringAlbedo::CONSERVATIVE);
    let solver = RadianceSolver::new(medium, TOLERANCE).unwrap();
    println!("preparation: {:.3} s", start.elapsed().as_secs_f64());
    for (taus, suns, views) in [(12, 24, 14), (6, 12, 7)] {
        let tau: Vec<f64> =
            (0..taus).map(|i| 0.1 * libm::pow(3000.0, f64::from(i) / f64::from(taus - 1))).collect();
        let sun = |i: u32| 85.0 * f64::from(i) / f64::from(suns - 1);
        let suns: Vec<(f64, Vec<View>)> = (0..suns).map(|i| with_views(sun(i), i * views, views)).collect();
        let start = Instant::now();
        let solved = solver.radiance_of_suns(&tau, &suns).unwrap();
        let seconds = start.elapsed().as_secs_f64();
        let count: usize = suns.iter().map(|(_, views)| views.len() * tau.len()).sum();
        let (streams, error) = (solved[0].streams(), worst(&solved, &suns, tau.len()));
        println!("{count} radiances: {seconds:.3} s, up to {streams} streams, error up to {error:.1e}");
    }
}

fn with_views(theta_deg: f64, first: u32, count: u32) -> (f64, Vec<View>) {
    let sun = theta_deg.to_radians();
    let mut views = Vec::new();
    for n in first..first + count {
        let [a, b] = [0.754_877_666_246_692_7, 0.569_840_290_998_053_2]
            .map(|step| (0.5 + f64::from(n) * step).fract());
        let (theta, phi) = ((85.0 * a).to_radians(), std::f64::consts::PI * b);
        let cosine = libm::cos(sun) * libm::cos(theta) + libm::sin(sun) * libm::sin(theta) * libm::cos(phi);
        let sides = Side::BOTH.into_iter().filter(|side| *side == Side::Top || cosine < 0.9945);
        views.extend(sides.map(|side| View { side, mu: libm::cos(theta), phi_deg: phi.to_degrees() }));
    }
    (libm::cos(sun), views)
}

fn worst(solved: &[Radiances], suns: &[(f64, Vec<View>)], thicknesses: usize) -> f64 {
    let mut worst: f64 = 0.0;
    for (solved, (_, views)) in solved.iter().zip(suns) {
        for (t, v) in (0..thicknesses).flat_map(|t| (0..views.len()).map(move |v| (t, v))) {
            worst = worst.max(solved.estimate(t, 0, v, RadianceOrder::Total).std_error);
        }
    }
    worst
}
