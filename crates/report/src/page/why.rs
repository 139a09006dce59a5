//! Why the published table differs from the regenerated one, in numbers from `notes.json`.

use super::{appendix, number};
use crate::input::Inputs;
use maud::{Markup, html};
use stratiform_artifact::{AngularShares, CoarseTabulation, ModifiedBias, NotesDocument, PublishedMisfit};

pub fn section(inputs: &Inputs) -> Markup {
    let Some(notes) = &inputs.notes else {
        return html! { p { "No " code { "notes.json" } " in the folder, so no numbers to explain it." } };
    };
    let theta_f = inputs.parameters.medium.theta_f_deg;
    let random = notes.provenance.is_random();
    if notes.published_shares.is_none() {
        return html! { p { "No published table belongs to this cloud." } (bias(&notes.modified_bias, random)) };
    }
    html! {
        p { "Published: " (notes.published_source) "." }
        (forward_peak(notes, theta_f))
        (tabulation(&notes.coarse_tabulation, theta_f))
        (bias(&notes.modified_bias, random))
        (worst(&notes.published_misfit))
    }
}

fn forward_peak(notes: &NotesDocument, theta_f: f64) -> Markup {
    let row = |name: String, shares: &AngularShares| {
        html! {
            tr {
                th class="words" { (name) }
                td { (number::percent(shares.forward)) }
                td { (number::percent(shares.wide)) }
                td { (number::percent(shares.backward)) }
            }
        }
    };
    html! {
        h3 { "The forward peak" }
        p { "The share of light scattered by less than θ" sub { "f" } " = " (theta_f) "°, P" sub { "f" } ", sets the \
             extinction of the modified medium, κ" sub { "S" } " = (1 − P" sub { "f" } ")κ, and with it every order." }
        div class="wide" {
            table {
                thead {
                    tr {
                        th class="words" { "shares" } th { "0 to " (theta_f) "°" } th { (theta_f) " to 90°" }
                        th { "beyond 90°" }
                    }
                }
                tbody {
                    @if let Some(published) = &notes.published_shares { (row("published".to_owned(), published)) }
                    @for entry in &notes.shares {
                        (row(format!("converged, {} µm", entry.wavelength_um), &entry.shares))
                    }
                }
            }
        }
    }
}

fn tabulation(tables: &[CoarseTabulation], theta_f: f64) -> Markup {
    if tables.is_empty() {
        return html! {};
    }
    html! {
        h3 { "Coarse tabulation" }
        p { "A phase function tabulated in equal steps and integrated linearly in cosΘ does not resolve the peak. Its \
             integral should be 1; dividing by what comes out leaves a P" sub { "f" } "(" (theta_f) "°) near the \
             published one. This is a plausible origin of the published share, not a proof." }
        div class="wide" {
            table {
                thead {
                    tr {
                        th { "λ (µm)" } th { "step (°)" } th { "integral" } th { "P" sub { "f" } " as it stands" }
                        th { "P" sub { "f" } " renormalised" }
                    }
                }
                tbody {
                    @for table in tables {
                        tr {
                            th { (table.wavelength_um) }
                            td { (table.step_deg) }
                            td { (number::fixed(table.raw_integral, 3)) }
                            td { (number::fixed(table.raw_forward_fraction, 3)) }
                            td { (number::fixed(table.forward_fraction, 3)) }
                        }
                    }
                }
            }
        }
    }
}

fn bias(rows: &[ModifiedBias], random: bool) -> Markup {
    if rows.is_empty() {
        return html! {};
    }
    html! {
        h3 { "Bias of the modified medium" }
        p { "Light scattered by less than θ" sub { "f" } " is treated as unscattered in the orders. The total \
             transmittance then differs from the full medium's; here the largest difference over all thicknesses"
            @if random { ", which chance alone makes two to three standard errors large" } "." }
        div class="wide" {
            table {
                thead { tr { th { "θ" sub { "l" } " (°)" } th { "H (m)" } th { "T full − T modified" } } }
                tbody {
                    @for row in rows {
                        tr {
                            th { (row.theta_l_deg) }
                            td { (number::small(row.thickness_m)) }
                            td { (number::with_error(row.difference, Some(row.std_error))) }
                        }
                    }
                }
            }
        }
    }
}

/// The largest misfit of the published table, in a sentence.
fn worst(rows: &[PublishedMisfit]) -> Markup {
    let all = rows.iter().flat_map(|row| row.misfit.iter().map(move |m| (row.theta_l_deg, m)));
    let Some((angle, misfit)) = all.max_by(|(_, a), (_, b)| a.max.abs().total_cmp(&b.max.abs())) else {
        return html! {};
    };
    html! {
        h3 { "What it amounts to" }
        p { "Over all angles and thicknesses the published parameters miss by at most "
            (number::small(misfit.max.abs())) " of the incident flux, in " (appendix::quantity_name(&misfit.quantity))
            " at θ" sub { "l" } " = " (angle) "° and H = " (number::small(misfit.max_at)) " m. The misfits of every \
             angle and quantity stand under " a href="#misfit" { "Misfit" } "." }
    }
}
