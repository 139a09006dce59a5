//! The chain itself.

use super::optics::Cloud;
use super::reference::{Media, Plan, TracedIncidence, fit_reference, orders_rows, points};
use super::stage::Workspace;
use super::{accepted, convergence, curves, input_error, notes, optics, published, quadrature};
use crate::CliError;
use crate::config::Config;
use crate::output::Talk;
use crate::progress;
use std::path::Path;
use stratiform_artifact::{
    MediumRecord, OpticsDocument, OrdersRow, ParametersDocument, Provenance, create_folder, hash_of,
    read_csv, read_json, write_csv, write_json,
};
use stratiform_codegen::{Inputs, PhaseRow, PhaseTables, ReferencePoint};
use stratiform_fit::Reference;
use stratiform_optics::phase::PhaseTable;

/// How far down the chain to go.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Target {
    /// Parameters.
    Fit,
    /// Everything, the report included.
    Report,
}

/// Runs every stage up to `target` in the folder `out` and returns the parameters.
///
/// # Errors
/// [`CliError`]; stages that were finished stay finished.
pub fn run(config: &Config, out: &Path, target: Target, talk: Talk) -> Result<ParametersDocument, CliError> {
    config.check_again()?;
    if target == Target::Report {
        config.check_span()?;
    }
    let provenance = provenance(config);
    let mut work = Workspace::open(out, &config.title, provenance.clone(), talk)?;
    work.stage("optics", &(&config.optics, config.transport.wavelength_um), |dir| {
        let spinner = progress::spinner("optics", talk.quiet);
        let files = optics::write(config, dir);
        spinner.finish_and_clear();
        files
    })?;
    let (document, cloud) = optics::read(config, out)?;
    stratiform_fit::ALBEDO
        .check("single_scattering_albedo", cloud.omega.get())
        .map_err(|error| CliError::from(error).at("the model that is fitted has no absorption"))?;
    let plans = [Plan::nodes(config, &cloud), Plan::between(config, &cloud)];
    let inputs = (work.hash_of_stage("optics"), &plans, &config.transport);
    work.stage("reference", &inputs, |dir| trace(config, &cloud, &plans, dir, talk))?;
    work.stage("fit", &(work.hash_of_stage("reference"), &provenance, &config.fit), |dir| {
        fit(config, &cloud, provenance.clone(), dir)
    })?;
    let parameters: ParametersDocument = read_json(&out.join("parameters.json"))?;
    if target == Target::Report {
        let before = ["optics", "reference", "fit"].map(|stage| work.hash_of_stage(stage));
        work.stage("codegen", &before, |dir| codegen(&parameters, &cloud, dir))?;
        work.stage("convergence", &(&before, &config.convergence), |dir| {
            convergence::write(config, &cloud, dir, talk)
        })?;
        work.stage(
            "quadrature",
            &(&config.optics, config.transport.wavelength_um, config.convergence.most_radii),
            |dir| quadrature::write(config, dir),
        )?;
        work.stage("notes", &(&before, &provenance, config.published_table), |dir| {
            notes(config, &document, &cloud, &parameters, &provenance, dir)
        })?;
        let inputs = ["optics", "reference", "fit", "convergence", "quadrature", "notes"]
            .map(|stage| work.hash_of_stage(stage));
        work.stage("report", &inputs, report)?;
    }
    work.save()?;
    Ok(parameters)
}

/// Provenance of everything that the chain writes.
pub fn provenance(config: &Config) -> Provenance {
    let hash = hash_of(&(&config.optics, &config.transport, &config.fit));
    let method = "half-space Monte Carlo; least squares on a fixed grid; std_error propagated from the photons' covariance";
    Provenance::new(hash, Some(config.transport.seed), method)
}

