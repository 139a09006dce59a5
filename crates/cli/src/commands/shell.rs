//! `stratiform completions` and `stratiform man`: both from the definition that parses the command line.

use crate::args::{CompletionsArgs, ManArgs};
use crate::output::Data;
use crate::{Cli, CliError};
use clap::{Command, CommandFactory};
use clap_mangen::Man;
use std::path::Path;
use stratiform_artifact::{create_folder, write_atomic};

/// The completion script of a shell.
///
/// # Errors
/// [`CliError::Failed`] if the script is not UTF-8.
pub fn completions(args: &CompletionsArgs) -> Result<Data, CliError> {
    let mut script = Vec::new();
    clap_complete::generate(args.shell, &mut Cli::command(), "stratiform", &mut script);
    text(script)
}

/// The main manual page; or every page, into a folder, and their names.
///
/// # Errors
/// [`CliError::Input`] if the folder cannot be written.
pub fn man(args: &ManArgs) -> Result<Data, CliError> {
    let mut command = Cli::command().disable_help_subcommand(true);
    command.build();
    match &args.out {
        None => text(page(command, "stratiform")?),
        Some(folder) => pages(&command, folder),
    }
}

fn pages(command: &Command, folder: &Path) -> Result<Data, CliError> {
    create_folder(folder)?;
    let mut written = String::new();
    for one in std::iter::once(command).chain(command.get_subcommands()) {
        let name = one.get_display_name().unwrap_or(one.get_name()).to_owned();
        let path = folder.join(format!("{name}.1"));
        write_atomic(&path, &page(one.clone(), &name)?)?;
        written.push_str(&format!("{}\n", path.display()));
    }
    Ok(written)
}

fn page(command: Command, title: &str) -> Result<Vec<u8>, CliError> {
    let mut page = Vec::new();
    let rendered = Man::new(command).title(title).render(&mut page);
    rendered.map_err(|error| CliError::Failed(format!("manual page: {error}")))?;
    Ok(page)
}

fn text(bytes: Vec<u8>) -> Result<Data, CliError> {
    String::from_utf8(bytes).map_err(|error| CliError::Failed(error.to_string()))
}
