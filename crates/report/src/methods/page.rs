//! `chart.html`: one file, its script and data inside, without references to other files.

use super::input::Inputs;
use super::scene::{CLASSES, QUANTITIES};
use crate::ReportError;
use crate::chart::{Figure, html as rich, palette};
use maud::{DOCTYPE, Markup, PreEscaped, html};
use stratiform_artifact::{ChartDocument, to_json};

const STYLE: &str = concat!(include_str!("../page/style.css"), include_str!("chart.css"));
const SCRIPT: &str = include_str!("chart.js");

/// Column in files, name.
const ERRORS: [(&str, &str); 4] = [
    ("median", "median error"),
    ("p95", "95th percentile of the error"),
    ("worst", "largest error"),
    ("bias", "size of the bias"),
];

const COLUMNS: [&str; 9] =
    ["method", "median", "95 %", "largest", "bias", "ns", "table bytes", "answered", "on the front"];

/// The page as text.
///
/// # Errors
/// [`ReportError::Artifact`] if a number cannot be written.
pub fn render(inputs: &Inputs, figures: &[Figure]) -> Result<String, ReportError> {
    // Inside a script element only its end tag means something.
    let data = to_json(&inputs.rows)?.replace("</", "<\\/");
    let title = "Stratiform: error against cost";
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
                header { h1 { (title) } (lead(&inputs.manifest)) }
                main {
                    section id="chart" {
                        h2 { "Chart" }
                        (controls(&inputs.manifest))
                        svg id="plot" viewBox="0 0 790 465" role="img" aria-label=(title) {}
                        noscript { p { "Without scripts: the figures below show every method." } }
                        (legend())
                        div class="wide" { table {
                            thead { tr { @for name in COLUMNS { th { (name) } } } }
                            tbody id="rows" {}
                        } }
                    }
                    section id="figures" { h2 { "Figures" } @for figure in figures { (drawn(figure)) } }
                    section id="methods" { h2 { "Methods" } (methods(&inputs.manifest)) }
                    section id="scenes" { h2 { "Scenes" } (scenes(&inputs.manifest)) }
                    section id="provenance" { h2 { "Provenance" } (provenance(&inputs.manifest)) }
                }
                script type="application/json" id="data" { (PreEscaped(data)) }
                script { (PreEscaped(SCRIPT)) }
            }
        }
    };
    Ok(page.into_string())
}

fn lead(manifest: &ChartDocument) -> Markup {
    html! {
        p {
            "Errors are relative: a method's value less the truth, over the truth. The truth is the deterministic solver on the full \
             medium; points where its own error may exceed " (100.0 * manifest.largest_truth_error)
            " % are left out and counted. Radiances are reflectance factors πL/(μ"
            sub { "l" } "F" sub { "0" } ") without the unscattered beam."
        }
        p {
            "Cost is the time of one evaluation on one thread of the machine that made this chart: in single precision for shader \
             code; for solvers and tracers, which are held against a part of the points, their share of a batch."
        }
    }
}

fn controls(manifest: &ChartDocument) -> Markup {
    html! {
        div class="controls" {
            label { "Scene " select id="scene" {
                @for scene in &manifest.scenes { option value=(scene.name) { (scene.title) } }
            } }
            label { "Quantity " select id="quantity" {
                @for (value, name) in QUANTITIES { option value=(value) { (name) } }
            } }
            label { "Error " select id="error" {
                @for (value, name) in ERRORS { option value=(value) { (name) } }
            } }
            button type="button" id="all" { "all" }
            button type="button" id="none" { "none" }
        }
        div class="controls" {
            @for method in &manifest.methods {
                @let colour = colour(&method.class);
                label {
                    input type="checkbox" checked data-method=(method.name) data-colour=(colour);
                    span class="swatch" style=(format!("background:{colour}")) {}
                    (method.name)
                }
            }
        }
    }
}

fn legend() -> Markup {
    html! { p {
        "Dotted: the front, the methods that no other shown one beats in both cost and error. A star: the method refuses some of the \
         scene's points, and cannot stand on the front."
    } }
}

fn colour(class: &str) -> &'static str {
    CLASSES.iter().find(|known| known.0 == class).map_or(palette::GREY, |known| known.2)
}

fn drawn(figure: &Figure) -> Markup {
    html! {
        figure id=(figure.name) {
            div class="drawing" { (figure.draw()) }
            figcaption { (rich(&figure.caption)) " File: " code { (figure.name) ".svg" } "." }
        }
    }
}

fn methods(manifest: &ChartDocument) -> Markup {
    html! { div class="wide" { table {
        thead { tr { th { "name" } th { "method" } th { "class" } th { "source" } } }
        tbody { @for method in &manifest.methods {
            tr { td { code { (method.name) } } td { (method.title) } td { (method.class) } td { (method.source) } }
        } }
    } } }
}

fn scenes(manifest: &ChartDocument) -> Markup {
    let words = |values: &[f64]| values.iter().map(|v| format!("{v:.3}")).collect::<Vec<_>>().join(", ");
    html! { div class="wide" { table {
        thead { tr {
            th { "scene" } th { "r" sub { "e" } " (µm)" } th { "λ (µm)" } th { "κH" } th { "θ" sub { "l" } " (°)" }
            th { "θ" sub { "v" } " (°)" } th { "φ (°)" } th { "radiances" } th { "left out" } th { "largest error of the truth" }
        } }
        tbody { @for scene in &manifest.scenes { @for cloud in &scene.clouds {
            tr {
                td { (scene.name) } td { (format!("{:.2}", cloud.effective_radius_um)) } td { (cloud.wavelength_um) }
                td { (words(&cloud.tau)) } td { (words(&cloud.theta_l_deg)) } td { (words(&cloud.theta_v_deg)) }
                td { (words(&cloud.phi_deg)) } td { (cloud.radiances) } td { (cloud.excluded) }
                td { (format!("{:.1e}", cloud.worst_truth_error)) }
            }
        } } }
    } } }
}

fn provenance(manifest: &ChartDocument) -> Markup {
    let provenance = &manifest.provenance;
    html! { p {
        (provenance.program) " " (provenance.version) ", inputs " code { (provenance.config_hash) } ": " (provenance.method) "."
        @if manifest.quick { " A quick chart: few points." }
    } }
}
