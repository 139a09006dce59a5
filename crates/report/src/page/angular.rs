//! What the angular model's radiances integrate to, as shares of the exact fluxes.

use super::number;
use maud::{Markup, html};
use stratiform_artifact::{AngularBooksRow, AngularForm};
use stratiform_quantities::{Order, Side};

/// The rows of a block and their words.
const LINES: [(Order, AngularForm, &str); 7] = [
    (Order::Exactly(1), AngularForm::Corrected, "1, corrected"),
    (Order::Exactly(1), AngularForm::AsPrinted, "1, as printed"),
    (Order::Exactly(2), AngularForm::Corrected, "2, corrected"),
    (Order::Exactly(2), AngularForm::AsPrintedPerUnit, "2, as printed without κ², with 1/4π"),
    (Order::Exactly(2), AngularForm::AsPrinted, "2, as printed"),
    (Order::Tail, AngularForm::Corrected, "3+, corrected"),
    (Order::Tail, AngularForm::AsPrinted, "3+, as printed"),
];

/// Below this the exact flux is too small for a quotient to mean anything.
const LEAST: f64 = 1e-5;

pub fn section(rows: Option<&[AngularBooksRow]>) -> Markup {
    let Some(rows) = rows else {
        return html! { p { "No " code { "angular-books.csv" } " in the folder." } };
    };
    html! {
        p { "The model's radiance of one order, integrated over a hemisphere, should be the exact flux of that order in the \
             modified medium. Listed is the quotient, by optical thickness τ. Order 3+ takes its flux from the fitted table, \
             which is a difference of fits. All numbers: " code { "angular-books.csv" } "." }
        @for theta in chosen(rows) { @for side in Side::BOTH { (block(rows, theta, side)) } }
    }
}

/// The first, the middle and the last angle.
fn chosen(rows: &[AngularBooksRow]) -> Vec<f64> {
    let all = distinct(rows.iter().map(|row| row.theta_l_deg));
    let mut chosen: Vec<f64> =
        [0, all.len() / 2, all.len().saturating_sub(1)].iter().filter_map(|i| all.get(*i).copied()).collect();
    chosen.dedup();
    chosen
}

fn block(rows: &[AngularBooksRow], theta_l_deg: f64, side: Side) -> Markup {
    let here: Vec<&AngularBooksRow> =
        rows.iter().filter(|row| row.theta_l_deg == theta_l_deg && row.side == side).collect();
    let thicknesses = distinct(here.iter().map(|row| row.tau));
    let light = if side == Side::Top { "reflected" } else { "transmitted" };
    let quotient = |order, form, tau| {
        let row = here.iter().find(|row| row.order == order && row.form == form && row.tau == tau);
        match row {
            Some(row) if row.solver > LEAST => number::fixed(row.integral / row.solver, 3),
            _ => "–".to_owned(),
        }
    };
    html! {
        h3 { "θ" sub { "l" } " = " (theta_l_deg) "°, " (light) " light" }
        div class="wide" {
            table {
                thead { tr { th class="words" { "order" } @for tau in &thicknesses { th { "τ " (number::small(*tau)) } } } }
                tbody {
                    @for (order, form, words) in LINES {
                        tr { th class="words" { (words) } @for tau in &thicknesses { td { (quotient(order, form, *tau)) } } }
                    }
                }
            }
        }
    }
}

/// Each value once, in order of appearance.
fn distinct(values: impl Iterator<Item = f64>) -> Vec<f64> {
    values.fold(Vec::new(), |mut distinct, value| {
        if !distinct.contains(&value) {
            distinct.push(value);
        }
        distinct
    })
}
