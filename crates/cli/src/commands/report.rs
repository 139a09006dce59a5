//! `stratiform report`: figures and page from a folder of artifacts.

use crate::args::ReportArgs;
use crate::output::{Data, Talk};
use crate::{CliError, pipeline};

/// Runs the command.
///
/// # Errors
/// [`CliError::Input`] naming the file that is missing, damaged, or cannot be written.
pub fn run(args: &ReportArgs, talk: Talk) -> Result<Data, CliError> {
    let summary = stratiform_report::build(&args.dir).map_err(pipeline::input_error)?;
    for left_out in &summary.left_out {
        talk.say(format!("left out: {} (no {})", left_out.what, left_out.file));
    }
    let files: Vec<_> =
        summary.figures.iter().chain([&summary.page]).map(|path| path.display().to_string()).collect();
    if args.json {
        return Ok(format!("{}\n", serde_json::json!({ "schema": "stratiform/report/1", "files": files })));
    }
    Ok(files.join("\n") + "\n")
}
