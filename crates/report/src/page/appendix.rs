//! The regenerated parameter table beside the published one, and the misfits.

use super::{flags, number};
use crate::chart::html as rich;
use crate::input::Inputs;
use maud::{Markup, html};
use stratiform_artifact::{FittedParameter, Flag, Misfit, ParameterRow, PublishedRow};

/// Heading, fitted parameter, published parameter.
type Column = (&'static str, fn(&ParameterRow) -> &FittedParameter, fn(&PublishedRow) -> f64);

const COLUMNS: [Column; 5] = [
    ("b", |row| &row.b, |row| row.b),
    ("c (1/m)", |row| &row.c, |row| row.c_per_m),
    ("κ_{c} (1/m)", |row| &row.kappa_c, |row| row.kappa_c_per_m),
    ("t", |row| &row.t, |row| row.t),
    ("r", |row| &row.r, |row| row.r),
];

pub fn tables(inputs: &Inputs) -> Markup {
    let rows = &inputs.parameters.metres.rows;
    let mut used: Vec<Flag> = rows.iter().flat_map(|row| row.flags.iter().copied()).collect();
    used.sort_unstable();
    used.dedup();
    html! {
        (beta(inputs))
        div class="wide" {
            table {
                caption { "Fitted value ± " (inputs.parameters.provenance.error_name()) @if inputs.published.is_some() { "; tinted: published" } }
                thead { (heading(inputs.published.is_some())) }
                tbody { @for row in rows { (table_row(row, inputs, &used)) } }
            }
        }
        p { "A dash stands where the data do not determine a parameter; in brackets what the emitted code uses. A \
             value without ± was fixed or lies on a bound." }
        h3 { "Notes" }
        (flags::list(&used))
    }
}

fn beta(inputs: &Inputs) -> Markup {
    let [low, high] = inputs.parameters.thickness_range_m;
    let beta = inputs.parameters.metres.beta;
    html! {
        p {
            "Fitted over thicknesses from " (low) " to " (high) " m. β = T" sub { "ms" } "(1 m) = "
            (number::with_error(beta.value, Some(beta.std_error)))
            @if let Some(published) = inputs.notes.as_ref().and_then(|n| n.published_beta) {
                "; published: " (number::fixed(published, 4))
            }
            "."
        }
    }
}

fn heading(published: bool) -> Markup {
    html! {
        tr {
            th { "θ" sub { "l" } " (°)" }
            @for (name, _, _) in COLUMNS {
                th { (rich(name)) }
                @if published { th { (rich(name)) br; "published" } }
            }
            th { "notes" }
        }
    }
}

fn table_row(row: &ParameterRow, inputs: &Inputs, used: &[Flag]) -> Markup {
    let published = inputs.published.as_ref().map(|table| {
        let degrees = row.theta_l_deg.degrees();
        table.iter().find(|known| Some(known.theta_l_deg) == degrees)
    });
    let notes: Vec<String> = row
        .flags
        .iter()
        .filter_map(|flag| used.iter().position(|u| u == flag))
        .map(|i| (i + 1).to_string())
        .collect();
    html! {
        tr {
            th { (row.theta_l_deg) }
            @for (_, fitted, known) in COLUMNS {
                td { (parameter(fitted(row))) }
                @if let Some(published) = published {
                    td class="published" { (published.map_or("–".to_owned(), |p| number::fixed(known(p), 4))) }
                }
            }
            td { (notes.join(", ")) }
        }
    }
}

/// Value over its error; a dash over the emitted value where there is none.
pub fn parameter(parameter: &FittedParameter) -> Markup {
    let text = match parameter.value {
        Some(value) => number::with_error(value, parameter.std_error),
        None => format!("– ({})", number::fixed(parameter.emitted, 4)),
    };
    match text.split_once(" ± ") {
        Some((value, error)) => html! { (value) br; small { "± " (error) } },
        None => html! { (text) },
    }
}

/// Misfit per angle and quantity, fitted and published.
pub fn misfits(inputs: &Inputs) -> Markup {
    let rows = &inputs.parameters.metres.rows;
    let mut quantities: Vec<&str> =
        rows.iter().flat_map(|row| &row.misfit).map(|m| m.quantity.as_str()).collect();
    quantities.sort_unstable_by_key(|name| (*name != "t_ms", *name != "t_1", *name != "t_2", *name));
    quantities.dedup();
    html! {
        p { "Model minus reference over the thickness grid: root mean square / largest magnitude, in units of the \
             incident flux." }
        (misfit_table("Fitted", &quantities, rows.iter().map(|r| (r.theta_l_deg.to_string(), &r.misfit))))
        @if let Some(notes) = &inputs.notes {
            @let rows = notes.published_misfit.iter().map(|r| (r.theta_l_deg.to_string(), &r.misfit));
            (misfit_table("Published", &quantities, rows))
        }
    }
}

fn misfit_table<'a>(
    caption: &str,
    quantities: &[&str],
    rows: impl Iterator<Item = (String, &'a Vec<Misfit>)>,
) -> Markup {
    let entry = |misfits: &[Misfit], quantity: &str| {
        misfits
            .iter()
            .find(|m| m.quantity == quantity)
            .map_or("–".to_owned(), |m| format!("{} / {}", number::small(m.rms), number::small(m.max)))
    };
    html! {
        div class="wide" {
            table {
                caption { (caption) " parameters" }
                thead { tr { th { "θ" sub { "l" } " (°)" } @for name in quantities { th { (quantity_name(name)) } } } }
                tbody {
                    @for (angle, misfits) in rows {
                        tr { th { (angle) } @for name in quantities { td { (entry(misfits, name)) } } }
                    }
                }
            }
        }
    }
}

/// `t_ms` as T with the subscript ms.
pub fn quantity_name(name: &str) -> Markup {
    match name.split_once('_') {
        Some((letter, order)) => html! { (letter.to_uppercase()) sub { (order.replace("_plus", "+")) } },
        None => html! { (name) },
    }
}
