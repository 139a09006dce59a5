//! The chain itself.

use super::cut::Cut;
use super::optics::Cloud;
use super::stage::Workspace;
use super::{
    accepted, agreement, angular_books, colour, convergence, curves, family, fluxes, halo, input_error,
    ladder, notes, optics, principal_plane, published, quadrature, radiance, source,
};
use crate::CliError;
use crate::config::{Config, Source};
use crate::output::{self, Talk};
use crate::{interrupt, progress};
use rayon::prelude::*;
use std::path::Path;
use stratiform_artifact::{
    LadderRow, OpticsDocument, ParametersDocument, Provenance, create_folder, read_csv, read_json, read_text,
    write_atomic, write_csv, write_json,
};
use stratiform_codegen::{Inputs, PhaseRow, PhaseTables};
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
    let work = Workspace::open(out, &config.title, provenance.clone(), talk)?;
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
    let chain = Chain { config, cloud: &cloud, provenance: &provenance, talk };
    match target {
        Target::Fit => chain.tables(&work)?,
        Target::Report => {
            side_by_side(&[&|| chain.witness(&work), &|| chain.colour(&work), &|| chain.results(&work)])?;
        }
    }
    let parameters = parameters(&work)?;
    if target == Target::Report {
        chain.finish(&work, &document, &parameters)?;
    }
    work.save()?;
    Ok(parameters)
}

/// Provenance of everything that the chain writes.
pub fn provenance(config: &Config) -> Provenance {
    source::provenance(config, config.transport.source)
}

/// Runs stages that do not depend on each other; all are done or have failed before the first error is returned.
fn side_by_side(stages: &[&(dyn Fn() -> Result<(), CliError> + Sync)]) -> Result<(), CliError> {
    let run = |stage: &&(dyn Fn() -> Result<(), CliError> + Sync)| match stage() {
        // The others may not look at the flag.
        Err(error @ CliError::Interrupted) => {
            output::finish(Err(error));
            interrupt::end()
        }
        result => result,
    };
    let results: Vec<Result<(), CliError>> = stages.par_iter().with_max_len(1).map(run).collect();
    results.into_iter().collect()
}

/// What every stage needs.
struct Chain<'a> {
    config: &'a Config,
    cloud: &'a Cloud,
    provenance: &'a Provenance,
    talk: Talk,
}

