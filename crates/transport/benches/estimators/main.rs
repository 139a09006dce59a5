//! What each estimator of fluxes is worth: figures of merit against analog scoring slab by slab, convergence, and what
//! reciprocity adds. `cargo bench -p stratiform-transport --bench estimators` prints a table of runs;
//! `-- FOLDER` behind it writes `estimators.csv`, `runs.csv`, `reciprocity.csv`, `convergence.csv` and `estimators.svg` there.
//! It stops if a mean is not what the solver says (false alarms: one seed in 1000).

#![allow(clippy::print_stdout, clippy::unwrap_used, reason = "a benchmark prints its figures and may stop")]

mod study;

use serde::Serialize;
use std::path::{Path, PathBuf};
use stratiform_artifact::{EstimatorErrorRow, create_folder, write_atomic, write_csv};
use stratiform_report::draw_estimators;
use stratiform_stats::family_threshold;
use stratiform_transport::TraceMedium;
use study::merits::{Case, MeritRow, RunRow, Study};
use study::sorted::{self, SortedRow};
use study::{ALL, convergence, media, truth};

/// Optical thicknesses whose rows are listed.
const BOTTOMS: [f64; 5] = [0.25, 1.0, 4.0, 16.0, 46.0];

/// Those of the paper's 20 thicknesses, 1 m to 1 km at 0.04618/m.
fn chain() -> Vec<f64> {
    (0..20).map(|i| 0.046_18 * libm::pow(1000.0, f64::from(i) / 19.0)).collect()
}

const ALPHA: f64 = 1e-3;

fn main() {
    let folder = std::env::args().skip(1).find(|argument| !argument.starts_with('-')).map(PathBuf::from);
    let media = [("hg 0.85", media::henyey_greenstein()), ("cloud beyond 5 deg", media::cloud())];
    let (merits, runs) = merits(&media);
    let reciprocity: Vec<SortedRow> = media
        .iter()
        .flat_map(|(phase, medium)| {
            [1.0, 4.0, 16.0].map(|tau| sorted::compare(phase, medium, tau, 4096, 1024))
        })
        .flatten()
        .collect();
    let convergence = convergence::convergence(&media[0].1, 1.0, 8..=16);
    print(&runs);
    assert_unbiased(&runs, &reciprocity);
    if let Some(folder) = folder {
        write(&folder, (&merits, &runs), &reciprocity, &convergence);
    }
}

/// Rows of the listed slabs, and runs of those and of the paper's.
fn merits(media: &[(&str, TraceMedium)]) -> (Vec<MeritRow>, Vec<RunRow>) {
    let chain = chain();
    let (mut merits, mut runs) = (Vec::new(), Vec::new());
    for (phase, medium) in media {
        for mu0 in [1.0, 0.5, 0.1] {
            let case = Case { phase, medium, mu0, bottoms: &BOTTOMS };
            let study = Study::new(&case, &ALL);
            merits.extend(study.merits());
            runs.extend(study.runs());
            let case = Case { bottoms: &chain, ..case };
            runs.extend(Study::new(&case, &ALL[..2]).runs());
        }
    }
    (merits, runs)
}

fn print(runs: &[RunRow]) {
    println!(
        "{:<19}{:>4}{:>6} {:<18}{:>9}{:>10}{:>16}{:>7}{:>6}",
        "phase", "mu0", "slabs", "estimator", "ns", "variance", "of", "merit", "z"
    );
    for run in runs {
        let of = format!("{} at {:.2}", run.worst_quantity, run.worst_tau);
        println!(
            "{:<19}{:>4}{:>6} {:<18}{:>9.0}{:>10.3}{of:>16}{:>7.2}{:>6.2}",
            run.phase,
            run.mu0,
            run.slabs,
            run.estimator,
            run.flights_per_photon * run.ns_per_flight,
            run.worst_variance,
            run.merit,
            run.largest_z
        );
    }
}

fn assert_unbiased(runs: &[RunRow], reciprocity: &[SortedRow]) {
    let tests = runs.iter().map(|run| run.rows as usize).sum::<usize>() + 3 * reciprocity.len();
    let z: Vec<f64> =
        runs.iter().map(|run| run.largest_z).chain(reciprocity.iter().map(|row| row.largest_z)).collect();
    let (largest, threshold) = (truth::largest(&z), family_threshold(ALPHA, tests).unwrap());
    println!("largest |z| of {tests} means: {largest:.2}, allowed {threshold:.2}");
    assert!(largest <= threshold, "an estimator is biased");
}

fn write(
    folder: &Path,
    (merits, runs): (&[MeritRow], &[RunRow]),
    sorted: &[SortedRow],
    errors: &[EstimatorErrorRow],
) {
    fn table<T: Serialize>(folder: &Path, name: &str, rows: &[T]) {
        write_csv(&folder.join(name), rows).unwrap();
    }
    create_folder(folder).unwrap();
    table(folder, "estimators.csv", merits);
    table(folder, "runs.csv", runs);
    table(folder, "reciprocity.csv", sorted);
    table(folder, "convergence.csv", errors);
    let (name, svg) = draw_estimators(errors);
    write_atomic(&folder.join(name), svg.as_bytes()).unwrap();
}
