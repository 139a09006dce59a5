//! The library of radiance: the angular model on top of the fluxes and the phase functions.

use crate::Inputs;
use crate::language::Library;
use crate::shader::medium_line;
use crate::text::banner;

/// The library, which stands below `fluxes` and `phase`.
pub(crate) fn library<'a>(inputs: &Inputs, fluxes: &'a Library<'a>, phase: &'a Library<'a>) -> Library<'a> {
    Library {
        head: head(inputs),
        name: "stratiform_radiance",
        code: include_str!("wgsl/radiance.wgsl").to_owned(),
        owner: Some("StratiformRadiance"),
        glue: None,
        needs: vec![fluxes, phase],
    }
}

fn head(inputs: &Inputs) -> String {
    banner(inputs, "Radiance of a stratiform layer: the angular model of Bouthors et al. 2006, section 4, corrected.")
        + "//\n\
           // Use        @USE@.\n\
           // Unit       reflectance factor pi L / (mu_l F0) of light of the sun, F0 its irradiance normal to the beam. Finite\n\
           //            at grazing light but for the isotropic shape at a grazing view.\n\
           // Sight      mu_l, mu_v: cosines of sun and viewer to the slab's normal, both positive. v = 1 - cosTheta =\n\
           //            |V + L|^2 / 2 of unit vectors to viewer and sun. top: both are on the same side of the slab.\n"
        + &medium_line(inputs)
}
