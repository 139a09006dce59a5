//! Symbols and units used on the page.

use crate::chart::html as rich;
use maud::{Markup, html};

const TERMS: [(&str, &str); 21] = [
    (
        "θ_{l}",
        "angle of the incident light to the slab's normal, degrees; 0 is the zenith. “diffuse”: uniform light from the whole upper hemisphere",
    ),
    ("H", "geometrical thickness of the slab, m"),
    ("τ", "extinction optical thickness of the full medium along the normal, κH, no unit"),
    ("κ", "extinction of the full medium, 1/m"),
    ("convention", "“paper”: κ = N_{0}πr_{e}^{2}; “mie”: κ = N_{0}⟨Q_{ext}πr^{2}⟩, the physical extinction"),
    ("N_{0}, r_{e}", "droplets per cm^{3}; effective radius ⟨r^{3}⟩/⟨r^{2}⟩, µm"),
    ("Θ", "scattering angle between the directions of flight before and after, degrees; 0 is forward"),
    ("P", "phase function with mean 1 over the sphere; the density per steradian is P/4π"),
    ("g", "asymmetry parameter, the mean of cosΘ"),
    ("ω", "single-scattering albedo, the share of extinction that is scattering"),
    ("θ_{f}, P_{f}", "limit of the forward peak, degrees, and the share of light scattered by less than it"),
    ("full medium", "κ and P as they are"),
    (
        "modified medium",
        "scattering by less than θ_{f} counts as none: κ_{S} = (1 − P_{f})κ when nothing is absorbed; its orders count wide events only",
    ),
    ("T, R", "transmitted and reflected flux per unit flux incident on the slab"),
    (
        "subscripts 0, 1, 2, 3+",
        "light scattered wide that often, or three times and more; 0 is in the transmittance only",
    ),
    ("subscript ms", "light of all orders, order 0 included"),
    ("β", "T_{ms} of a slab of thickness 1 (1 m, or τ = 1)"),
    ("b, c", "correction of T_{ms} for the angle: factor b + (1 − b)e^{−cH}; c in 1/m (or per τ)"),
    (
        "κ_{c}, t, r",
        "extinction (1/m, or per τ) and the forward and backward coefficients of the model's orders 1 and 2",
    ),
    ("±", "one standard error of what photons gave; the estimated largest error of what the solver gave"),
    ("rms", "root mean square over the thickness grid"),
];

pub fn list() -> Markup {
    html! { dl { @for (term, meaning) in TERMS { dt { (rich(term)) } dd { (rich(meaning)) } } } }
}
