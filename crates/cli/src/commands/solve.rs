//! `stratiform solve`: deterministic fluxes, as CSV or JSON in the schema of `trace`; with views, `radiance`.

use crate::commands::{order_rows, radiance};
use crate::medium::Medium;
use crate::output::Data;
use crate::solve_args::SolveArgs;
use crate::{CliError, pipeline};
use stratiform_artifact::{OrderResult, OrdersDocument, Provenance, hash_of, to_json};
use stratiform_quantities::OpticalThickness;
use stratiform_transport::solve::{SolveMedium, Solved, Solver};

const METHOD: &str = "discrete ordinates with half-range Galerkin kernel; std_error is the estimated absolute error, \
                      not a standard deviation";

/// Default tolerance, absolute.
const TOLERANCE: f64 = 1e-6;

/// Runs the command.
///
/// # Errors
/// [`CliError::Input`] for bad input; [`CliError::Failed`] if the tolerance was not met.
pub fn run(args: &SolveArgs) -> Result<Data, CliError> {
    if !args.views.view_mu.is_empty() {
        return radiance::run(args);
    }
    let incidences = order_rows::parse_incidences(&args.slab.mu0)?;
    for tau in &args.slab.tau {
        OpticalThickness::new(*tau)?;
    }
    let medium = Medium::parse(&args.medium)?;
    let tolerance = args.tolerance.unwrap_or(TOLERANCE);
    let solver = Solver::new(SolveMedium::from(medium.traced()), tolerance).map_err(pipeline::trace_error)?;
    let solved = solver.orders(&args.slab.tau, &incidences, args.orders).map_err(pipeline::trace_error)?;
    let results = rows(&solved);
    if !args.json {
        return order_rows::csv(medium.record().medium, results);
    }
    let inputs = (medium.record(), &args.slab.tau, &args.slab.mu0, tolerance, args.orders);
    let method =
        format!("{METHOD}; {} streams per hemisphere, {} moments", solved.streams(), solved.moments());
    let document = OrdersDocument {
        schema: OrdersDocument::SCHEMA.to_owned(),
        medium: medium.record().clone(),
        provenance: Provenance::new(hash_of(&inputs), None, &method),
        results,
    };
    Ok(to_json(&document)?)
}

fn rows(solved: &Solved) -> Vec<OrderResult> {
    let mut rows = Vec::new();
    for (i, &mu0) in solved.incidence().iter().enumerate() {
        for (t, &tau) in solved.tau().iter().enumerate() {
            for (n, &order) in solved.orders().iter().enumerate() {
                let (reflectance, transmittance) = solved.estimate(i, t, n);
                rows.push(OrderResult { tau, mu0, order, photons: None, reflectance, transmittance });
            }
        }
    }
    rows
}
