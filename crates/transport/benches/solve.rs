//! Time of the deterministic solver: `cargo bench -p stratiform-transport --bench solve`. Prints figures, asserts nothing.

#![allow(clippy::unwrap_used, clippy::print_stdout, reason = "a benchmark stops where it fails and prints")]

use std::path::Path;
use std::sync::Arc;
use std::time::Instant;
use stratiform_optics::phase::{Modified, Norm, PhaseTable};
use stratiform_quantities::{Incidence, SingleScatteringAlbedo};
use stratiform_transport::TraceMedium;
use stratiform_transport::solve::{SolveMedium, Solver};

/// Appendix B: angles in degrees; thicknesses of the paper's κ from 1 m to 1 km.
const ANGLES: [f64; 10] = [0.0, 10.0, 20.0, 30.0, 40.0, 50.0, 60.0, 70.0, 80.0, 90.0];
const EXTINCTION_PER_M: f64 = 0.046_18;

fn main() {
    let file = concat!(env!("CARGO_MANIFEST_DIR"), "/../../fit-configs/appendix-b/accepted/phase_full.csv");
    let cloud = Arc::new(PhaseTable::read(Path::new(file), Norm::Strict).unwrap());
    let full = SolveMedium::full(cloud.clone(), SingleScatteringAlbedo::CONSERVATIVE);
    let cut = Modified::new(cloud, 5.0).unwrap();
    let forward = cut.forward_fraction();
    let modified = TraceMedium::modified(Arc::new(cut), SingleScatteringAlbedo::CONSERVATIVE, forward);
    let media = [("full", full), ("modified", SolveMedium::from(&modified.unwrap()))];
    for (name, medium) in &media {
        for tolerance in [1e-5, 1e-6] {
            one_slab(name, medium, tolerance);
        }
    }
    appendix_b(&media);
}

/// Totals of one slab of the cloud, μ0 = 0.3, 0.6 and 1; preparation of the medium apart.
fn one_slab(name: &str, medium: &SolveMedium, tolerance: f64) {
    let start = Instant::now();
    let solver = Solver::new(medium.clone(), tolerance).unwrap();
    println!("{name}, {tolerance:e}: prepared in {:.1} ms", 1e3 * start.elapsed().as_secs_f64());
    let incidence = [0.3, 0.6, 1.0].map(|mu0| Incidence::beam(mu0).unwrap());
    for tau in [1.0, 5.0, 20.0, 100.0] {
        let first = median(|| solver.unsolved(), |solver| solver.totals(&[tau], &incidence).unwrap());
        let kept = solver.clone();
        let solved = kept.totals(&[tau], &incidence).unwrap();
        let further = median(|| (), |()| kept.totals(&[tau], &incidence).unwrap());
        let (streams, error) = (solved.streams(), solved.worst_error());
        println!(
            "{name}, {tolerance:e}, tau {tau}: first slab {first:.3} ms, further {further:.3} ms, {streams} streams, \
             error {error:.1e}"
        );
    }
}

/// Milliseconds of `work`, without `prepare`.
fn median<P, T>(prepare: impl Fn() -> P, work: impl Fn(P) -> T) -> f64 {
    let mut seconds: Vec<f64> = (0..51)
        .map(|_| {
            let prepared = prepare();
            let start = Instant::now();
            std::hint::black_box(work(prepared));
            start.elapsed().as_secs_f64()
        })
        .collect();
    seconds.sort_by(f64::total_cmp);
    1e3 * seconds[25]
}

/// Orders 0 to 2, tail and total at 10 angles and 20 thicknesses, both media, to 1e-5, preparation included.
fn appendix_b(media: &[(&str, SolveMedium)]) {
    let incidence: Vec<Incidence> =
        ANGLES.iter().map(|deg| Incidence::beam(libm::cos(deg.to_radians()).max(0.0)).unwrap()).collect();
    let incidence: Vec<Incidence> = incidence.into_iter().map(grazing_is_zero).collect();
    let tau: Vec<f64> = (0..20).map(|i| EXTINCTION_PER_M * libm::pow(1000.0, f64::from(i) / 19.0)).collect();
    let start = Instant::now();
    for (name, medium) in media {
        let each = Instant::now();
        let solved = Solver::new(medium.clone(), 1e-5).unwrap().orders(&tau, &incidence, 2).unwrap();
        let (streams, error) = (solved.streams(), solved.worst_error());
        println!(
            "Appendix B, {name}: {:.3} s, {streams} streams, error {error:.1e}",
            each.elapsed().as_secs_f64()
        );
    }
    println!("Appendix B, both media: {:.3} s", start.elapsed().as_secs_f64());
}

/// cos 90° is 6e-17 in double precision.
fn grazing_is_zero(incidence: Incidence) -> Incidence {
    match incidence {
        Incidence::Beam(mu0) if mu0.get() < 1e-15 => Incidence::beam(0.0).unwrap(),
        other => other,
    }
}
