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
const ENOUGH: f64 = 0.002;

/// What is timed, in the words of the rows.
const TASKS: [&str; 3] = ["first", "further", "orders"];

/// Times a beam on `medium`. Thicknesses at which the tolerance is not met are left out.
///
/// # Errors
/// [`CliError`] if the medium cannot be prepared.
pub fn rows(medium: &SolveMedium, incidence: Incidence) -> Result<Vec<SolverCostRow>, CliError> {
    let solver = Solver::new(medium.clone(), TOLERANCE).map_err(super::trace_error)?;
    let mut rows = Vec::new();
    solver.prepare(STREAMS[STREAMS.len() - 1]);
    for streams in STREAMS {
        let call = |solver: &Solver, _| {
            solver.totals_with_streams(streams, &[THICKEST], &[incidence]).map(|_| streams)
        };
        rows.extend(timed(&solver, "streams", &TASKS[..2], &[THICKEST], call));
    }
    let lists = TAU.iter().map(|tau| ("tau", vec![*tau]));
    let lists = lists.chain(THICKNESSES.iter().map(|count| ("thicknesses", spread(*count))));
    for (against, tau) in lists {
        let call = |solver: &Solver, task| match task {
            "orders" => solver.orders(&tau, &[incidence], 2).map(|solved| solved.streams()),
            _ => solver.totals(&tau, &[incidence]).map(|solved| solved.streams()),
        };
        rows.extend(timed(&solver, against, &TASKS, &tau, call));
    }
    Ok(rows)
}

/// `count` thicknesses up to the largest, evenly spaced in their logarithm.
fn spread(count: u32) -> Vec<f64> {
    (1..=count).map(|i| THICKEST * libm::pow(1e-3, 1.0 - f64::from(i) / f64::from(count))).collect()
}

/// The fastest runs of `tasks`; none where the first one fails.
fn timed(
    solver: &Solver,
    against: &str,
    tasks: &[&'static str],
    tau: &[f64],
    call: impl Fn(&Solver, &'static str) -> Result<usize, TransportError>,
) -> Vec<SolverCostRow> {
    let kept = solver.unsolved();
    let mut rows = Vec::new();
    for &task in tasks {
        let mut best: Option<(f64, usize)> = None;
        let begin = Instant::now();
        for run in 0..REPEATS {
            let spent = begin.elapsed().as_secs_f64();
            // The first run of the first task leaves what the others find.
            let fresh = (run > 0 && task == TASKS[0]).then(|| solver.unsolved());
            let start = Instant::now();
            let Ok(streams) = call(fresh.as_ref().unwrap_or(&kept), task) else { break };
            let seconds = start.elapsed().as_secs_f64();
            best = best.filter(|best| best.0 <= seconds).or(Some((seconds, streams)));
            if spent + seconds > ENOUGH {
                break;
            }
        }
        let Some((seconds, streams)) = best else { break };
        rows.push(SolverCostRow {
            against: against.to_owned(),
            task: task.to_owned(),
            streams: streams as u64,
            tau: tau.iter().fold(0.0, |most, tau| tau.max(most)),
            thicknesses: tau.len() as u64,
            seconds,
        });
    }
    rows
}
