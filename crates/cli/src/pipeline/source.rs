//! What the model is fitted to: fluxes from the source that the config names; and the witness, the other source.

use super::fluxes::{Referred, between, nodes};
use super::optics::Cloud;
use super::photons::{self, Wanted};
use super::reference::{Media, Plan};
use super::{input_error, solved};
use crate::CliError;
use crate::config::{Config, Source};
use crate::output::Talk;
use crate::progress;
use std::path::Path;
use stratiform_artifact::{
    MediumRecord, OrdersRow, ParametersDocument, Provenance, create_folder, hash_of, write_csv, write_json,
};
use stratiform_codegen::ReferencePoint;
use stratiform_fit::Reference;

const TRACED: &str = "half-space Monte Carlo; least squares on a fixed grid; std_error propagated from the photons' covariance";
const SOLVED: &str = "discrete ordinates; least squares on a fixed grid; std_error is an estimated error, not a standard \
                      deviation: that of the fluxes, carried through the fit as a bound";

/// Provenance of what is fitted to `source`.
pub fn provenance(config: &Config, source: Source) -> Provenance {
    let hash = hash_of(&(&config.optics, config.transport.that_counts(source), &config.fit));
    match source {
        Source::Trace => Provenance::new(hash, config.transport.seed, TRACED),
        Source::Solve => Provenance::new(hash, None, SOLVED),
    }
}

/// The source that the table is not fitted to, where there are photons.
pub fn witness(config: &Config) -> Option<Source> {
    match config.transport.source {
        Source::Trace => Some(Source::Solve),
        Source::Solve => config.transport.photons.map(|_| Source::Trace),
    }
}

/// Writes the fluxes at the table's incidences and half-way from the config's source.
///
/// # Errors
/// [`CliError`] of the source, and [`CliError::Input`] if a file cannot be written.
pub fn write_reference(
    config: &Config,
    cloud: &Cloud,
    dir: &Path,
    talk: Talk,
) -> Result<Vec<String>, CliError> {
    let media = Media::new(config, cloud)?;
    let [at_nodes, half_way] = match config.transport.source {
        Source::Trace => traced(config, cloud, &media, talk)?,
        Source::Solve => solved_at(config, cloud, &media)?,
    };
    let metres = config.fit.thickness_m.metres();
    let rows = |list: &[Referred]| {
        list.iter().flat_map(|one| one.fluxes.orders_rows(&metres)).collect::<Vec<OrdersRow>>()
    };
    write_csv(&dir.join("orders.csv"), &rows(&at_nodes))?;
    write_csv(&dir.join("orders_between.csv"), &rows(&half_way))?;
    let mut files = vec!["orders.csv".to_owned(), "orders_between.csv".to_owned()];
    files.extend(write_fluxes(config, at_nodes, half_way, dir, "")?);
    Ok(files)
}

/// Writes the witness's fluxes to `witness/`: photons at the table's incidences, the solver's half-way too.
///
/// # Errors
/// As [`write_reference`].
pub fn write_witness(
    config: &Config,
    cloud: &Cloud,
    witness: Source,
    dir: &Path,
    talk: Talk,
) -> Result<Vec<String>, CliError> {
    let media = Media::new(config, cloud)?;
    let [at_nodes, half_way] = match witness {
        Source::Trace => [traced_at_nodes(config, cloud, &media, talk)?, Vec::new()],
        Source::Solve => solved_at(config, cloud, &media)?,
    };
    create_folder(&dir.join("witness"))?;
    write_fluxes(config, at_nodes, half_way, dir, "witness/")
}

/// `reference.json`, `reference_between.json` and `reference.csv` in `folder` of `dir`.
fn write_fluxes(
    config: &Config,
    at_nodes: Vec<Referred>,
    half_way: Vec<Referred>,
    dir: &Path,
    folder: &str,
) -> Result<Vec<String>, CliError> {
    let mut points: Vec<ReferencePoint> = Vec::new();
    for one in at_nodes.iter().chain(&half_way) {
        points.extend(one.fluxes.points(config)?);
    }
    let fitted = |list: Vec<Referred>| list.into_iter().map(|one| one.reference).collect::<Vec<Reference>>();
    let names = ["reference.json", "reference_between.json", "reference.csv"];
    let [nodes, between, all] = names.map(|name| format!("{folder}{name}"));
    write_json(&dir.join(&nodes), &fitted(at_nodes))?;
    write_json(&dir.join(&between), &fitted(half_way))?;
    write_csv(&dir.join(&all), &points)?;
    Ok(vec![nodes, between, all])
}

/// The table of parameters fitted to `references`.
///
/// # Errors
/// [`CliError::Input`] for references that do not belong to the config.
pub fn fit(
    config: &Config,
    cloud: &Cloud,
    references: &[Reference],
    provenance: Provenance,
) -> Result<ParametersDocument, CliError> {
    let medium = medium(config, cloud)?;
    stratiform_fit::fit(&config.fit, references, medium, provenance).map_err(input_error)
}

/// What artifacts say of the cloud.
///
/// # Errors
/// [`CliError::Input`] if θ_f is out of domain.
pub fn medium(config: &Config, cloud: &Cloud) -> Result<MediumRecord, CliError> {
    let theta_f_deg = config.optics.theta_f_deg;
    Ok(MediumRecord {
        wavelength_um: config.transport.wavelength_um,
        extinction_convention: config.transport.extinction_convention,
        extinction_per_m: cloud.extinction_per_m,
        single_scattering_albedo: cloud.omega.get(),
        asymmetry: cloud.asymmetry,
        theta_f_deg,
        forward_fraction: cloud.phase.forward_fraction(theta_f_deg).map_err(input_error)?,
    })
}

/// Both from the solver, in one go.
fn solved_at(config: &Config, cloud: &Cloud, media: &Media) -> Result<[Vec<Referred>; 2], CliError> {
    let mut rows = nodes(config);
    let count = rows.len();
    rows.extend(between(config));
    let mut at_nodes = solved::solve(config, media, &cloud.tau(config), &rows)?;
    let half_way = at_nodes.split_off(count);
    Ok([at_nodes, half_way])
}

/// Both from photons.
fn traced(config: &Config, cloud: &Cloud, media: &Media, talk: Talk) -> Result<[Vec<Referred>; 2], CliError> {
    let [photons, photons_between, seed] = config.transport.photons_and_seed_of_trace()?;
    let at_nodes = Plan::nodes(config, cloud, photons, seed);
    let half_way = Plan::between(config, cloud, photons_between, seed);
    let trace = |plan| trace(config, media, plan, Wanted::All, talk);
    Ok([trace(&at_nodes)?, trace(&half_way)?])
}

/// What is fitted, at the table's incidences, from photons.
fn traced_at_nodes(
    config: &Config,
    cloud: &Cloud,
    media: &Media,
    talk: Talk,
) -> Result<Vec<Referred>, CliError> {
    let Some((photons, seed)) = config.transport.photons.zip(config.transport.seed) else {
        return Ok(Vec::new());
    };
    trace(config, media, &Plan::nodes(config, cloud, photons, seed), Wanted::Fitted, talk)
}

fn trace(
    config: &Config,
    media: &Media,
    plan: &Plan,
    wanted: Wanted,
    talk: Talk,
) -> Result<Vec<Referred>, CliError> {
    let bar = progress::bar(plan.histories(), "photons", talk.quiet);
    let referred = photons::trace(config, media, plan, wanted, &|done| bar.set_position(done));
    bar.finish_and_clear();
    referred
}
