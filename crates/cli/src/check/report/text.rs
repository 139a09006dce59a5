//! For people at a terminal.

use super::{COLUMNS, cells, headline, offence};
use crate::check::Verdict;
use std::fmt::Write;

/// A table per part, then the `worst` worst failures.
pub fn to_text(verdict: &Verdict, worst: usize) -> String {
    let mut text = String::new();
    for part in verdict.parts.keys() {
        let _ = writeln!(text, "{part}");
        let rows: Vec<_> = std::iter::once(COLUMNS.map(str::to_owned))
            .chain(verdict.summaries(*part).iter().map(cells))
            .collect();
        let width = |column: usize| rows.iter().map(|row| row[column].len()).max().unwrap_or(0);
        for row in &rows {
            let _ = write!(text, "  {:<1$}", row[0], width(0));
            for (column, cell) in row.iter().enumerate().take(8).skip(1) {
                let _ = write!(text, "  {cell:>0$}", width(column));
            }
            let _ = writeln!(text, "  {}", row[8]);
        }
        text.push('\n');
    }
    let failures = verdict.failures();
    if !failures.is_empty() {
        let _ = writeln!(text, "worst offenders ({} of {})", worst.min(failures.len()), failures.len());
        for (part, one) in failures.iter().take(worst) {
            let _ = writeln!(text, "  {part}: {}", offence(one));
        }
        text.push('\n');
    }
    let _ = writeln!(text, "{}", headline(verdict));
    text
}
