//! For the summary page of a CI run.

use super::{COLUMNS, cells, headline, offence};
use crate::check::Verdict;
use std::fmt::Write;

/// A heading with the outcome, a table per part, and the `worst` worst failures.
pub fn to_markdown(verdict: &Verdict, title: &str, worst: usize) -> String {
    let outcome = if verdict.passes() { "passed" } else { "FAILED" };
    let mut text = format!("## stratiform check {outcome}\n\n{title}: {}\n", headline(verdict));
    for part in verdict.parts.keys() {
        let _ = writeln!(text, "\n### {part}\n\n| {} |", COLUMNS.join(" | "));
        let _ = writeln!(text, "| --- |{} --- |", " ---: |".repeat(COLUMNS.len() - 2));
        for summary in verdict.summaries(*part) {
            let _ = writeln!(text, "| {} |", cells(&summary).join(" | "));
        }
    }
    let failures = verdict.failures();
    if !failures.is_empty() {
        let _ = writeln!(text, "\n### worst offenders\n");
        for (part, one) in failures.iter().take(worst) {
            let _ = writeln!(text, "- {part}: {}", offence(one));
        }
    }
    text
}
