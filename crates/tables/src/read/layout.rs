//! Text to a sheet: names of the columns, and rows of numbers with the lines on which they stand.

use super::Fault;
use serde::{Deserialize, Serialize};

/// How a file is laid out.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Layout {
    /// Columns with an optional header.
    Columns,
    /// MiePlot's text.
    MiePlot,
    /// Legendre coefficients of SHDOM's make_mie_table or libRadtran's mie.
    Legendre,
}

/// Lines of text before the first row of numbers that still count as a header.
const LONGEST_HEADER: usize = 100;

/// Fewest rows that describe anything.
const FEWEST: usize = 3;

pub(super) struct Sheet {
    pub(super) layout: Layout,
    /// The line before the first row, if it is text.
    pub(super) header: Option<String>,
    /// One name per column, where the header has as many.
    pub(super) names: Option<Vec<String>>,
    pub(super) rows: Vec<Row>,
}

pub(super) struct Row {
    pub(super) line: u64,
    pub(super) cells: Vec<f64>,
}

/// The rows of `text`.
pub(super) fn sheet(text: &str) -> Result<Sheet, Fault> {
    let mut header: Vec<&str> = Vec::new();
    let mut rows: Vec<Row> = Vec::new();
    let mut layout = Layout::Columns;
    for (index, line) in text.trim_start_matches('\u{feff}').lines().enumerate() {
        let (number, line) = (index as u64 + 1, line.trim());
        let bare = without_mark(line);
        if rows.is_empty() && bare.to_lowercase().starts_with("angle") && mentions_polarisation(bare) {
            layout = Layout::MiePlot;
        }
        if layout == Layout::MiePlot && !rows.is_empty() && line.starts_with('*') {
            break;
        }
        match numbers(line) {
            _ if line.is_empty() => {}
            Ok(cells) => push(&mut rows, Row { line: number, cells })?,
            Err(_) if rows.is_empty() && header.len() < LONGEST_HEADER => header.push(bare),
            Err(_) if bare.len() < line.len() => {}
            Err(field) => return Err(Fault::at(number, format!("`{}` is not a number", shortened(field)))),
        }
    }
    if rows.len() < FEWEST {
        return Err(Fault::whole(format!("{} rows of numbers are no phase table", rows.len())));
    }
    let header = header.last().map(|line| (*line).to_owned());
    let names = header.as_deref().and_then(|line| match layout {
        Layout::MiePlot => mieplot_names(line, rows[0].cells.len()),
        _ => names(line, rows[0].cells.len()),
    });
    if layout == Layout::MiePlot && names.is_none() {
        let (line, count) = (rows[0].line, rows[0].cells.len());
        return Err(Fault::at(line, format!("{count} columns are not those that MiePlot's header names")));
    }
    Ok(Sheet { layout, header, names, rows })
}

fn push(rows: &mut Vec<Row>, row: Row) -> Result<(), Fault> {
    if let Some(first) = rows.first().filter(|first| first.cells.len() != row.cells.len()) {
        let (found, before) = (row.cells.len(), first.cells.len());
        return Err(Fault::at(row.line, format!("{found} columns, {before} in the rows before")));
    }
    if row.cells.len() < 2 {
        return Err(Fault::at(row.line, "one column: an angle and a value are needed"));
    }
    rows.push(row);
    Ok(())
}

/// The line without the mark that makes it a comment.
fn without_mark(line: &str) -> &str {
    line.trim_start_matches(['#', '!', '%', '/']).trim()
}

fn mentions_polarisation(line: &str) -> bool {
    let line = line.to_lowercase();
    line.contains("perp") || line.contains("paral") || line.contains("polari")
}

/// The numbers of a line, or the first field that is none. Fortran's `1.0D+03` is one, and beside semicolons `1,5`.
fn numbers(line: &str) -> Result<Vec<f64>, &str> {
    let semicolons = line.contains(';');
    let separator = |c: char| c == ';' || c.is_whitespace() || (c == ',' && !semicolons);
    let number = |field: &str| field.replace(['d', 'D'], "e").replace(',', ".").parse();
    let fields = line.split(separator).filter(|field| !field.is_empty());
    fields.map(|field| number(field).map_err(|_| field)).collect()
}

/// `count` names, by the first way of splitting that gives as many.
fn names(header: &str, count: usize) -> Option<Vec<String>> {
    let ways: [Vec<&str>; 4] = [
        header.split([',', ';']).collect(),
        header.split('\t').collect(),
        header.split("  ").collect(),
        header.split_whitespace().collect(),
    ];
    let filled = ways.into_iter().map(|parts| {
        let trimmed = parts.into_iter().map(str::trim).filter(|part| !part.is_empty());
        trimmed.map(str::to_owned).collect::<Vec<_>>()
    });
    filled.into_iter().find(|parts| parts.len() == count)
}

/// What the columns of MiePlot hold, in the order in which the header says so.
fn mieplot_names(header: &str, count: usize) -> Option<Vec<String>> {
    const WORDS: [&str; 5] = ["angle", "wavelength", "perpendicular", "parallel", "unpolari"];
    let lower = header.to_lowercase();
    let mut found: Vec<(usize, &str)> =
        WORDS.iter().filter_map(|word| Some((lower.find(word)?, *word))).collect();
    found.sort_unstable();
    (found.len() == count).then(|| found.into_iter().map(|(_, word)| word.to_owned()).collect())
}

fn shortened(field: &str) -> String {
    field.chars().take(40).filter(|c| !c.is_control()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn headers_are_split_as_the_rows_are() {
        for header in ["theta,p", "theta;p", "theta\tp", "theta  p", "theta p"] {
            assert_eq!(names(header, 2), Some(vec!["theta".to_owned(), "p".to_owned()]), "{header}");
        }
        assert_eq!(names("Angle (deg)\tP11", 2), Some(vec!["Angle (deg)".to_owned(), "P11".to_owned()]));
        assert_eq!(names("a b c", 2), None);
    }

    #[test]
    fn fortran_exponents_are_numbers_and_words_are_not() {
        assert_eq!(numbers("0.5, 1.0D+03 2"), Ok(vec![0.5, 1000.0, 2.0]));
        assert_eq!(numbers("1 two 3"), Err("two"));
        assert_eq!(numbers("0,25; 1,5"), Ok(vec![0.25, 1.5]));
        assert_eq!(numbers("1,2,3;4"), Err("1,2,3"));
    }
}
