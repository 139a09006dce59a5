//! A verdict as text, JSON, JUnit and Markdown.

mod json;
mod junit;
mod markdown;
mod text;

pub use json::{SCHEMA, to_json};
pub use junit::to_junit;
pub use markdown::to_markdown;
pub use text::to_text;

use super::{Comparison, Summary, Verdict};

/// Six significant digits, without trailing zeros; large and small numbers with an exponent.
pub fn short(value: f64) -> String {
    rounded(value, 6)
}

/// Three digits of a difference or bound.
fn coarse(value: f64) -> String {
    rounded(value, 3)
}

fn rounded(value: f64, digits: usize) -> String {
    let size = value.abs();
    if size == 0.0 || !value.is_finite() {
        return value.to_string();
    }
    if !(1e-4..1e6).contains(&size) {
        return format!("{value:.2e}");
    }
    let decimals = (digits as f64 - 1.0 - libm::floor(libm::log10(size))).clamp(0.0, 9.0) as usize;
    let text = format!("{value:.decimals$}");
    match text.contains('.') {
        true => text.trim_end_matches('0').trim_end_matches('.').to_owned(),
        false => text,
    }
}

/// The columns that text and Markdown share.
const COLUMNS: [&str; 9] =
    ["quantity", "compared", "failed", "off/bound", "value", "truth", "off by", "bound", "worst at"];

fn cells(summary: &Summary<'_>) -> [String; 9] {
    let worst = summary.worst;
    [
        summary.label.clone(),
        summary.compared.to_string(),
        summary.failed.to_string(),
        format!("{:.2}", worst.severity()),
        short(worst.value),
        short(worst.truth),
        coarse(worst.difference()),
        coarse(worst.bound),
        worst.place.to_string(),
    ]
}

/// One failure in a line.
fn offence(one: &Comparison) -> String {
    format!(
        "{} at {}: {}, truth {}, off by {}, bound {}",
        one.label(),
        one.place,
        short(one.value),
        short(one.truth),
        coarse(one.difference()),
        coarse(one.bound)
    )
}

/// The outcome in a line.
pub fn headline(verdict: &Verdict) -> String {
    let (compared, failed) = (verdict.compared(), verdict.failures().len());
    match verdict.empty_parts().first() {
        _ if verdict.parts.is_empty() => "nothing was compared".to_owned(),
        Some(part) => format!("{part}: nothing was compared"),
        None if failed == 0 => format!("{compared} comparisons, all within their bounds"),
        None => format!("{failed} of {compared} comparisons are out of bounds"),
    }
}

#[cfg(test)]
mod tests;
