//! What the numbers are for and where they come from.

use super::number;
use crate::chart::html as rich;
use crate::input::Inputs;
use maud::{Markup, html};
use stratiform_artifact::Provenance;

/// The first paragraph of the page.
pub fn lead(inputs: &Inputs) -> Markup {
    let medium = &inputs.parameters.medium;
    html! {
        p {
            "Light through a uniform layer of these droplets: reflectance and transmittance per scattering order from "
            @if inputs.parameters.provenance.is_random() { "photon tracing" } @else { "the deterministic solver" } " at " (medium.wavelength_um) " µm, and the parameters of the one-dimensional model of \
             Bouthors, Neyret and Lefebvre (2006) fitted to them. Extinction convention: "
            strong { (medium.extinction_convention) } ", κ = " (number::fixed(medium.extinction_per_m, 5)) " per metre; \
             θ" sub { "f" } " = " (medium.theta_f_deg) "°."
        }
    }
}

pub fn table(inputs: &Inputs) -> Markup {
    let medium = &inputs.parameters.medium;
    let facts = [
        ("wavelength of the transport", format!("{} µm", medium.wavelength_um)),
        ("extinction convention", medium.extinction_convention.to_string()),
        ("extinction of the full medium κ", format!("{} per m", medium.extinction_per_m)),
        ("single-scattering albedo ω", medium.single_scattering_albedo.to_string()),
        ("asymmetry parameter g", medium.asymmetry.to_string()),
        ("forward limit θ_{f}", format!("{}°", medium.theta_f_deg)),
        ("forward fraction P_{f}", medium.forward_fraction.to_string()),
        ("κ_{S} of the modified medium", format!("{} per m", inputs.parameters.metres.kappa_s)),
    ];
    let sources = [("parameters", &inputs.parameters.provenance), ("optics", &inputs.optics.provenance)];
    let notes = inputs.notes.as_ref().map(|notes| ("notes", &notes.provenance));
    html! {
        div class="wide" {
            table {
                caption { "Medium" }
                tbody { @for (name, value) in facts { tr { th class="words" { (rich(name)) } td class="words" { (value) } } } }
            }
        }
        div class="wide" {
            table {
                caption { "Artifacts" }
                thead {
                    tr {
                        th class="words" { "artifact" } th class="words" { "program" }
                        th class="words" { "config hash" } th { "seed" } th class="words" { "method" }
                    }
                }
                tbody { @for (name, provenance) in sources.into_iter().chain(notes) { (source(name, provenance)) } }
            }
        }
    }
}

fn source(name: &str, provenance: &Provenance) -> Markup {
    html! {
        tr {
            th class="words" { (name) }
            td class="words" { (provenance.program) " " (provenance.version) }
            td class="words" { code { (provenance.config_hash) } }
            td { (provenance.seed.map_or("–".to_owned(), |seed| seed.to_string())) }
            td class="words" { (provenance.method) }
        }
    }
}
