//! `stratiform solve --view-mu …`: deterministic radiance, as CSV or JSON.

use crate::commands::order_rows;
use crate::medium::Medium;
use crate::output::Data;
use crate::solve_args::SolveArgs;
use crate::{CliError, pipeline};
use stratiform_artifact::{Provenance, RadianceDocument, RadianceResult, hash_of, to_csv, to_json};
use stratiform_quantities::{Incidence, Side};
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
    let mu0 = cosines(&args.slab.mu0)?;
    let orders = orders(args.orders)?;
    let views = views(args);
    let tolerance = args.tolerance.unwrap_or(TOLERANCE);
    let medium = Medium::parse(&args.medium)?;
    let solver =
        RadianceSolver::new(SolveMedium::from(medium.traced()), tolerance).map_err(pipeline::trace_error)?;
    let solved = solver.radiance(&args.slab.tau, &mu0, &views).map_err(pipeline::trace_error)?;
    let results = rows((&args.slab.tau, &mu0, &views), &orders, &solved);
    if !args.json {
        return Ok(to_csv(&results)?);
    }
    let inputs = (medium.record(), &args.slab.tau, &mu0, (&args.view_mu, &args.phi), tolerance, args.orders);
    let method = format!("{METHOD}; {} streams per hemisphere", solved.streams());
    let document = RadianceDocument {
        schema: RadianceDocument::SCHEMA.to_owned(),
        medium: medium.record().clone(),
        provenance: Provenance::new(hash_of(&inputs), None, &method),
        results,
    };
    Ok(to_json(&document)?)
}

fn cosines(words: &[String]) -> Result<Vec<f64>, CliError> {
    let cosine = |incidence| {
        match incidence {
        Incidence::Beam(mu0) => Ok(mu0.get()),
        Incidence::Diffuse => Err(CliError::Input(
            "--mu0 diffuse: radiance needs a sun; by reciprocity, what diffuse light sends towards mu is the reflectance \
             and transmittance that `solve --mu0` without views lists for that mu"
                .to_owned(),
        )),
    }
    };
    order_rows::parse_incidences(words)?.into_iter().map(cosine).collect()
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

/// Every μ at every azimuth, above and below.
fn views(args: &SolveArgs) -> Vec<View> {
    let azimuths = if args.phi.is_empty() { &[0.0][..] } else { &args.phi };
    let mut views = Vec::new();
    for &mu in &args.view_mu {
        for &phi_deg in azimuths {
            views.extend([Side::Top, Side::Bottom].map(|side| View { side, mu, phi_deg }));
        }
    }
    views
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
                    rows.push(RadianceResult {
                        tau,
                        mu0,
                        mu: view.mu,
                        phi_deg: view.phi_deg,
                        side: view.side,
                        order: order.into(),
                        value: estimate.value,
                        std_error: estimate.std_error,
                    });
                }
            }
        }
    }
    rows
}
