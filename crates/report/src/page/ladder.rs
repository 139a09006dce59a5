//! The ladder of approximations as a table, one sentence per rung.

use super::{appendix, number};
use crate::figures::RUNGS;
use maud::{Markup, html};
use stratiform_artifact::LadderRow;

/// Heading of the first line of a rung, which carries its sentence.
const STEEP: &str = "≤ 80°";

fn words(rung: &str) -> &'static str {
    match rung {
        "solver" => "Deterministic solver, double precision: its own estimated error.",
        "monte-carlo" => "Photons against the solver at the table's angles: noise.",
        "model" => {
            "The fitted model, double precision, against the solver at the table's angles: what its form cannot follow."
        }
        "f32" => "The same parameters in single precision.",
        "interpolation" => {
            "Half-way between the table's angles: parameters interpolated against parameters fitted there."
        }
        "shader" => {
            "The emitted shader, executed, against the model in single precision with the interpolated table."
        }
        "together" => {
            "All at once: the interpolated table in single precision against the solver, at and half-way between its angles."
        }
        _ => "",
    }
}

pub fn section(rows: Option<&[LadderRow]>) -> Markup {
    let Some(rows) = rows else {
        return html! { p { "No " code { "ladder.csv" } " in the folder." } };
    };
    html! {
        p { "Each rung is compared with the one before at points where nothing else differs. Root mean square / worst, in \
             units of the incident flux; for the orders the largest over T" sub { "0" } " to R" sub { "3+" } "." }
        div class="wide" {
            table {
                thead {
                    tr {
                        th { "rung" } th class="words" { "step" } th { "angles" } th { "T" sub { "ms" } } th { "orders" }
                        th { "worst of all at" } th { "points" }
                    }
                }
                tbody { @for rung in RUNGS { (lines(rung, rows)) } }
            }
        }
    }
}

fn lines(rung: &str, rows: &[LadderRow]) -> Markup {
    let here: Vec<&LadderRow> = rows.iter().filter(|row| row.rung == rung).collect();
    html! {
        @if let Some(row) = here.iter().find(|row| row.rms.is_none()) {
            tr {
                th { (rung) } td class="words" { (words(rung)) }
                td class="words" colspan="5" { strong { (row.note) } }
            }
        }
        @for (angles, name) in [(LadderRow::TO_80, STEEP), (LadderRow::ALL, "all")] {
            (line(rung, name, &here.iter().copied().filter(|row| row.angles == angles && row.rms.is_some()).collect::<Vec<_>>()))
        }
    }
}

fn line(rung: &str, angles: &str, rows: &[&LadderRow]) -> Markup {
    let size = |row: &&&LadderRow| row.worst.unwrap_or(0.0);
    let Some(worst) = rows.iter().max_by(|a, b| size(a).total_cmp(&size(b))) else { return html! {} };
    let largest = |total: bool, of: fn(&LadderRow) -> Option<f64>| {
        rows.iter()
            .filter(|row| (row.quantity == "t_ms") == total)
            .filter_map(|row| of(row))
            .fold(0.0, f64::max)
    };
    let cell = |total: bool| {
        html! {
            (number::small(largest(total, |row| row.rms))) " / " (number::small(largest(total, |row| row.worst)))
            @if rows.iter().any(|row| row.expected_rms.is_some()) {
                br; small { "σ " (number::small(largest(total, |row| row.expected_rms))) }
            }
        }
    };
    html! {
        tr {
            th { (rung) }
            td class="words" {
                @if angles == STEEP { (words(rung)) }
                @if angles == STEEP && !worst.note.is_empty() && rung == "shader" { " " small { "Device: " (worst.note) "." } }
            }
            td { (angles) }
            td { (cell(true)) }
            td { (cell(false)) }
            td { (appendix::quantity_name(&worst.quantity)) ", " (place(&worst.worst_theta_l_deg)) ", τ = "
                 (number::small(worst.worst_tau.unwrap_or(0.0))) }
            td { (worst.points) }
        }
    }
}

fn place(theta_l_deg: &str) -> String {
    if theta_l_deg.parse::<f64>().is_ok() { format!("{theta_l_deg}°") } else { theta_l_deg.to_owned() }
}
