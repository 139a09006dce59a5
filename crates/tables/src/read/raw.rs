//! The table as it stands in the file, in ascending angles.

use super::columns::Columns;
use super::layout::{Row, Sheet};
use super::{AngleUnit, Choice, Fault, Layout, Understanding};
use crate::TablesError;
use stratiform_optics::OpticsError;
use stratiform_optics::phase::{Norm, PhaseTable};

/// Angle and value of somebody's phase function, unrepaired.
#[derive(Clone, Debug, PartialEq)]
pub struct RawTable {
    /// How the file is laid out.
    pub layout: Layout,
    /// What the angles are, by their range.
    pub unit: AngleUnit,
    /// What the header says that they are.
    pub stated_unit: Option<AngleUnit>,
    /// Names of the columns that were read as the value.
    pub value_name: String,
    /// Columns that were not read.
    pub left_out: Vec<String>,
    /// Angles in degrees, from 0 to 180, ascending.
    pub theta_deg: Vec<f64>,
    /// Values, not negative.
    pub value: Vec<f64>,
}

impl RawTable {
    /// The phase function, if it can be used as it stands.
    ///
    /// # Errors
    /// [`TablesError`] naming what is unusual: unit, sign or normalisation.
    pub fn table(&self) -> Result<PhaseTable, TablesError> {
        let understood = Understanding::of(self, None)?;
        if let Some(words) = understood.unusual() {
            return Err(OpticsError::Table(words).into());
        }
        Ok(PhaseTable::new(self.theta_deg.clone(), self.value.clone(), Norm::Strict)?)
    }

    /// The phase function with forward at 0° and mean 1, whatever it was.
    ///
    /// # Errors
    /// [`TablesError`] if the values have no integral.
    pub fn repaired(&self) -> Result<PhaseTable, TablesError> {
        Understanding::of(self, None)?.repaired(self)
    }
}

pub(super) fn assemble(sheet: &Sheet, columns: &Columns, choice: &Choice) -> Result<RawTable, Fault> {
    let rows = of_one_wavelength(sheet, columns, choice)?;
    finite(&rows, columns)?;
    let unit = AngleUnit::found(&rows, columns.angle)?;
    in_order(&rows, columns.angle)?;
    let mut pairs: Vec<(f64, f64)> = rows.iter().map(|row| pair(row, columns, unit)).collect();
    if pairs[0].0 > pairs[pairs.len() - 1].0 {
        pairs.reverse();
    }
    let last = pairs.len() - 1;
    (pairs[0].0, pairs[last].0) = (0.0, 180.0);
    if let Some(pair) = pairs.windows(2).find(|pair| pair[0].0 >= pair[1].0) {
        return Err(Fault::whole(format!("two rows stand at {} degrees", pair[1].0)));
    }
    let (theta_deg, value) = pairs.into_iter().unzip();
    Ok(RawTable {
        layout: sheet.layout,
        unit,
        stated_unit: columns.angle_name(sheet).and_then(AngleUnit::stated),
        value_name: columns.value_name(sheet),
        left_out: columns.left_out(sheet),
        theta_deg,
        value,
    })
}

fn pair(row: &Row, columns: &Columns, unit: AngleUnit) -> (f64, f64) {
    let sum = columns.value.iter().fold(0.0, |sum, i| sum + row.cells[*i]);
    (unit.degrees(row.cells[columns.angle]), sum / columns.value.len() as f64)
}

/// The rows of the wavelength that is meant.
fn of_one_wavelength<'a>(
    sheet: &'a Sheet,
    columns: &Columns,
    choice: &Choice,
) -> Result<Vec<&'a Row>, Fault> {
    let Some(column) = columns.wavelength else {
        return match choice.wavelength {
            Some(meant) => Err(Fault::whole(format!("no wavelength {meant}: no column is named so"))),
            None => Ok(sheet.rows.iter().collect()),
        };
    };
    let mut all: Vec<f64> = sheet.rows.iter().map(|row| row.cells[column]).collect();
    all.sort_by(f64::total_cmp);
    all.dedup();
    let meant = match (choice.wavelength, all.as_slice()) {
        (None, [only]) => *only,
        (Some(meant), _) if all.contains(&meant) => meant,
        _ => {
            let listed: Vec<String> = all.iter().take(8).map(f64::to_string).collect();
            let listed = listed.join(", ");
            return Err(Fault::whole(match choice.wavelength {
                Some(meant) => format!("no wavelength {meant}; there are {listed}"),
                None => format!("several wavelengths ({listed}): one of them must be named"),
            }));
        }
    };
    Ok(sheet.rows.iter().filter(|row| row.cells[column] == meant).collect())
}

fn finite(rows: &[&Row], columns: &Columns) -> Result<(), Fault> {
    for row in rows {
        let angle = row.cells[columns.angle];
        if !angle.is_finite() {
            return Err(Fault::at(row.line, format!("the angle {angle} is not finite")));
        }
        for value in columns.value.iter().map(|i| row.cells[*i]) {
            if !(value.is_finite() && value >= 0.0) {
                return Err(Fault::at(row.line, format!("the value {value} is outside [0, infinity)")));
            }
        }
    }
    Ok(())
}

/// Angles rise throughout or fall throughout.
fn in_order(rows: &[&Row], column: usize) -> Result<(), Fault> {
    let rising = rows[0].cells[column] < rows[rows.len() - 1].cells[column];
    for pair in rows.windows(2) {
        let (before, angle) = (pair[0].cells[column], pair[1].cells[column]);
        if before == angle {
            return Err(Fault::at(pair[1].line, format!("the angle {angle} stands twice")));
        }
        if (before < angle) != rising {
            let message = format!("the angle {angle} after {before} is out of order");
            return Err(Fault::at(pair[1].line, message));
        }
    }
    Ok(())
}
