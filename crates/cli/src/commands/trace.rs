//! `stratiform trace`: Monte Carlo fluxes per order, as CSV or JSON; with views, `traced_radiance`.

use crate::args::{Estimator, TraceArgs};
use crate::commands::{order_rows, traced_radiance};
use crate::medium::Medium;
use crate::output::{Data, Talk};
use crate::{CliError, interrupt, pipeline, progress};
use stratiform_artifact::{OrderResult, OrdersDocument, Provenance, hash_of, to_json};
use stratiform_quantities::{Incidence, Medium as Kind, Order};
use stratiform_transport::{Stop, TraceRequest, Traced};

/// Runs the command.
///
/// # Errors
/// [`CliError::Input`] for bad input; [`CliError::Unmet`], with the result, if the error asked for was not reached.
pub fn run(args: &TraceArgs, talk: Talk) -> Result<Data, CliError> {
    if !args.views.view_mu.is_empty() {
        return traced_radiance::run(args, talk);
    }
    let incidences = order_rows::parse_incidences(&args.slab.mu0)?;
    let requests: Vec<_> = incidences.iter().map(|incidence| request(args, *incidence)).collect();
    for request in &requests {
        request.check().map_err(pipeline::trace_error)?;
    }
    let medium = Medium::parse(&args.medium)?;

    let mut results = Vec::new();
    let mut worst: f64 = 0.0;
    for request in &requests {
        let bar = progress::bar(args.photons, &format!("mu0 {}", request.incidence), talk.quiet);
        let advanced = |done: u64, _total: u64| bar.set_position(done);
        let watch = interrupt::watch();
        let control = pipeline::control(&advanced, &watch);
        let traced = match args.estimator.unwrap_or(Estimator::HalfSpace) {
            Estimator::HalfSpace => stratiform_transport::trace_half_space(medium.traced(), request, control),
            Estimator::Plain => stratiform_transport::trace_plain(medium.traced(), request, control),
        }
        .map_err(pipeline::trace_error)?;
        bar.finish_and_clear();
        worst = worst.max(traced.worst_error());
        results.extend(rows(args, request.incidence, &traced));
    }
    if let Some(target) = args.std_error.filter(|target| worst > *target) {
        let photons = args.photons;
        let message = format!(
            "{photons} photons reach a standard error of {worst:.3e}, not {target:.3e}: raise --photons"
        );
        return Err(CliError::Unmet { message, data: render(args, &medium, results)? });
    }
    render(args, &medium, results)
}

fn request(args: &TraceArgs, incidence: Incidence) -> TraceRequest {
    let kind = if args.medium.modified.is_some() { Kind::Modified } else { Kind::Full };
    let stop = match args.std_error {
        Some(target) => Stop::StdError { target, max_photons: args.photons },
        None => Stop::Photons(args.photons),
    };
    let stream = pipeline::stream_of(incidence, kind);
    TraceRequest {
        tau: args.slab.tau.clone(),
        incidence,
        stop,
        max_order: args.orders,
        seed: args.seed,
        stream,
    }
}

fn rows(args: &TraceArgs, incidence: Incidence, traced: &Traced) -> Vec<OrderResult> {
    let orders = |index: usize| Order::rows(args.orders).map(move |order| (index, order));
    let row = |(index, order): (usize, Order)| {
        let (reflectance, transmittance) = traced.estimate(index, order);
        let photons = Some(traced.photons());
        OrderResult { tau: args.slab.tau[index], mu0: incidence, order, photons, reflectance, transmittance }
    };
    (0..args.slab.tau.len()).flat_map(orders).map(row).collect()
}

fn render(args: &TraceArgs, medium: &Medium, results: Vec<OrderResult>) -> Result<Data, CliError> {
    if args.json {
        let inputs =
            (medium.record(), &args.slab.tau, &args.slab.mu0, args.photons, args.std_error, args.orders);
        let method = match args.estimator.unwrap_or(Estimator::HalfSpace) {
            Estimator::HalfSpace => {
                "half-space Monte Carlo; std_error is one standard deviation of the mean, at least 1/(photons + 3)"
            }
            Estimator::Plain => "plain three-dimensional Monte Carlo; std_error as for half-space",
        };
        let document = OrdersDocument {
            schema: OrdersDocument::SCHEMA.to_owned(),
            medium: medium.record().clone(),
            provenance: Provenance::new(hash_of(&inputs), Some(args.seed), method),
            results,
        };
        return Ok(to_json(&document)?);
    }
    order_rows::csv(medium, results)
}
