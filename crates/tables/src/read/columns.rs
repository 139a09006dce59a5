//! Which column holds the angle, which the value.

use super::layout::Sheet;
use super::{Choice, Fault};

/// Columns counted from 0.
pub(super) struct Columns {
    pub(super) angle: usize,
    /// One column, or the two polarisations whose mean is meant.
    pub(super) value: Vec<usize>,
    pub(super) wavelength: Option<usize>,
}

impl Columns {
    /// The value's name for messages.
    pub(super) fn value_name(&self, sheet: &Sheet) -> String {
        let names: Vec<String> = self.value.iter().map(|i| name(sheet, *i)).collect();
        names.join(" and ")
    }

    /// The angle's name, or all that is known of it: the line before the rows.
    pub(super) fn angle_name<'a>(&self, sheet: &'a Sheet) -> Option<&'a str> {
        match &sheet.names {
            Some(names) => Some(&names[self.angle]),
            None => sheet.header.as_deref(),
        }
    }

    /// Columns that are not read.
    pub(super) fn left_out(&self, sheet: &Sheet) -> Vec<String> {
        let read = |i: &usize| *i == self.angle || self.value.contains(i) || self.wavelength == Some(*i);
        (0..sheet.rows[0].cells.len()).filter(|i| !read(i)).map(|i| name(sheet, i)).collect()
    }
}

fn name(sheet: &Sheet, column: usize) -> String {
    sheet.names.as_ref().map_or_else(|| format!("column {}", column + 1), |names| names[column].clone())
}

/// Words that name a scattered intensity or a phase function.
const VALUES: [&str; 12] =
    ["p", "p11", "f11", "s11", "m11", "a1", "phase", "phase_function", "pf", "value", "intensity", "i"];

pub(super) fn choose(sheet: &Sheet, choice: &Choice) -> Result<Columns, Fault> {
    let lower: Vec<String> = (0..sheet.rows[0].cells.len()).map(|i| name(sheet, i).to_lowercase()).collect();
    let find = |word: &str| lower.iter().position(|n| n.contains(word));
    let angle = ["theta", "angle", "ang", "cos"].iter().find_map(|word| find(word));
    let angle = angle.or_else(|| lower.iter().position(|n| n == "mu")).unwrap_or(0);
    let wavelength = find("wavel").or_else(|| find("lambda"));
    let rest: Vec<usize> = (0..lower.len())
        .filter(|i| *i != angle && Some(*i) != wavelength && !repeats_the_angle(sheet, angle, *i))
        .collect();
    let value = match &choice.column {
        Some(column) => vec![named(sheet, &lower, column)?],
        None => value_of(sheet, &lower, &rest)?,
    };
    if value.contains(&angle) {
        return Err(Fault::whole(format!("column {} is the angle, not the value", angle + 1)));
    }
    Ok(Columns { angle, value, wavelength })
}

/// The column that `--column` names.
fn named(sheet: &Sheet, lower: &[String], column: &str) -> Result<usize, Fault> {
    let by_name = lower.iter().position(|name| *name == column.to_lowercase());
    let by_number = || column.parse().ok().filter(|n| (1..=lower.len()).contains(n)).map(|n: usize| n - 1);
    by_name.or_else(by_number).ok_or_else(|| {
        let all: Vec<String> = (0..lower.len()).map(|i| name(sheet, i)).collect();
        Fault::whole(format!("no column `{column}`; there are {}", all.join(", ")))
    })
}

fn value_of(sheet: &Sheet, lower: &[String], rest: &[usize]) -> Result<Vec<usize>, Fault> {
    let with = |word: &str| rest.iter().copied().find(|i| lower[*i].contains(word));
    if let Some(unpolarised) = with("unpol") {
        return Ok(vec![unpolarised]);
    }
    if let (Some(perpendicular), Some(parallel)) = (with("perp"), with("paral")) {
        return Ok(vec![perpendicular, parallel]);
    }
    let known = rest.iter().copied().find(|i| VALUES.contains(&lower[*i].as_str()));
    match (known, rest, &sheet.names) {
        (Some(known), ..) => Ok(vec![known]),
        (None, [], _) => Err(Fault::whole("no column of values beside the angle")),
        (None, [only], _) => Ok(vec![*only]),
        // Without names the first column after the angle is P or P11 in every program known here.
        (None, [first, ..], None) => Ok(vec![*first]),
        (None, several, Some(names)) => {
            let names: Vec<&str> = several.iter().map(|i| names[*i].as_str()).collect();
            Err(Fault::whole(format!("several columns ({}): one of them must be named", names.join(", "))))
        }
    }
}

/// Whether a column is the cosine of the angle beside it, as SHDOM's plotscattab writes.
fn repeats_the_angle(sheet: &Sheet, angle: usize, column: usize) -> bool {
    sheet.rows.iter().all(|row| {
        let cosine = libm::cos(row.cells[angle].to_radians());
        (row.cells[column] - cosine).abs() < 1e-4
    })
}