impl Chain<'_> {
    /// What the fluxes of `source` depend on.
    fn inputs(&self, work: &Workspace, source: Source) -> impl serde::Serialize + use<> {
        let transport = self.config.transport.that_counts(source);
        (work.hash_of_stage("optics"), fluxes::nodes(self.config), self.cloud.tau(self.config), transport)
    }

    /// Fluxes, and the model fitted to them.
    fn fluxes(&self, work: &Workspace) -> Result<(), CliError> {
        let Self { config, cloud, provenance, talk, .. } = *self;
        let inputs = self.inputs(work, config.transport.source);
        work.stage("reference", &inputs, |dir| source::write_reference(config, cloud, dir, talk))?;
        let inputs = (work.hash_of_stage("reference"), provenance, &config.fit);
        work.stage("fit", &inputs, |dir| self.fit(dir))
    }

    fn fit(&self, dir: &Path) -> Result<Vec<String>, CliError> {
        let references: Vec<Reference> = read_json(&dir.join("reference.json"))?;
        let document = source::fit(self.config, self.cloud, &references, self.provenance.clone())?;
        write_json(&dir.join("parameters.json"), &document)?;
        write_csv(&dir.join("parameters.csv"), &document.csv_rows())?;
        Ok(vec!["parameters.json".to_owned(), "parameters.csv".to_owned()])
    }

    /// The tables of the other effective radii; nothing where the config has none.
    fn family(&self, work: &Workspace) -> Result<(), CliError> {
        let Self { config, talk, .. } = *self;
        let Some(radii) = &config.family else {
            return work.without("family");
        };
        work.stage("family", &family::inputs(config, radii), |dir| family::write(config, radii, dir, talk))
    }

    /// The radiance model, where the config asks for it.
    fn radiance(&self, work: &Workspace) -> Result<(), CliError> {
        let Self { config, cloud, talk, .. } = *self;
        let Some(settings) = &config.radiance else { return work.without("radiance") };
        let inputs = (work.hash_of_stage("optics"), radiance::provenance(config, settings));
        work.stage("radiance", &inputs, |dir| radiance::write(config, settings, cloud, dir, talk))
    }

    /// All that is fitted.
    fn tables(&self, work: &Workspace) -> Result<(), CliError> {
        side_by_side(&[&|| self.radiance(work), &|| self.fluxes(work)])?;
        self.family(work)
    }

    /// All that is fitted, and what needs no witness.
    fn results(&self, work: &Workspace) -> Result<(), CliError> {
        let Self { config, cloud, .. } = *self;
        self.tables(work)?;
        let before = fitted(work);
        let beside = ["family", "radiance"].map(|stage| work.hash_of_stage(stage));
        let parameters = &parameters(work)?;
        let cut = &Cut::new(cloud, config.optics.theta_f_deg)?;
        side_by_side(&[
            &|| self.principal_plane(work, cut, parameters),
            &|| {
                let inputs = (&before, &beside, &config.codegen.targets);
                work.stage("codegen", &inputs, |dir| codegen(config, parameters, cloud, cut, dir))
            },
            &|| {
                work.stage("angular-books", &before, |dir| {
                    angular_books::write(config, cloud, cut, parameters, dir)
                })
            },
        ])
    }

    /// What holds the results against each other, and the report.
    fn finish(
        &self,
        work: &Workspace,
        document: &OpticsDocument,
        parameters: &ParametersDocument,
    ) -> Result<(), CliError> {
        let Self { config, cloud, provenance, talk, .. } = *self;
        let before = fitted(work);
        self.agreement(work, parameters)?;
        self.ladder(work, parameters)?;
        // These measure time, and have the machine to themselves.
        self.convergence(work, &before)?;
        work.stage("notes", &(&before, provenance, config.published_table), |dir| {
            notes(config, document, cloud, parameters, provenance, dir)
        })?;
        let inputs = [
            "optics",
            "reference",
            "fit",
            "agreement",
            "ladder",
            "convergence",
            "quadrature",
            "angular-books",
            "principal-plane",
            "notes",
        ]
        .map(|stage| work.hash_of_stage(stage));
        work.stage("report", &inputs, report)?;
        talk.say(format!("\n{}\n", ladder::table(&read_csv::<LadderRow>(&work.dir().join("ladder.csv"))?)));
        if let Some(agreement) = agreement::read(work.dir()) {
            talk.say(agreement);
        }
        Ok(())
    }

    /// Phase functions in colour; nothing where the config wants none.
    fn colour(&self, work: &Workspace) -> Result<(), CliError> {
        let Self { config, provenance, .. } = *self;
        if config.colour.is_off() {
            return work.without("colour");
        }
        work.stage("colour", &(&config.optics, &config.colour, provenance), |dir| colour::write(config, dir))
    }

    /// The other source; nothing where there are no photons.
    fn witness(&self, work: &Workspace) -> Result<(), CliError> {
        let Self { config, cloud, talk, .. } = *self;
        let Some(witness) = source::witness(config) else { return work.without("witness") };
        work.stage("witness", &self.inputs(work, witness), |dir| {
            source::write_witness(config, cloud, witness, dir, talk)
        })
    }

    /// Whether both sources agree.
    fn agreement(&self, work: &Workspace, parameters: &ParametersDocument) -> Result<(), CliError> {
        let Self { config, cloud, .. } = *self;
        let (Some(witness), Some(photons)) = (source::witness(config), config.transport.photons) else {
            return work.without("agreement");
        };
        let inputs = ["reference", "fit", "witness"].map(|stage| work.hash_of_stage(stage));
        work.stage("agreement", &(inputs, &config.fit), |dir| {
            let references: Vec<Reference> = read_json(&dir.join("witness/reference.json"))?;
            let provenance = source::provenance(config, witness);
            let other = source::fit(config, cloud, &references, provenance)?;
            let [solved, traced] = match witness {
                Source::Trace => [parameters, &other],
                Source::Solve => [&other, parameters],
            };
            agreement::write(dir, solved, traced, photons)
        })
    }

    fn ladder(&self, work: &Workspace, parameters: &ParametersDocument) -> Result<(), CliError> {
        let Self { config, cloud, .. } = *self;
        let folders = match config.transport.source {
            Source::Trace => ladder::Folders { solved: "witness", traced: Some("") },
            Source::Solve => {
                ladder::Folders { solved: "", traced: config.transport.photons.map(|_| "witness") }
            }
        };
        let device = ladder::Device::open();
        let stages = ["reference", "fit", "codegen", "witness"].map(|stage| work.hash_of_stage(stage));
        work.stage("ladder", &(stages, &config.fit, device.name()), |dir| {
            ladder::write(config, cloud, parameters, &folders, &device, dir)
        })
    }

    fn convergence(&self, work: &Workspace, before: &[String; 3]) -> Result<(), CliError> {
        let Self { config, cloud, talk, .. } = *self;
        let Some(settings) = &config.convergence else {
            work.without("convergence")?;
            return work.without("quadrature");
        };
        work.stage("convergence", &(before, settings), |dir| {
            convergence::write(config, settings, cloud, dir, talk)
        })?;
        let inputs = (&config.optics, config.transport.wavelength_um, settings.most_radii);
        work.stage("quadrature", &inputs, |dir| quadrature::write(config, settings.most_radii, dir))
    }
}

