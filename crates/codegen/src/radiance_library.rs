//! The library of radiance: the angular model on top of the fluxes and the phase functions.

use crate::language::Library;
use crate::phase_library::versine;
use crate::radiance_test::Twin;
use crate::shader::{cases, medium_line};
use crate::text::{banner, fill, literal};
use crate::{CodegenError, Inputs};

/// μ_l, μ_v, Θ in degrees and τ of the embedded self-test: each shape in turn.
const TESTED: [[f64; 4]; 9] = [
    [0.8, 0.6, 120.0, 0.5],
    [0.8, 0.8, 8.0, 2.0],
    [0.4, 0.9, 60.0, 30.0],
    [0.9, 0.2, 142.0, 5.0],
    [0.3, 0.3, 30.0, 0.01],
    [0.1, 0.7, 170.0, 0.2],
    [0.6, 0.6, 1.0, 1.0],
    [1.0, 1.0, 180.0, 10.0],
    [0.7, 0.5, 20.0, 3.0],
];

/// The library, which stands below `needs`: weights and phase functions, and what they need.
pub(crate) fn library<'a>(inputs: &Inputs, needs: Vec<&'a Library<'a>>) -> Result<Library<'a>, CodegenError> {
    Ok(Library {
        head: head(inputs),
        name: "stratiform_radiance",
        code: fill(include_str!("wgsl/radiance.wgsl"), &self_test(inputs)?),
        owner: Some("StratiformRadiance"),
        glue: None,
        needs,
    })
}

fn self_test(inputs: &Inputs) -> Result<[(&'static str, String); 4], CodegenError> {
    let twin = Twin::new(inputs)?;
    let tested = TESTED.iter().enumerate();
    let vector = |(i, &[mu_l, mu_v, theta_deg, tau]): (usize, &[f64; 4])| {
        twin.vector([mu_l, mu_v, versine(theta_deg), tau], i % 3)
    };
    let vectors = tested.map(vector).collect::<Result<Vec<_>, _>>()?;
    let structure = |name: &str, values: &[f64]| {
        format!("{name}({})", values.iter().map(|value| literal(*value)).collect::<Vec<_>>().join(", "))
    };
    let sight = vectors.iter().map(|s| structure("StratiformSight", &[s.mu_l, s.mu_v, s.v, s.tau]));
    let [top, bottom] =
        [0, 1].map(|side| vectors.iter().map(move |v| structure("StratiformOrders", &v.orders()[side])));
    Ok([
        ("COUNT", vectors.len().to_string()),
        ("SIGHTS", cases(&sight.collect::<Vec<_>>())),
        ("TOP", cases(&top.collect::<Vec<_>>())),
        ("BOTTOM", cases(&bottom.collect::<Vec<_>>())),
    ])
}

fn head(inputs: &Inputs) -> String {
    banner(
        inputs,
        "Radiance of a stratiform layer: the angular model of Bouthors et al. 2006, section 4, corrected.",
    ) + "//\n\
           // Use        @USE@.\n\
           // Check      stratiform_radiance_self_test() returns the number of wrong values: 0, each held to\n\
           //            1e-4 (0.02 + |value|).\n\
           // Unit       reflectance factor pi L / (mu_l F0) of the sun's light, F0 its irradiance normal to the beam.\n\
           // Sight      mu_l, mu_v: cosines of sun and viewer to the slab's normal, both positive. v = 1 - cosTheta =\n\
           //            |V + L|^2 / 2 of unit vectors to viewer and sun. top: both are on the same side of the slab.\n\
           // Orders     count scattering by more than theta_f. Sums leave out the sun's disc and the halo around it.\n\
           // Domain     mu_l in [0, 1], mu_v in (0, 1], v in [0, 2], tau in [0, 1e6]; the isotropic shape grows as 1 / mu_v.\n\
           //            three_plus falls below 0 where r_three_plus or t_three_plus does, and is not clamped.\n"
        + &medium_line(inputs)
}
