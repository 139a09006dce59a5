//! `stratiform fit` and `stratiform reproduce`: the chain, up to the parameters or to the end.

use crate::CliError;
use crate::args::StageArgs;
use crate::config::Config;
use crate::output::{Data, Talk};
use crate::pipeline::{self, Target};

/// Runs `fit`.
///
/// # Errors
/// As [`pipeline::run`].
pub fn fit(args: &StageArgs, talk: Talk) -> Result<Data, CliError> {
    chain(args, Target::Fit, talk)
}

/// Runs `reproduce`.
///
/// # Errors
/// As [`pipeline::run`], and [`CliError::Unmet`], with everything written, if the two sources disagree.
pub fn reproduce(args: &StageArgs, talk: Talk) -> Result<Data, CliError> {
    let data = chain(args, Target::Report, talk)?;
    talk.say(format!("report: {}", args.out.join("report.html").display()));
    match pipeline::read_agreement(&args.out).filter(|agreement| !agreement.agrees()) {
        Some(disagreement) => Err(CliError::Unmet { message: disagreement.to_string(), data }),
        None => Ok(data),
    }
}

fn chain(args: &StageArgs, target: Target, talk: Talk) -> Result<Data, CliError> {
    let mut config = Config::load(&args.config)?;
    if let Some(seed) = args.seed {
        config.transport.seed = Some(seed);
    }
    if let Some(photons) = args.photons {
        config.transport.photons = Some(photons);
    }
    let parameters = pipeline::run(&config, &args.out, target, talk)?;
    if args.json {
        return Ok(stratiform_artifact::to_json(&parameters)?);
    }
    let table = pipeline::parameter_table(&parameters, config.published_table)?;
    match config.family {
        None => Ok(table),
        Some(_) => Ok(format!("{table}\n{}", pipeline::family::summary(&args.out)?)),
    }
}
