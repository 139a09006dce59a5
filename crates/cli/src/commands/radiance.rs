//! `stratiform solve --view-mu …`: deterministic radiance, as CSV or JSON.

use crate::commands::views;
use crate::medium::Medium;
use crate::output::Data;
use crate::solve_args::SolveArgs;
use crate::{CliError, pipeline};
use stratiform_artifact::{Provenance, RadianceDocument, RadianceResult, hash_of, to_csv, to_json};
use stratiform_transport::solve::{RadianceOrder, RadianceSolver, Radiances, SolveMedium, View};

const METHOD: &str = "discrete ordinates per azimuthal mode, orders 1 and 2 with the full phase function; value is pi L/(mu0 F0) \
                      without unscattered light; std_error is the estimated absolute error, not a standard deviation";

/// Default tolerance: absolute below 1, relative above.
const TOLERANCE: f64 = 1e-3;

/// Runs the command.
///
/// # Errors
/// [`CliError::Input`] for bad input; [`CliError::Failed`] if the tolerance was not met.
pub fn run(args: &SolveArgs) -> Result<Data, CliError> {
    let mu0 = views::cosines(&args.slab.mu0)?;
    let orders = orders(args.orders)?;
    let views = views::views(&args.views);
    let tolerance = args.tolerance.unwrap_or(TOLERANCE);
    let medium = Medium::parse(&args.medium)?;
    let solver =
        RadianceSolver::new(SolveMedium::from(medium.traced()), tolerance).map_err(pipeline::trace_error)?;
    let solved = solver.radiance(&args.slab.tau, &mu0, &views).map_err(pipeline::trace_error)?;
    let results = rows((&args.slab.tau, &mu0, &views), &orders, &solved);
    if !args.json {
        return Ok(to_csv(&results)?);
    }
    let inputs = (
        medium.record(),
        &args.slab.tau,
        &mu0,
        (&args.views.view_mu, &args.views.phi),
        tolerance,
        args.orders,
    );
    let method = format!("{METHOD}; {} streams per hemisphere", solved.streams());
    let document = RadianceDocument {
        schema: RadianceDocument::SCHEMA.to_owned(),
        medium: medium.record().clone(),
        provenance: Provenance::new(hash_of(&inputs), None, &method),
        results,
    };
    Ok(to_json(&document)?)
}

/// Single orders listed, and the total.
fn orders(highest: u32) -> Result<Vec<RadianceOrder>, CliError> {
    match highest {
        0 => Ok(vec![RadianceOrder::Total]),
        1 => Ok(vec![RadianceOrder::One, RadianceOrder::Total]),
        2 => Ok(RadianceOrder::ALL.to_vec()),
        more => Err(CliError::Input(format!("orders = {more} is outside [0, 2] with --view-mu"))),
    }
}

fn rows(
    (tau, mu0, views): (&[f64], &[f64], &[View]),
    orders: &[RadianceOrder],
    solved: &Radiances,
) -> Vec<RadianceResult> {
    let mut rows = Vec::new();
    for (t, &tau) in tau.iter().enumerate() {
        for (s, &mu0) in mu0.iter().enumerate() {
            for (v, view) in views.iter().enumerate() {
                for &order in orders {
                    let estimate = solved.estimate(t, s, v, order);
                    rows.push(views::result((tau, mu0), view, order.into(), estimate, None));
                }
            }
        }
    }
    rows
}
