//! `stratiform phase-check`: what is wrong with somebody's phase table or constants.

use crate::CliError;
use crate::args::PhaseCheckArgs;
use crate::config::{Config, line_of};
use crate::output::Data;
use crate::pipeline::{self, input_error};
use serde::{Deserialize, Serialize};
use std::fmt::Write;
use std::path::Path;
use stratiform_artifact::{Extinction, Provenance, hash_of, read_json, read_text, to_json};
use stratiform_optics::OpticsConfig;
use stratiform_optics::droplets::DropletDistribution;
use stratiform_optics::ensemble::Ensemble;
use stratiform_tables::TablesError;
use stratiform_tables::diagnosis::{
    Check, Constants, Known, TableFacts, Verdict, check_constants, diagnose, tabulated,
};
use stratiform_tables::nearest::Blend;
use stratiform_tables::read::{Choice, read};

/// θ_f where neither the command line nor a config says.
const THETA_F_DEG: f64 = 5.0;

/// `--json`.
#[derive(Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct PhaseCheckDocument {
    /// `stratiform/phase-check/1`.
    schema: String,
    provenance: Provenance,
    /// The file, or the constants as typed.
    subject: String,
    passes: bool,
    /// Names of the checks that are wrong.
    faults: Vec<String>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    mie: Option<MieRecord>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    table: Option<TableFacts>,
    checks: Vec<Check>,
}

/// What the droplets' own phase function has.
#[derive(Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct MieRecord {
    wavelength_um: f64,
    theta_f_deg: f64,
    asymmetry: f64,
    forward_fraction: f64,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    extinction_per_m: Option<Extinction>,
}

/// The droplets' optics.
struct Reference {
    ensemble: Ensemble,
    extinction: Option<Extinction>,
}

/// Runs the command.
///
/// # Errors
/// [`CliError::Unmet`], with the findings, if something is wrong; [`CliError`] of bad input.
pub fn run(args: &PhaseCheckArgs) -> Result<Data, CliError> {
    let config = args.config.as_deref().map(Config::load).transpose()?;
    let theta_f_deg =
        args.theta_f.or(config.as_ref().map(|config| config.optics.theta_f_deg)).unwrap_or(THETA_F_DEG);
    let subject = Subject::of(args)?;
    let reference = reference(args, config, theta_f_deg)?;
    let document = look(args, &subject, reference.as_ref(), theta_f_deg)?;
    let data = if args.json { to_json(&document)? } else { text(&document) };
    if document.passes {
        return Ok(data);
    }
    let wrong = document.faults.join(", ");
    Err(CliError::Unmet { message: format!("{}: {wrong}", document.subject), data })
}

/// What is looked at.
struct Subject {
    name: String,
    constants: Option<Constants>,
}

impl Subject {
    fn of(args: &PhaseCheckArgs) -> Result<Self, CliError> {
        let blend = |blend| Some(Constants { blend: Some(blend), ..Constants::default() });
        let lengths =
            |what: &str, count: usize| CliError::Input(format!("--{what}: {count} numbers are needed"));
        if let Some(file) = &args.file {
            return Ok(Self { name: file.display().to_string(), constants: constants_of(file)? });
        }
        if let Some(g) = args.hg {
            return Ok(Self { name: format!("--hg {g}"), constants: blend(Blend::henyey_greenstein(g)) });
        }
        if !args.two_lobe.is_empty() {
            let [w, g1, g2] = args.two_lobe[..] else { return Err(lengths("two-lobe", 3)) };
            return Ok(Self {
                name: format!("--two-lobe {w},{g1},{g2}"),
                constants: blend(Blend::two_lobe(w, g1, g2)),
            });
        }
        let [w, g1, g2, alpha] = args.draine[..] else { return Err(lengths("draine", 4)) };
        let name = format!("--draine {w},{g1},{g2},{alpha}");
        Ok(Self { name, constants: blend(Blend { w, g1, g2, alpha }) })
    }
}

/// The constants of a file .toml or .json; other files are tables.
fn constants_of(file: &Path) -> Result<Option<Constants>, CliError> {
    let constants: Constants = match file.extension().and_then(|extension| extension.to_str()) {
        Some("json") => read_json(file)?,
        Some("toml") => {
            let text = read_text(file)?;
            toml::from_str(&text).map_err(|error| {
                let line = error.span().map_or(1, |span| line_of(&text, span.start));
                CliError::Input(format!("{}:{line}: {}", file.display(), error.message()))
            })?
        }
        _ => return Ok(None),
    };
    if constants.is_empty() {
        return Err(CliError::Input(format!("{}: no constants", file.display())));
    }
    Ok(Some(constants))
}

fn reference(
    args: &PhaseCheckArgs,
    config: Option<Config>,
    theta_f_deg: f64,
) -> Result<Option<Reference>, CliError> {
    let (mut optics, has_number) = match (config, args.r_eff, args.gamma, args.wavelength) {
        (Some(mut config), ..) => {
            config.optics.wavelengths_um = vec![args.wavelength.unwrap_or(config.transport.wavelength_um)];
            (config.optics, true)
        }
        (None, Some(effective_radius_um), Some(gamma), Some(wavelength)) => {
            let droplets = DropletDistribution::ModifiedGamma { effective_radius_um, gamma };
            (gamma_cloud(droplets, args.n0.unwrap_or(1.0), wavelength), args.n0.is_some())
        }
        (None, None, ..) if args.wavelength.is_none() => return Ok(None),
        _ => return Err(CliError::Input("--wavelength needs --config or --r-eff and --gamma".to_owned())),
    };
    optics.theta_f_deg = theta_f_deg;
    let ensemble = pipeline::optics::ensembles(&optics)?.into_iter().next();
    Ok(ensemble.map(|ensemble| Reference { extinction: has_number.then_some(ensemble.extinction), ensemble }))
}

