//! `stratiform phase-check`: what is wrong with somebody's phase table or constants.

mod document;
mod droplets;
mod subject;

use crate::CliError;
use crate::args::{Convention, PhaseCheckArgs};
use crate::config::Config;
use crate::output::{Data, Talk};
use crate::pipeline::input_error;
use document::PhaseCheckDocument;
use droplets::Droplets;
use std::path::Path;
use stratiform_artifact::{to_json, write_csv};
use stratiform_tables::TablesError;
use stratiform_tables::diagnosis::{Check, Constants, Known, Question, check_constants, diagnose};
use stratiform_tables::read::{Normalisation, RawTable, Understanding};
use subject::Subject;

/// θ_f where neither the command line nor a config says.
const THETA_F_DEG: f64 = 5.0;

/// Runs the command.
///
/// # Errors
/// [`CliError::Unmet`], with the findings, if something is wrong; [`CliError`] of bad input.
pub fn run(args: &PhaseCheckArgs, talk: Talk) -> Result<Data, CliError> {
    let subject = Subject::of(args)?;
    let config = args.config.as_deref().map(Config::load).transpose()?;
    let of_config = config.as_ref().map(|config| config.optics.theta_f_deg);
    let theta_f_deg = args.theta_f.or(of_config).unwrap_or(THETA_F_DEG);
    let droplets = Droplets::of(args, config, theta_f_deg, talk)?;
    let document = look(args, &subject, droplets.as_ref(), theta_f_deg)?;
    let data = if args.json { to_json(&document)? } else { document.text() };
    if let (Some(out), Some(raw)) = (&args.repaired, &subject.table) {
        write_repaired(out, raw, &subject.name, droplets.as_ref())?;
        talk.say(format!("written to {}", out.display()));
    }
    if document.passes {
        return Ok(data);
    }
    Err(CliError::Unmet { message: format!("{}: {}", subject.name, document.faults.join(", ")), data })
}

/// Every check that the subject and what is known of the droplets allow.
fn look(
    args: &PhaseCheckArgs,
    subject: &Subject,
    droplets: Option<&Droplets>,
    theta_f_deg: f64,
) -> Result<PhaseCheckDocument, CliError> {
    let mie = droplets.map(|droplets| &droplets.ensemble.phase);
    let question = Question { theta_f_deg, normalisation: normalisation(args.normalisation) };
    let (mut facts, mut checks) = (None, Vec::new());
    if let Some(raw) = &subject.table {
        let fault = |error: TablesError| input_error(error).at(&subject.name);
        let diagnosis = diagnose(raw, mie, question).map_err(fault)?;
        (facts, checks) = (Some(diagnosis.facts), diagnosis.checks);
    }
    if let Some(constants) = subject.constants.filter(Constants::has_single) {
        let found = of_constants(&constants, droplets, theta_f_deg);
        checks.extend(found.map_err(|error| error.at(&subject.name))?);
    }
    Ok(PhaseCheckDocument::new(subject, droplets, facts, checks))
}

const fn normalisation(meant: Convention) -> Normalisation {
    match meant {
        Convention::MeanOne => Normalisation::MeanOne,
        Convention::PerSteradian => Normalisation::PerSteradian,
        Convention::PerCosine => Normalisation::PerCosine,
    }
}

fn of_constants(
    constants: &Constants,
    droplets: Option<&Droplets>,
    theta_f_deg: f64,
) -> Result<Vec<Check>, CliError> {
    let Some(droplets) = droplets else {
        let message = "constants can be held against Mie only: say the droplets, by --config or --r-eff";
        return Err(CliError::Input(message.to_owned()));
    };
    if constants.extinction_per_m.is_some() && droplets.extinction.is_none() {
        return Err(CliError::Input("an extinction coefficient needs --n0, the droplets per cm3".to_owned()));
    }
    let known = Known {
        phase: &droplets.ensemble.phase,
        extinction_per_m: droplets.extinction.map(|kappa| [kappa.paper, kappa.mie]),
    };
    check_constants(constants, &known, theta_f_deg).map_err(input_error)
}

/// The table with what is unusual about it undone.
fn write_repaired(
    out: &Path,
    raw: &RawTable,
    name: &str,
    droplets: Option<&Droplets>,
) -> Result<(), CliError> {
    if out.canonicalize().is_ok_and(|out| Path::new(name).canonicalize().is_ok_and(|file| file == out)) {
        return Err(CliError::Input(format!("--repaired {}: is the file that is looked at", out.display())));
    }
    let mie = droplets.map(|droplets| &droplets.ensemble.phase);
    let repaired = Understanding::of(raw, mie).and_then(|understood| understood.repaired(raw));
    Ok(write_csv(out, &repaired.map_err(input_error)?.rows())?)
}
