//! `stratiform codegen`: emitted text from the accepted parameters, written or checked.

use crate::args::CodegenArgs;
use crate::config::Config;
use crate::output::{Data, Talk};
use crate::{CliError, pipeline};

/// Runs the command.
///
/// # Errors
/// [`CliError::Failed`] with a difference if `--check` finds stale text; [`CliError::Input`] for bad input.
pub fn run(args: &CodegenArgs, talk: Talk) -> Result<Data, CliError> {
    let config = Config::load(&args.config)?;
    let folder = |name: &str| args.config.parent().unwrap_or(std::path::Path::new(".")).join(name);
    let (accepted, output) = (folder(&config.codegen.accepted), folder(&config.codegen.output));
    let files =
        stratiform_codegen::generate(&pipeline::accepted::read(&accepted)?).map_err(pipeline::input_error)?;
    if args.check {
        if let Err(stale) = stratiform_codegen::check(&files, &output) {
            let list: Vec<_> = stale.iter().map(|s| format!("{}/{s}", output.display())).collect();
            return Err(CliError::Failed(list.join("\n")));
        }
        talk.say(format!("{} files in {} are fresh", files.len(), output.display()));
    } else {
        stratiform_codegen::write(&files, &output).map_err(pipeline::input_error)?;
    }
    let names: Vec<_> = files.keys().map(|name| output.join(name).display().to_string()).collect();
    if args.json {
        return Ok(format!(
            "{}\n",
            serde_json::json!({ "schema": "stratiform/codegen/1", "fresh": true, "files": names })
        ));
    }
    Ok(names.join("\n") + "\n")
}
