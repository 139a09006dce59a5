//! `stratiform trace --view-mu …`: radiance by Monte Carlo, as CSV or JSON in the schema of `solve`.

use crate::args::{Device, Estimator, TraceArgs};
use crate::commands::views;
use crate::medium::Medium;
use crate::output::{Data, Talk};
use crate::{CliError, interrupt, pipeline, progress};
use stratiform_artifact::{Provenance, RadianceDocument, RadianceResult, hash_of, to_csv, to_json};
use stratiform_transport::radiance::{RadianceRequest, check_views, trace_radiance};
use stratiform_transport::solve::View;

const METHOD: &str = "plain three-dimensional Monte Carlo, local estimates; value is pi L/(mu0 F0) without unscattered light; \
                      std_error is one standard deviation of the mean, one largest event that may have been missed included; \
                      settled says whether it is a measurement";

/// Runs the command.
///
/// # Errors
/// [`CliError::Input`] for bad input.
pub fn run(args: &TraceArgs, talk: Talk) -> Result<Data, CliError> {
    refuse_flux_options(args)?;
    let mu0 = views::cosines(&args.slab.mu0)?;
    let views = views::views(&args.views);
    let slabs: Vec<(f64, f64)> =
        args.slab.tau.iter().flat_map(|tau| mu0.iter().map(move |mu0| (*tau, *mu0))).collect();
    for slab in &slabs {
        check_views(&request(args, *slab), &views).map_err(pipeline::trace_error)?;
    }
    let medium = Medium::parse(&args.medium)?;
    let mut results = Vec::new();
    for slab in slabs {
        results.extend(trace(args, &medium, slab, &views, talk)?);
    }
    warn(&results, talk);
    if !args.json {
        return Ok(to_csv(&results)?);
    }
    let inputs = (
        medium.record(),
        &args.slab.tau,
        &mu0,
        (&args.views.view_mu, &args.views.phi),
        args.photons,
        args.orders,
    );
    let document = RadianceDocument {
        schema: RadianceDocument::SCHEMA.to_owned(),
        medium: medium.record().clone(),
        provenance: Provenance::new(hash_of(&inputs), Some(args.seed), METHOD),
        results,
    };
    Ok(to_json(&document)?)
}

fn refuse_flux_options(args: &TraceArgs) -> Result<(), CliError> {
    let refuse = |message: &str| Err(CliError::Input(message.to_owned()));
    if args.std_error.is_some() {
        return refuse("--std-error is for fluxes: with --view-mu, --photons alone says how long");
    }
    if args.spread.checkpoint.is_some() || args.spread.shard.is_some() {
        return refuse(
            "--checkpoint and --shard are for fluxes: radiance is summed in the order of the photons",
        );
    }
    if args.device == Device::Gpu {
        return refuse("--device gpu is for fluxes: radiance is traced on the processor");
    }
    if args.estimator == Some(Estimator::HalfSpace) {
        return refuse("--estimator half-space keeps no directions: radiance is scored by the plain tracer");
    }
    Ok(())
}

fn request(args: &TraceArgs, (tau, mu0): (f64, f64)) -> RadianceRequest {
    let hash = hash_of(&(tau, mu0, args.medium.modified.is_some()));
    RadianceRequest {
        tau,
        mu0,
        photons: args.photons,
        max_order: args.orders,
        seed: args.seed,
        stream: pipeline::stream_of_hash(&hash),
    }
}

fn trace(
    args: &TraceArgs,
    medium: &Medium,
    slab: (f64, f64),
    views: &[View],
    talk: Talk,
) -> Result<Vec<RadianceResult>, CliError> {
    let bar = progress::bar(args.photons, &format!("tau {} mu0 {}", slab.0, slab.1), talk.quiet);
    let advanced = |done: u64, _total: u64| bar.set_position(done);
    let watch = interrupt::watch();
    let control = pipeline::control(&advanced, &watch);
    let traced = trace_radiance(medium.traced(), &request(args, slab), views, control)
        .map_err(pipeline::trace_error)?;
    bar.finish_and_clear();
    let row = |(v, order)| {
        let (estimate, settled) = (traced.estimate(v, order), traced.is_settled(v, order));
        views::result(slab, &views[v], order, estimate, Some(settled))
    };
    let cells = (0..views.len()).flat_map(|v| traced.orders().map(move |order| (v, order)));
    Ok(cells.map(row).collect())
}

/// Says how many rows are not settled.
fn warn(results: &[RadianceResult], talk: Talk) {
    let unsettled = results.iter().filter(|row| row.settled == Some(false)).count();
    if unsettled > 0 {
        talk.say(format!(
            "{unsettled} of {} rows are not settled: too few of the rare large scores were met, and std_error is a guess; raise \
             --photons, or use --modified",
            results.len()
        ));
    }
}
