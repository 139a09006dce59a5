//! Phase tables of other programs: columns of angle and value, as they stand in the file, and what they seem to mean.
//!
//! Layouts: columns separated by commas, semicolons (commas are decimal then) or white space, with or without a header, comments from `#`, `!`, `%`
//! or `//` on (libRadtran, SHDOM's plotscattab, spreadsheets); and MiePlot's text, free lines up to one that begins
//! with `Angle`, then angle, wavelength, perpendicular and parallel intensity up to a line of asterisks (columns as in the
//! importer MiePlotImporter for Unreal Engine; unpolarised is the mean of both); and Legendre coefficients as SHDOM's
//! make_mie_table and libRadtran's mie list them, which are summed.
//!
//! The angle may be in degrees, radians or cosines; the range tells which, a header may contradict. Nothing is repaired
//! on the way in: [`RawTable`] is the file, [`Understanding`] what is unusual about it, [`RawTable::table`] refuses what
//! is, and [`RawTable::repaired`] is for those who ask.
//!
//! Refused with file and line: what is no number or not finite, negative values, angles out of order or twice, tables
//! that do not cover the sphere, rows of different length, too few rows, files that are empty, binary or huge.

mod columns;
mod layout;
mod legendre;
mod raw;
mod understand;
mod unit;

pub use layout::Layout;
pub use raw::RawTable;
pub use understand::{Normalisation, Understanding};
pub use unit::AngleUnit;

use crate::TablesError;
use std::fs::File;
use std::io::Read;
use std::path::Path;
use stratiform_artifact::ArtifactError;

/// Largest file that is read, bytes: 2e6 rows of 30 characters.
const LARGEST: u64 = 64 << 20;

/// Which of several columns or wavelengths is meant.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Choice {
    /// Name of the value's column in the header, or its number counted from 1.
    pub column: Option<String>,
    /// Wavelength of the rows to take, in the unit of the file, where a column holds it.
    pub wavelength: Option<f64>,
    /// Effective radius of the Legendre coefficients to take, as it stands in the file.
    pub effective_radius: Option<f64>,
}

/// Reads a phase table.
///
/// # Errors
/// [`ArtifactError`] naming file and line.
pub fn read(path: &Path, choice: &Choice) -> Result<RawTable, TablesError> {
    let mut bytes = Vec::new();
    let opened = File::open(path).and_then(|file| file.take(LARGEST + 1).read_to_end(&mut bytes));
    opened.map_err(|source| ArtifactError::Io { action: "read", path: path.to_owned(), source })?;
    let table = text_of(bytes).and_then(|text| parse(&text, choice));
    table.map_err(|fault| ArtifactError::format(path, fault.line, fault.message).into())
}

/// UTF-8, or Latin-1, in which MiePlot writes its µ: every byte is a character, and none of them a control.
fn text_of(bytes: Vec<u8>) -> Result<String, Fault> {
    if bytes.len() as u64 > LARGEST {
        return Err(Fault::whole(format!("more than {LARGEST} bytes are no phase table")));
    }
    let control = |byte: &u8| byte.is_ascii_control() && !byte.is_ascii_whitespace();
    if let Some(at) = bytes.iter().position(control) {
        let line = bytes[..at].iter().filter(|byte| **byte == b'\n').count() + 1;
        return Err(Fault::at(line as u64, "not a text file"));
    }
    if bytes.trim_ascii().is_empty() {
        return Err(Fault::whole("the file is empty"));
    }
    Ok(String::from_utf8(bytes)
        .unwrap_or_else(|error| error.as_bytes().iter().map(|byte| char::from(*byte)).collect()))
}

/// What is wrong, and on which line, counted from 1.
struct Fault {
    line: Option<u64>,
    message: String,
}

impl Fault {
    fn at(line: u64, message: impl Into<String>) -> Self {
        Self { line: Some(line), message: message.into() }
    }

    fn whole(message: impl Into<String>) -> Self {
        Self { line: None, message: message.into() }
    }
}

fn parse(text: &str, choice: &Choice) -> Result<RawTable, Fault> {
    if legendre::is_listing(text) {
        return legendre::assemble(text, choice);
    }
    if let Some(radius) = choice.effective_radius {
        let message = format!("no effective radius {radius}: these are no Legendre coefficients");
        return Err(Fault::whole(message));
    }
    let sheet = layout::sheet(text)?;
    let columns = columns::choose(&sheet, choice)?;
    raw::assemble(&sheet, &columns, choice)
}
