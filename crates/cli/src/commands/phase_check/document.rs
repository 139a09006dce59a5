//! The findings as JSON or text.

use super::droplets::Droplets;
use super::subject::Subject;
use serde::{Deserialize, Serialize};
use std::fmt::Write;
use stratiform_artifact::{Extinction, Provenance, hash_of};
use stratiform_tables::diagnosis::{Check, TableFacts, Verdict};

/// `--json`.
#[derive(Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct PhaseCheckDocument {
    /// `stratiform/phase-check/1`.
    schema: String,
    provenance: Provenance,
    /// The file, or the constants as typed.
    subject: String,
    /// Nothing is wrong.
    pub(super) passes: bool,
    /// Names of the checks that are wrong, without what follows from them.
    pub(super) faults: Vec<String>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    mie: Option<MieRecord>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    table: Option<TableFacts>,
    checks: Vec<Check>,
}

/// What the droplets' own phase function has.
#[derive(Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct MieRecord {
    wavelength_um: f64,
    theta_f_deg: f64,
    asymmetry: f64,
    forward_fraction: f64,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    extinction_per_m: Option<Extinction>,
}

impl MieRecord {
    fn new(droplets: &Droplets) -> Self {
        let ensemble = &droplets.ensemble;
        Self {
            wavelength_um: ensemble.wavelength_um,
            theta_f_deg: ensemble.theta_f_deg,
            asymmetry: ensemble.asymmetry,
            forward_fraction: ensemble.forward_fraction,
            extinction_per_m: droplets.extinction,
        }
    }
}

impl PhaseCheckDocument {
    pub(super) fn new(
        subject: &Subject,
        droplets: Option<&Droplets>,
        table: Option<TableFacts>,
        checks: Vec<Check>,
    ) -> Self {
        let columns = subject.table.as_ref().map(|raw| (&raw.theta_deg, &raw.value));
        let inputs = (columns, &subject.constants, droplets.map(|droplets| &droplets.config));
        let wrong = checks.iter().filter(|check| check.verdict == Verdict::Wrong);
        Self {
            schema: "stratiform/phase-check/1".to_owned(),
            provenance: Provenance::new(hash_of(&inputs), None, "named checks within stated bounds"),
            subject: subject.name.clone(),
            passes: checks.iter().all(|check| check.verdict == Verdict::Ok),
            faults: wrong.map(|check| check.name.clone()).collect(),
            mie: droplets.map(MieRecord::new),
            table,
            checks,
        }
    }

    /// A table with one line per check.
    pub(super) fn text(&self) -> String {
        let mut text = String::new();
        let head = ["check", "verdict", "found", "expected", "bound", "words"].map(str::to_owned);
        for cells in std::iter::once(head).chain(self.checks.iter().map(cells)) {
            let [check, verdict, found, expected, bound, words] = cells;
            let _ = writeln!(text, "{check:<17} {verdict:<8} {found:<11} {expected:<11} {bound:<11} {words}");
        }
        text
    }
}

fn cells(check: &Check) -> [String; 6] {
    let verdict = match check.verdict {
        Verdict::Ok => "ok",
        Verdict::Wrong => "WRONG",
        Verdict::Follows => "follows",
    };
    let from = check.follows_from.as_ref().map_or(String::new(), |cause| format!("follows from {cause}; "));
    let [found, expected, bound] = [check.found, check.expected, check.bound].map(number);
    [check.name.clone(), verdict.to_owned(), found, expected, bound, format!("{from}{}", check.words)]
}

/// Five decimals where they say enough.
fn number(value: Option<f64>) -> String {
    let Some(value) = value else { return "-".to_owned() };
    if value == 0.0 || (1e-4..1e6).contains(&value.abs()) {
        let text = format!("{value:.5}");
        return text.trim_end_matches('0').trim_end_matches('.').to_owned();
    }
    format!("{value:.4e}")
}