impl Chain<'_> {
    /// Radiance in the plane of the sun; nothing where the config does not ask for it.
    fn principal_plane(
        &self,
        work: &Workspace,
        cut: &Cut,
        parameters: &ParametersDocument,
    ) -> Result<(), CliError> {
        let Self { config, cloud, talk, .. } = *self;
        let Some(settings) = &config.principal_plane else { return work.without("principal-plane") };
        let stages = ["optics", "fit", "radiance"].map(|stage| work.hash_of_stage(stage));
        let inputs = (stages, settings, config.transport.seed);
        work.stage("principal-plane", &inputs, |dir| {
            principal_plane::write(config, settings, cloud, cut, parameters, dir, talk)
        })
    }
}

/// Hashes of the stages that lead to the parameters.
fn fitted(work: &Workspace) -> [String; 3] {
    ["optics", "reference", "fit"].map(|stage| work.hash_of_stage(stage))
}

/// The parameters that were fitted.
fn parameters(work: &Workspace) -> Result<ParametersDocument, CliError> {
    Ok(read_json(&work.dir().join("parameters.json"))?)
}

fn codegen(
    config: &Config,
    parameters: &ParametersDocument,
    cloud: &Cloud,
    cut: &Cut,
    dir: &Path,
) -> Result<Vec<String>, CliError> {
    let theta_f = parameters.medium.theta_f_deg;
    let rows = |table: &PhaseTable| {
        let pairs = table.theta_deg().iter().zip(table.values());
        pairs.map(|(theta_deg, p)| PhaseRow { theta_deg: *theta_deg, p: *p }).collect()
    };
    let inputs = Inputs {
        parameters: parameters.clone(),
        phase: PhaseTables {
            full: rows(&cloud.phase),
            modified: rows(&cut.wide),
            squared: rows(&cut.squared),
        },
        halo: halo::table(&cloud.phase, theta_f)?,
        radiance: config.radiance.iter().map(|_| read_json(&dir.join(radiance::FILE))).next().transpose()?,
        reference: read_csv(&dir.join("reference.csv"))?,
    };
    let folder = dir.join("accepted");
    create_folder(&folder)?;
    accepted::write(&folder, &inputs)?;
    if config.family.is_some() {
        let text = read_text(&dir.join(accepted::FAMILY))?;
        write_atomic(&folder.join(accepted::FAMILY), text.as_bytes())?;
    }
    let files = accepted::emitted(config, &inputs, &folder)?;
    stratiform_codegen::write(&files, &dir.join("generated")).map_err(input_error)?;
    let emitted = files.names().map(|name| format!("generated/{name}"));
    let family = config.family.iter().map(|_| accepted::FAMILY);
    let halo = inputs.halo.iter().map(|_| accepted::HALO);
    let kept = accepted::FILES.iter().copied().chain(family).chain(halo);
    Ok(kept.map(|name| format!("accepted/{name}")).chain(emitted).collect())
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
