//! `stratiform merge`: the shards of a trace into what one process prints.

use crate::CliError;
use crate::args::MergeArgs;
use crate::output::Data;
use crate::trace::RunParts;
use stratiform_transport::Share;

/// Runs the command.
///
/// # Errors
/// [`CliError::Input`] naming the file that is damaged, foreign, unfinished or doubled, or what is missing;
/// [`CliError::Unmet`], with the result, if the error asked for was not reached.
pub fn run(args: &MergeArgs) -> Result<Data, CliError> {
    let mut shares: Vec<(Share, String)> = Vec::new();
    let mut sum: Option<RunParts> = None;
    for path in &args.files {
        let place = path.display().to_string();
        let parts = RunParts::read(path)?;
        parts.check_complete().map_err(|error| error.at(&place))?;
        if let Some((share, twin)) = shares.iter().find(|(share, _)| *share == parts.share()) {
            return Err(CliError::Input(format!("{place}: is shard {share}, and so is {twin}")));
        }
        shares.push((parts.share(), place.clone()));
        match &mut sum {
            None => sum = Some(parts),
            Some(sum) => sum.merge(&parts).map_err(|error| error.at(&place))?,
        }
    }
    let Some(sum) = sum else { return Err(CliError::Input("no files to merge".to_owned())) };
    refuse_missing(&shares)?;
    sum.print(args.json)
}

/// Where all files are of N shards, names those that are not there.
fn refuse_missing(shares: &[(Share, String)]) -> Result<(), CliError> {
    let of = shares[0].0.of();
    if shares.len() as u64 == of || shares.iter().any(|(share, _)| share.of() != of) {
        return Ok(());
    }
    let absent = |number: &u64| shares.iter().all(|(share, _)| share.number() != *number);
    let mut names: Vec<String> = (1..=of).filter(absent).take(10).map(|k| format!("{k}/{of}")).collect();
    let missing = of - shares.len() as u64;
    if missing > names.len() as u64 {
        names.push("…".to_owned());
    }
    Err(CliError::Input(format!("{missing} of {of} shards are missing: {}", names.join(", "))))
}
