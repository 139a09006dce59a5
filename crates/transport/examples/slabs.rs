//! Accuracy and time of the deterministic solver on the slabs that `scripts/compare-solvers.py` gives to other codes.
//!
//! Argument: a file for the Legendre moments (columns phase, l, chi). Prints a table: slab, tolerance (none: streams
//! given), streams per hemisphere, reflectance, transmittance, estimated error, and the least seconds of one call on
//! one thread: with all preparation from the moments; the first slab on prepared moments; a further slab of the medium.

#![expect(
    clippy::print_stdout,
    clippy::unwrap_used,
    reason = "a program that prints, or stops where it fails"
)]

use std::fmt::Write as _;
use std::path::Path;
use std::time::Instant;
use stratiform_optics::phase::{Norm, PhaseTable};
use stratiform_quantities::{Incidence, SingleScatteringAlbedo};
use stratiform_transport::solve::{SolveMedium, Solver};

const MU0: [f64; 4] = [1.0, 0.5, 0.3, 0.1];
const STREAMS: [usize; 8] = [4, 8, 12, 16, 24, 32, 48, 64];
const TOLERANCES: [f64; 6] = [1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8];

/// A slab: phase function, τ, ω.
const SLABS: [(&str, f64, f64); 8] = [
    ("isotropic", 1.0, 1.0),
    ("hg 0.85", 1.0, 1.0),
    ("hg 0.85", 16.0, 1.0),
    ("hg 0.85", 1.0, 0.9),
    ("hg 0.85", 16.0, 0.9),
    ("cloud C1", 5.0, 1.0),
    ("cloud C1", 64.0, 1.0),
    ("paper's cloud", 16.0, 1.0),
];

fn moments(phase: &str) -> Vec<f64> {
    match phase {
        "isotropic" => vec![1.0],
        "hg 0.85" => std::iter::successors(Some(1.0), |power| Some(power * 0.85)).take(160).collect(),
        "cloud C1" => deirmendjian(),
        _ => paper(),
    }
}

fn deirmendjian() -> Vec<f64> {
    let rows: Vec<(f64, f64)> = stratiform_reference_data::rows("deirmendjian-c1", "moments.csv").unwrap();
    rows.iter().map(|(l, beta)| beta / (2.0 * l + 1.0)).collect()
}

/// The moments that fluxes to 1e-6 need.
fn paper() -> Vec<f64> {
    let file = concat!(env!("CARGO_MANIFEST_DIR"), "/../../fit-configs/appendix-b/accepted/phase_full.csv");
    let table = PhaseTable::read(Path::new(file), Norm::Strict).unwrap();
    let medium = SolveMedium::full(std::sync::Arc::new(table), SingleScatteringAlbedo::CONSERVATIVE);
    let mut chi = Solver::new(medium, 1e-6).unwrap().moments().to_vec();
    chi[0] = 1.0;
    chi
}

/// Least of `repeats` times, and the result.
fn best<T>(repeats: usize, mut work: impl FnMut() -> T) -> (f64, T) {
    let mut timed = || {
        let start = Instant::now();
        let result = std::hint::black_box(work());
        (start.elapsed().as_secs_f64(), result)
    };
    let mut least = timed();
    for _ in 1..repeats {
        let next = timed();
        if next.0 < least.0 {
            least = next;
        }
    }
    least
}

fn main() {
    let path = std::env::args().nth(1).unwrap();
    let mut written = String::from("phase,l,chi\n");
    println!(
        "phase,tau,omega,mu0,tolerance,streams,reflectance,transmittance,error,seconds_from_moments,seconds_first,seconds_further"
    );
    let mut last = "";
    for (phase, tau, omega) in SLABS {
        let chi = moments(phase);
        if phase != last {
            chi.iter().enumerate().for_each(|(l, chi)| writeln!(written, "{phase},{l},{chi:e}").unwrap());
            last = phase;
        }
        let omega = SingleScatteringAlbedo::new(omega).unwrap();
        slab(phase, tau, &SolveMedium::from_moments(chi, omega).unwrap(), omega.get());
    }
    std::fs::write(path, written).unwrap();
}

fn slab(phase: &str, tau: f64, medium: &SolveMedium, omega: f64) {
    for mu0 in MU0 {
        let incidence = [Incidence::beam(mu0).unwrap()];
        for streams in STREAMS {
            let with = |solver: &Solver| solver.totals_with_streams(streams, &[tau], &incidence).unwrap()[0];
            let (seconds, (r, t)) = times(medium, 1e-6, with);
            println!("{phase},{tau},{omega},{mu0},,{streams},{r:.12},{t:.12},,{seconds}");
        }
        for tolerance in TOLERANCES {
            let with = |solver: &Solver| solver.totals(&[tau], &incidence).unwrap();
            let (seconds, solved) = times(medium, tolerance, with);
            let ((r, t), error, streams) = (solved.total(0, 0), solved.worst_error(), solved.streams());
            let [r, t] = [r.value, t.value];
            println!(
                "{phase},{tau},{omega},{mu0},{tolerance:e},{streams},{r:.12},{t:.12},{error:e},{seconds}"
            );
        }
    }
}

/// The three times as text, and the result.
fn times<T>(medium: &SolveMedium, tolerance: f64, with: impl Fn(&Solver) -> T) -> (String, T) {
    let prepare = || Solver::new(medium.clone(), tolerance).unwrap();
    let prepared = prepare();
    let (all, _) = best(5, || with(&prepare()));
    let first = (0..9).fold(f64::INFINITY, |least, _| {
        let fresh = prepared.unsolved();
        least.min(best(1, || with(&fresh)).0)
    });
    let (further, result) = best(9, || with(&prepared));
    (format!("{all:e},{first:e},{further:e}"), result)
}
