//! `atlas.html`: counts, promises and maps in one file.

use super::input::Inputs;
use super::map::Map;
use super::tint::MEANINGS;
use maud::{DOCTYPE, Markup, PreEscaped, html};
use stratiform_artifact::AtlasCount;

const STYLE: &str = include_str!("../page/style.css");

/// The page as text.
pub fn render(inputs: &Inputs, maps: &[Map<'_>]) -> String {
    let title = "Stratiform: where methods break";
    let page = html! {
        (DOCTYPE)
        html lang="en" {
            head {
                meta charset="utf-8";
                meta name="viewport" content="width=device-width, initial-scale=1";
                title { (title) }
                style { (PreEscaped(STYLE)) }
            }
            body {
                header { h1 { (title) } (lead(inputs)) }
                main {
                    section id="counts" { h2 { "Counts" } (counts(&inputs.counts)) }
                    section id="promises" { h2 { "Promises" } (promises(inputs)) }
                    section id="maps" {
                        h2 { "Maps" }
                        @for map in maps { figure id=(map.file()) { (map.draw()) figcaption { (map.name()) } } }
                    }
                    section id="provenance" {
                        h2 { "Provenance" }
                        p { (inputs.document.provenance.program) " " (inputs.document.provenance.version) ", inputs "
                            code { (inputs.document.provenance.config_hash) } }
                    }
                }
            }
        }
    };
    format!("{}\n", page.into_string())
}

fn lead(inputs: &Inputs) -> Markup {
    let (share, truth) = (inputs.document.largest_f32_share, inputs.document.largest_truth_error);
    html! {
        p {
            "Each cell is one value of one method at one place of a plane through a base point; fluxes show the worse of R and T. In f32 a \
             value has lost its digits if it is more than " (100.0 * share) " % off f64. Promises are held against the deterministic \
             solver on the full medium where that knows the answer to " (100.0 * truth) " %."
        }
        ul { @for plane in &inputs.document.planes {
            li { (plane.x_name) " against " (plane.y_name) ", held: " (plane.held) }
        } }
    }
}

fn counts(counts: &[AtlasCount]) -> Markup {
    let of = |row: &AtlasCount| {
        [
            row.ok,
            row.no_promise,
            row.refused,
            row.loses_digits,
            row.over_bound,
            row.above_one,
            row.negative,
            row.not_finite,
            row.not_refused,
        ]
    };
    html! {
        div class="wide" { table {
            thead { tr { th { "method" } th { "precision" } th { "values" } @for name in MEANINGS { th { (name) } } th { "largest error" } } }
            tbody { @for row in counts { tr {
                td { (row.method) } td { (row.precision) } td { (row.cells) }
                @for count in of(row) { td { (count) } }
                td { @if let Some(error) = row.worst_error { (format!("{:.3}", error)) } }
            } } }
        } }
    }
}

fn promises(inputs: &Inputs) -> Markup {
    let none = "finite and not negative";
    html! {
        dl { @for method in &inputs.document.methods {
            dt { (method.name) ": " (method.title) }
            dd { "radiance: " (method.radiance.as_deref().unwrap_or(none)) }
            dd { "fluxes: " (method.flux.as_deref().unwrap_or(none)) }
        } }
    }
}
