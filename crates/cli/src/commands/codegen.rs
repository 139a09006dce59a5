//! `stratiform codegen`: emitted text from the accepted parameters, written or checked.

use crate::args::CodegenArgs;
use crate::config::Config;
use crate::output::{Data, Talk};
use crate::{CliError, pipeline};

/// Runs the command.
///
/// # Errors
/// [`CliError::Unmet`] with a difference if `--check` finds stale text; [`CliError::Input`] for bad input.
pub fn run(args: &CodegenArgs, talk: Talk) -> Result<Data, CliError> {
    let config = Config::load(&args.config)?;
    let folder = |name: &str| args.config.parent().unwrap_or(std::path::Path::new(".")).join(name);
    let (accepted, output) = (folder(&config.codegen.accepted), folder(&config.codegen.output));
    let inputs = pipeline::accepted::read_for(&config, &accepted)?;
    let files = pipeline::accepted::emitted(&config, &inputs, &accepted)?;
    if args.check {
        if let Err(stale) = stratiform_codegen::check(&files, &output) {
            let list: Vec<_> = stale.iter().map(|s| format!("{}/{s}", output.display())).collect();
            let names: Vec<_> = stale.iter().map(|s| output.join(&s.file).display().to_string()).collect();
            let data = if args.json { object(false, &names) } else { String::new() };
            return Err(CliError::Unmet { message: list.join("\n"), data });
        }
        talk.say(format!("{} files in {} are fresh", files.names().len(), output.display()));
    } else {
        stratiform_codegen::write(&files, &output).map_err(pipeline::input_error)?;
        for left_over in stratiform_codegen::left_over(&files, &output) {
            talk.say(format!("{}/{}", output.display(), left_over.to_string().trim_end()));
        }
    }
    let names: Vec<_> = files.names().map(|name| output.join(name).display().to_string()).collect();
    Ok(if args.json { object(true, &names) } else { names.join("\n") + "\n" })
}

/// The answer of `--json`: fresh and all files, or the stale ones.
fn object(fresh: bool, files: &[String]) -> String {
    let object = serde_json::json!({ "schema": "stratiform/codegen/1", "fresh": fresh, "files": files });
    format!("{object}\n")
}
