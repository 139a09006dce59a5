//! The library of what the angular models share: weights of one and two scatterings, transparency, units.

use crate::Inputs;
use crate::language::Library;
use crate::shader::medium_line;
use crate::text::banner;

/// The library, which stands below `fluxes`.
pub(crate) fn library<'a>(inputs: &Inputs, fluxes: &'a Library<'a>) -> Library<'a> {
    Library {
        head: head(inputs),
        name: "stratiform_weights",
        code: include_str!("wgsl/weights.wgsl").to_owned(),
        owner: None,
        glue: None,
        needs: vec![fluxes],
    }
}

fn head(inputs: &Inputs) -> String {
    banner(
        inputs,
        "What a slab does to light that is scattered once, twice, or not at all: for the libraries of radiance.",
    ) + "//\n\
           // Use        @USE@.\n\
           // Check      by the self-tests of stratiform_radiance, stratiform_shade and stratiform_halo.\n\
           // Sight      mu_l, mu_v: cosines of sun and viewer to the slab's normal, both positive. v = 1 - cosTheta =\n\
           //            |V + L|^2 / 2 of unit vectors to viewer and sun. top: both are on the same side of the slab.\n\
           // Domain     mu_l in [0, 1], mu_v in (0, 1], tau in [0, 1e6]. Nothing is checked or clamped here.\n"
        + &medium_line(inputs)
}
