//! `comparison.html`: pictures, errors, ablation and costs in one file without references to others.

use super::input::Inputs;
use super::table;
use crate::chart::{Figure, html as rich};
use maud::{DOCTYPE, Markup, PreEscaped, html};
use stratiform_artifact::ComparisonDocument;

const STYLE: &str = concat!(
    include_str!("../page/style.css"),
    ".pair { display: grid; grid-template-columns: repeat(auto-fit, minmax(20rem, 1fr)); gap: 1rem; }\n\
     .pair svg { width: 100%; height: auto; }\n"
);

/// The page as text.
pub fn render(inputs: &Inputs, figures: &[Figure]) -> String {
    let title = format!("Stratiform: {} against its truth", inputs.document.scene);
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
                header { h1 { (title) } (lead(&inputs.document)) }
                main {
                    section id="errors" { h2 { "Errors" } (table::errors(&inputs.rows)) }
                    (pictures(inputs))
                    @if !inputs.ablation.is_empty() {
                        section id="ablation" { h2 { "What each part costs and does" } (table::ablation(&inputs.ablation)) }
                    }
                    @if !figures.is_empty() {
                        section id="cost" { h2 { "Cost" } @for figure in figures { (drawn(figure)) } }
                    }
                    section id="provenance" { h2 { "Provenance" } (provenance(&inputs.document)) }
                }
            }
        }
    };
    format!("{}\n", page.into_string())
}

fn lead(document: &ComparisonDocument) -> Markup {
    let ComparisonDocument { title, truth, adapter, width, height, .. } = document;
    html! {
        p { (title) ". " (width) " × " (height) " pixels, drawn on " (adapter) ". Truth: " (truth) "." }
        p {
            "Errors are picture less truth. A relative error has the larger of the truth and " (100.0 * document.floor_share) " % of the \
             truth's mean as denominator. The truth's own noise is taken off an rms error; the median of its size stands beside that of \
             the error. FLIP is what an observer sees who alternates between both at " (document.pixels_per_degree) " pixels per degree, \
             from 0 to 1; the truth's noise is part of that."
        }
    }
}

/// A section for each part, the whole picture first.
fn pictures(inputs: &Inputs) -> Markup {
    let mut parts: Vec<&str> = Vec::new();
    for (picture, _) in &inputs.pictures {
        if !parts.contains(&picture.contribution.as_str()) {
            parts.push(&picture.contribution);
        }
    }
    html! { @for part in parts {
        section id=(part) {
            h2 { @if part == "all" { "Whole picture" } @else { "Part: " (part) } }
            div class="pair" {
                @for (_, drawing) in inputs.pictures.iter().filter(|(picture, _)| picture.contribution == part) {
                    (PreEscaped(drawing))
                }
            }
        }
    } }
}

fn drawn(figure: &Figure) -> Markup {
    html! {
        figure id=(figure.name) {
            div class="drawing" { (figure.draw()) }
            figcaption { (rich(&figure.caption)) " File: " code { (figure.name) ".svg" } "." }
        }
    }
}

fn provenance(document: &ComparisonDocument) -> Markup {
    let provenance = &document.provenance;
    html! { p {
        (provenance.program) " " (provenance.version) ", inputs " code { (provenance.config_hash) }
        @if let Some(seed) = provenance.seed { ", seed " (seed) }
        ": " (provenance.method) ". Exposure " (document.exposure_ev) " EV."
    } }
}
