//! Phase tables of other programs: columns of angle and value, as they stand in the file, and what they seem to mean.
//!
//! Layouts: columns separated by commas, semicolons or white space, with or without a header, comments from `#`, `!`, `%`
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
use std::path::Path;
use stratiform_artifact::{ArtifactError, read_text};

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
    let size = std::fs::metadata(path).map_or(0, |file| file.len());
    if size > LARGEST {
        let message = format!("{size} bytes are more than a phase table has ({LARGEST})");
        return Err(ArtifactError::format(path, None, message).into());
    }
    let text = read_text(path)?;
    parse(&text, choice).map_err(|fault| ArtifactError::format(path, fault.line, fault.message).into())
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
    let sheet = layout::sheet(text)?;
    let columns = columns::choose(&sheet, choice)?;
    raw::assemble(&sheet, &columns, choice)
}
