//! What the droplets do to light, one line per wavelength.

use super::number;
use maud::{Markup, html};
use stratiform_artifact::{OpticsDocument, WavelengthOptics};

pub fn table(optics: &OpticsDocument) -> Markup {
    html! {
        p {
            "Droplets: " (optics.droplets) ". Effective radius " (optics.effective_radius_um) " µm, effective \
             variance " (number::fixed(optics.effective_variance, 4)) ", " (optics.number_density_per_cm3)
            " droplets per cm³."
        }
        div class="wide" {
            table {
                caption { "Averages over the distribution" }
                thead {
                    tr {
                        th { "λ (µm)" } th { "n" } th { "k" } th { "κ (1/m)" br; "paper" } th { "κ (1/m)" br; "mie" }
                        th { "ω" } th { "g" } th { "θ" sub { "f" } " (°)" } th { "P" sub { "f" } }
                        th { "radii" } th { "error of g" } th { "error of P" sub { "f" } }
                    }
                }
                tbody { @for wavelength in &optics.wavelengths { (row(wavelength)) } }
            }
        }
    }
}

fn row(w: &WavelengthOptics) -> Markup {
    let [n, k] = w.refractive_index;
    html! {
        tr {
            th { (w.wavelength_um) }
            td { (number::fixed(n, 4)) }
            td { (number::small(k)) }
            td { (number::fixed(w.extinction_per_m.paper, 5)) }
            td { (number::fixed(w.extinction_per_m.mie, 5)) }
            td { (number::fixed(w.single_scattering_albedo, 6)) }
            td { (number::fixed(w.asymmetry, 4)) }
            td { (w.forward_fraction.theta_f_deg) }
            td { (number::fixed(w.forward_fraction.value, 4)) }
            td { (w.reached_error.radii) }
            td { (number::small(w.reached_error.asymmetry)) }
            td { (number::small(w.reached_error.forward_fraction)) }
        }
    }
}
