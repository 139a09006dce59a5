//! `stratiform merge`: the shards of a trace into what one process prints.

use crate::CliError;
use crate::args::MergeArgs;
use crate::output::Data;
use crate::trace::RunParts;
use std::collections::HashMap;
use stratiform_transport::Share;

/// Runs the command.
///
/// # Errors
/// [`CliError::Input`] naming the file that is damaged, foreign, unfinished or doubled, or what is missing;
/// [`CliError::Unmet`], with the result, if the error asked for was not reached.
pub fn run(args: &MergeArgs) -> Result<Data, CliError> {
    let mut files: HashMap<Share, String> = HashMap::new();
    let mut sum: Option<RunParts> = None;
    for path in &args.files {
        let place = path.display().to_string();
        let parts = RunParts::read(path)?;
        parts.check_complete().map_err(|error| error.at(&place))?;
        let share = parts.share();
        if let Some(twin) = files.insert(share, place.clone()) {
            return Err(CliError::Input(format!("{place}: is shard {share}, and so is {twin}")));
        }
        match &mut sum {
            None => sum = Some(parts),
            Some(sum) => sum.merge(&parts).map_err(|error| error.at(&place))?,
        }
    }
    let Some(sum) = sum else { return Err(CliError::Input("no files to merge".to_owned())) };
    refuse_missing(&files, sum.share().of())?;
    sum.print(args.json)
}

/// Where all files are of `of` shards, names those that are not there.
fn refuse_missing(files: &HashMap<Share, String>, of: u64) -> Result<(), CliError> {
    let missing = of.saturating_sub(files.len() as u64);
    if missing == 0 || files.keys().any(|share| share.of() != of) {
        return Ok(());
    }
    let absent = (1..=of).filter_map(|number| Share::new(number, of).ok()).filter(|k| !files.contains_key(k));
    let mut names: Vec<String> = absent.take(10).map(|share| share.to_string()).collect();
    if missing > names.len() as u64 {
        names.push("…".to_owned());
    }
    Err(CliError::Input(format!("{missing} of {of} shards are missing: {}", names.join(", "))))
}