fn gamma_cloud(droplets: DropletDistribution, number_density_per_cm3: f64, wavelength: f64) -> OpticsConfig {
    OpticsConfig {
        droplets,
        number_density_per_cm3,
        wavelengths_um: vec![wavelength],
        refractive_index: Default::default(),
        theta_f_deg: THETA_F_DEG,
        tolerance: Default::default(),
    }
}

fn look(
    args: &PhaseCheckArgs,
    subject: &Subject,
    reference: Option<&Reference>,
    theta_f_deg: f64,
) -> Result<PhaseCheckDocument, CliError> {
    let mie = reference.map(|reference| &reference.ensemble.phase);
    let fault = |error: TablesError| input_error(error).at(&subject.name);
    let raw = match (&subject.constants, &args.file) {
        (Some(constants), _) => match constants.phase().map_err(fault)? {
            Some(blend) => {
                Some(blend.phase().map_err(TablesError::from).and_then(|p| tabulated(&p)).map_err(fault)?)
            }
            None => None,
        },
        (None, Some(file)) => {
            let choice = Choice {
                column: args.column.clone(),
                wavelength: args.file_wavelength,
                effective_radius: args.file_r_eff,
            };
            Some(read(file, &choice).map_err(input_error)?)
        }
        (None, None) => None,
    };
    let (mut table, mut checks) = (None, Vec::new());
    if let Some(raw) = raw {
        let diagnosis = diagnose(&raw, mie, theta_f_deg).map_err(fault)?;
        (table, checks) = (Some(diagnosis.facts), diagnosis.checks);
    }
    if let Some(constants) = &subject.constants {
        checks.extend(of_constants(constants, reference, theta_f_deg).map_err(|e| e.at(&subject.name))?);
    }
    Ok(document(subject, reference, table, checks))
}

fn of_constants(
    constants: &Constants,
    reference: Option<&Reference>,
    theta_f_deg: f64,
) -> Result<Vec<Check>, CliError> {
    let single = [constants.asymmetry, constants.forward_fraction, constants.extinction_per_m];
    if single.iter().all(Option::is_none) {
        return Ok(Vec::new());
    }
    let Some(reference) = reference else {
        let message = "constants can be held against Mie only: say the droplets, by --config or --r-eff";
        return Err(CliError::Input(message.to_owned()));
    };
    if constants.extinction_per_m.is_some() && reference.extinction.is_none() {
        return Err(CliError::Input("an extinction coefficient needs --n0, the droplets per cm3".to_owned()));
    }
    let known = Known {
        phase: &reference.ensemble.phase,
        extinction_per_m: reference.extinction.map(|kappa| [kappa.paper, kappa.mie]),
    };
    check_constants(constants, &known, theta_f_deg).map_err(input_error)
}

fn document(
    subject: &Subject,
    reference: Option<&Reference>,
    table: Option<TableFacts>,
    checks: Vec<Check>,
) -> PhaseCheckDocument {
    let wrong = checks.iter().filter(|check| check.verdict == Verdict::Wrong);
    let mie = reference.map(|Reference { ensemble, extinction }| MieRecord {
        wavelength_um: ensemble.wavelength_um,
        theta_f_deg: ensemble.theta_f_deg,
        asymmetry: ensemble.asymmetry,
        forward_fraction: ensemble.forward_fraction,
        extinction_per_m: *extinction,
    });
    PhaseCheckDocument {
        schema: "stratiform/phase-check/1".to_owned(),
        provenance: Provenance::new(
            hash_of(&(&table, &mie, &checks)),
            None,
            "named checks within stated bounds",
        ),
        subject: subject.name.clone(),
        faults: wrong.map(|check| check.name.clone()).collect(),
        passes: checks.iter().all(|check| check.verdict == Verdict::Ok),
        mie,
        table,
        checks,
    }
}

fn text(document: &PhaseCheckDocument) -> String {
    let mut text = String::from("check             verdict  found       expected    bound       words\n");
    for check in &document.checks {
        let verdict = match check.verdict {
            Verdict::Ok => "ok",
            Verdict::Wrong => "WRONG",
            Verdict::Follows => "follows",
        };
        let [found, expected, bound] = [check.found, check.expected, check.bound].map(number);
        let from =
            check.follows_from.as_ref().map_or(String::new(), |cause| format!("follows from {cause}; "));
        let _ = writeln!(
            text,
            "{:<17} {verdict:<8} {found:<11} {expected:<11} {bound:<11} {from}{}",
            check.name, check.words
        );
    }
    text
}

/// Six significant digits at most.
fn number(value: Option<f64>) -> String {
    let Some(value) = value else { return "-".to_owned() };
    if value == 0.0 || (1e-4..1e6).contains(&value.abs()) {
        let text = format!("{value:.5}");
        return text.trim_end_matches('0').trim_end_matches('.').to_owned();
    }
    format!("{value:.4e}")
}