fn trace(
    config: &Config,
    cloud: &Cloud,
    plans: &[Plan; 2],
    dir: &Path,
    talk: Talk,
) -> Result<Vec<String>, CliError> {
    let media = Media::new(config, cloud)?;
    let bar = progress::bar(plans.iter().map(Plan::histories).sum(), "photons", talk.quiet);
    let nodes = plans[0].trace(&media, &|done| bar.set_position(done))?;
    let first = plans[0].histories();
    let between = plans[1].trace(&media, &|done| bar.set_position(first + done))?;
    bar.finish_and_clear();
    let references: Vec<Reference> = nodes.iter().map(|traced| fit_reference(config, traced)).collect();
    let metres = config.fit.thickness_m.metres();
    let rows = |traced: &[TracedIncidence]| {
        traced.iter().flat_map(|t| orders_rows(t, &metres)).collect::<Vec<OrdersRow>>()
    };
    let mut compared: Vec<ReferencePoint> = Vec::new();
    for traced in nodes.iter().chain(&between) {
        compared.extend(points(config, traced)?);
    }
    write_json(&dir.join("reference.json"), &references)?;
    write_csv(&dir.join("orders.csv"), &rows(&nodes))?;
    write_csv(&dir.join("orders_between.csv"), &rows(&between))?;
    write_csv(&dir.join("reference.csv"), &compared)?;
    Ok(["reference.json", "orders.csv", "orders_between.csv", "reference.csv"].map(str::to_owned).to_vec())
}

fn fit(config: &Config, cloud: &Cloud, provenance: Provenance, dir: &Path) -> Result<Vec<String>, CliError> {
    let references: Vec<Reference> = read_json(&dir.join("reference.json"))?;
    let medium = MediumRecord {
        wavelength_um: config.transport.wavelength_um,
        extinction_convention: config.transport.extinction_convention,
        extinction_per_m: cloud.extinction_per_m,
        single_scattering_albedo: cloud.omega.get(),
        asymmetry: cloud.asymmetry,
        theta_f_deg: config.optics.theta_f_deg,
        forward_fraction: cloud.phase.forward_fraction(config.optics.theta_f_deg).map_err(input_error)?,
    };
    let document = stratiform_fit::fit(&config.fit, &references, medium, provenance).map_err(input_error)?;
    write_json(&dir.join("parameters.json"), &document)?;
    write_csv(&dir.join("parameters.csv"), &document.csv_rows())?;
    Ok(vec!["parameters.json".to_owned(), "parameters.csv".to_owned()])
}

fn codegen(parameters: &ParametersDocument, cloud: &Cloud, dir: &Path) -> Result<Vec<String>, CliError> {
    let theta_f = parameters.medium.theta_f_deg;
    let modified = cloud.phase.modified(theta_f).map_err(input_error)?;
    let squared = modified.squared().map_err(input_error)?;
    let rows = |table: &PhaseTable| {
        let pairs = table.theta_deg().iter().zip(table.values());
        pairs.map(|(theta_deg, p)| PhaseRow { theta_deg: *theta_deg, p: *p }).collect()
    };
    let inputs = Inputs {
        parameters: parameters.clone(),
        phase: PhaseTables { full: rows(&cloud.phase), modified: rows(&modified), squared: rows(&squared) },
        reference: read_csv(&dir.join("reference.csv"))?,
    };
    let folder = dir.join("accepted");
    create_folder(&folder)?;
    accepted::write(&folder, &inputs)?;
    let files = stratiform_codegen::generate(&inputs).map_err(input_error)?;
    stratiform_codegen::write(&files, &dir.join("generated")).map_err(input_error)?;
    let emitted = files.keys().map(|name| format!("generated/{name}"));
    Ok(accepted::FILES.iter().map(|name| format!("accepted/{name}")).chain(emitted).collect())
}

fn notes(
    config: &Config,
    document: &OpticsDocument,
    cloud: &Cloud,
    parameters: &ParametersDocument,
    provenance: &Provenance,
    dir: &Path,
) -> Result<Vec<String>, CliError> {
    let notes = notes::gather(config, document, cloud, parameters, provenance, dir)?;
    write_json(&dir.join("notes.json"), &notes)?;
    let rows = published::rows(config.published_table)?;
    let curves = curves::write(dir, parameters, &rows)?;
    Ok(["notes.json".to_owned(), curves].into_iter().chain(published::write(dir, &rows)?).collect())
}

fn report(dir: &Path) -> Result<Vec<String>, CliError> {
    let summary = stratiform_report::build(dir).map_err(input_error)?;
    let relative = |path: &Path| path.strip_prefix(dir).unwrap_or(path).to_string_lossy().replace('\\', "/");
    Ok(summary.figures.iter().chain([&summary.page]).map(|path| relative(path)).collect())
}
