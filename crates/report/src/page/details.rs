//! Long tables, folded.

use super::{appendix, number};
use crate::chart::html as rich;
use crate::figures::chosen_angles;
use crate::input::Inputs;
use maud::{Markup, html};
use stratiform_artifact::{ConvergenceRow, OrdersRow, ParameterTable};

pub fn tables(inputs: &Inputs) -> Markup {
    html! {
        p { "Every number is also in the folder's CSV and JSON files." }
        details {
            summary { "Parameters in optical thickness (valid for every droplet number)" }
            (optical(&inputs.parameters.optical))
        }
        details { summary { "Correlations, and what stopped each fit" } (outcome(&inputs.parameters.metres)) }
        @for theta in chosen_angles(&inputs.orders) {
            details {
                summary { "Fluxes per order at θ" sub { "l" } " = " (theta) "°" }
                (orders(inputs.orders.iter().filter(|row| row.theta_l_deg.parse() == Ok(theta))))
            }
        }
        @if let Some(rows) = &inputs.convergence {
            details { summary { "Convergence" } (convergence(rows)) }
        }
    }
}

fn table(heading: &[&str], body: &Markup) -> Markup {
    html! {
        div class="wide" {
            table { thead { tr { @for name in heading { th { (rich(name)) } } } } tbody { (body) } }
        }
    }
}

fn optical(parameters: &ParameterTable) -> Markup {
    let beta = number::with_error(parameters.beta.value, Some(parameters.beta.std_error));
    let body = html! {
        @for row in &parameters.rows {
            tr {
                th { (row.theta_l_deg) }
                @for parameter in [&row.b, &row.c, &row.kappa_c, &row.t, &row.r] {
                    td { (appendix::parameter(parameter)) }
                }
            }
        }
    };
    html! {
        p { "β = T" sub { "ms" } "(τ = 1) = " (beta) "." }
        (table(&["θ_{l} (°)", "b", "c (per τ)", "κ_{c} (per τ)", "t", "r"], &body))
    }
}

fn outcome(parameters: &ParameterTable) -> Markup {
    let correlation = |value: Option<f64>| value.map_or("–".to_owned(), |v| number::fixed(v, 3));
    let body = html! {
        @for row in &parameters.rows {
            tr {
                th { (row.theta_l_deg) }
                td { (correlation(row.correlation_b_c)) }
                @for i in 0..3 { td { (correlation(row.correlation_kappa_c_t_r.map(|three| three[i]))) } }
                td class="words" { (row.stopped_multiple) }
                td class="words" { (row.stopped_orders) }
            }
        }
    };
    let heading = [
        "θ_{l} (°)",
        "b–c",
        "κ_{c}–t",
        "κ_{c}–r",
        "t–r",
        "fit of b, c stopped by",
        "fit of κ_{c}, t, r stopped by",
    ];
    table(&heading, &body)
}

fn orders<'a>(rows: impl Iterator<Item = &'a OrdersRow>) -> Markup {
    let body = html! {
        @for row in rows {
            tr {
                td { (number::small(row.thickness_m)) }
                td { (row.medium) }
                td { (row.order) }
                td { (number::with_error(row.reflectance, Some(row.reflectance_std_error))) }
                td { (number::with_error(row.transmittance, Some(row.transmittance_std_error))) }
            }
        }
    };
    table(&["H (m)", "medium", "order", "reflectance", "transmittance"], &body)
}

fn convergence(rows: &[ConvergenceRow]) -> Markup {
    let body = html! {
        @for row in rows {
            tr {
                td { (row.estimator) }
                td { (row.theta_l_deg) }
                td { (number::small(row.tau)) }
                td { (row.order) }
                td { (row.photons) }
                td { (number::small(row.seconds)) }
                td { (number::small(row.error)) }
                td { (number::small(row.std_error)) }
            }
        }
    };
    table(
        &["estimator", "θ_{l} (°)", "τ", "order", "photons or streams", "seconds", "error", "standard error"],
        &body,
    )
}
