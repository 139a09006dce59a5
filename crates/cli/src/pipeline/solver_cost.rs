//! `solver_cost.csv`: what total fluxes and orders cost with streams, thickness and number of thicknesses.

use crate::CliError;
use std::time::Instant;
use stratiform_artifact::SolverCostRow;
use stratiform_quantities::Incidence;
use stratiform_transport::TransportError;
use stratiform_transport::solve::{SolveMedium, Solver};

/// The accuracy at which thicknesses are compared.
const TOLERANCE: f64 = 1e-5;

const STREAMS: [usize; 7] = [12, 16, 24, 32, 48, 64, 96];
const TAU: [f64; 9] = [0.01, 0.1, 0.3, 1.0, 3.0, 10.0, 100.0, 1e3, 1e4];
const THICKNESSES: [u32; 4] = [1, 3, 10, 20];

/// Largest of several thicknesses.
const THICKEST: f64 = 100.0;

/// Runs of which the fastest counts, at most; no further one starts after `ENOUGH` seconds.
const REPEATS: usize = 3;
const ENOUGH: f64 = 0.005;

/// What is timed, in the words of the rows.
const TASKS: [&str; 3] = ["first", "further", "orders"];

/// Times a beam on `medium`. Thicknesses at which the tolerance is not met are left out.
///
/// # Errors
/// [`CliError`] if the medium cannot be prepared.
pub fn rows(medium: &SolveMedium, incidence: Incidence) -> Result<Vec<SolverCostRow>, CliError> {
    let solver = Solver::new(medium.clone(), TOLERANCE).map_err(super::trace_error)?;
    let mut rows = Vec::new();
    for streams in STREAMS {
        let call =
            |solver: &Solver| solver.totals_with_streams(streams, &[THICKEST], &[incidence]).map(|_| streams);
        let kept = solver.unsolved();
        if call(&kept).is_ok() {
            rows.extend(
                TASKS[..2].iter().filter_map(|task| timed(&kept, ("streams", task), &[THICKEST], call)),
            );
        }
    }
    let lists = TAU.iter().map(|tau| ("tau", vec![*tau]));
    let lists = lists.chain(THICKNESSES.iter().map(|count| ("thicknesses", spread(*count))));
    for (against, tau) in lists {
        let kept = solver.unsolved();
        if kept.totals(&tau, &[incidence]).is_err() {
            continue;
        }
        rows.extend(TASKS.iter().filter_map(|task| {
            let call = |solver: &Solver| match *task {
                "orders" => solver.orders(&tau, &[incidence], 2).map(|solved| solved.streams()),
                _ => solver.totals(&tau, &[incidence]).map(|solved| solved.streams()),
            };
            timed(&kept, (against, task), &tau, call)
        }));
    }
    Ok(rows)
}

/// `count` thicknesses up to the largest, evenly spaced in their logarithm.
fn spread(count: u32) -> Vec<f64> {
    (1..=count).map(|i| THICKEST * libm::pow(1e-3, 1.0 - f64::from(i) / f64::from(count))).collect()
}

/// The fastest run; `kept` has solved the slab before.
fn timed(
    kept: &Solver,
    (against, task): (&str, &str),
    tau: &[f64],
    call: impl Fn(&Solver) -> Result<usize, TransportError>,
) -> Option<SolverCostRow> {
    let mut best: Option<(f64, usize)> = None;
    let begin = Instant::now();
    for run in 0..REPEATS {
        if run > 0 && begin.elapsed().as_secs_f64() > ENOUGH {
            break;
        }
        let fresh = kept.unsolved();
        let solver = if task == "first" { &fresh } else { kept };
        let start = Instant::now();
        let streams = call(solver).ok()?;
        let seconds = start.elapsed().as_secs_f64();
        best = best.filter(|best| best.0 <= seconds).or(Some((seconds, streams)));
    }
    let (seconds, streams) = best?;
    Some(SolverCostRow {
        against: against.to_owned(),
        task: task.to_owned(),
        streams: streams as u64,
        tau: tau.iter().fold(0.0, |most, tau| tau.max(most)),
        thicknesses: tau.len() as u64,
        seconds,
    })
}
