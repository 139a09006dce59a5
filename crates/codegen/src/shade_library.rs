//! The library of radiance by the fitted model: single scattering exactly, everything beyond it as one exponential.

use crate::language::Library;
use crate::phase_library::versine;
use crate::shade_test::{Twin, coefficients};
use crate::shader::{cases, medium_line};
use crate::text::{banner, fill, literal};
use crate::{CodegenError, Inputs};
use stratiform_artifact::{RadianceMisfit, RadianceParametersDocument};
use stratiform_model::radiance::{POWERS, TERMS};

/// μ_l, μ_v, Θ in degrees and τ of the embedded self-test.
const TESTED: [[f64; 4]; 9] = [
    [0.8, 0.6, 120.0, 0.5],
    [0.8, 0.8, 8.0, 2.0],
    [0.4, 0.9, 60.0, 30.0],
    [0.9, 0.2, 142.0, 5.0],
    [0.3, 0.3, 30.0, 0.01],
    [0.1, 0.7, 170.0, 0.2],
    [0.6, 0.6, 10.0, 1.0],
    [1.0, 1.0, 180.0, 10.0],
    [0.7, 0.5, 20.0, 200.0],
];

/// The library, which stands below `needs`: weights and phase functions, and what they need.
pub(crate) fn library<'a>(
    inputs: &Inputs,
    document: &RadianceParametersDocument,
    needs: Vec<&'a Library<'a>>,
) -> Result<Library<'a>, CodegenError> {
    let coefficients = coefficients(document)?;
    let mut places = vec![
        ("SIMILARITY", literal(coefficients.similarity)),
        ("TOP", polynomials(&coefficients.top)),
        ("BOTTOM", polynomials(&coefficients.bottom)),
    ];
    places.extend(self_test(inputs, document)?);
    Ok(Library {
        head: head(inputs, document),
        name: "stratiform_shade",
        code: fill(include_str!("wgsl/shade.wgsl"), &places),
        owner: Some("StratiformShade"),
        glue: None,
        needs,
    })
}

/// c_k by Horner's scheme in x = u - 1/2, a line for each k: powers of u would cancel and leave single precision 4 digits.
fn polynomials(table: &[[f64; TERMS]; POWERS]) -> String {
    let polynomial = |k: usize| {
        let centred = about_half(table.map(|row| row[k])).map(literal);
        let (last, rest) = (centred[POWERS - 1].clone(), &centred[..POWERS - 1]);
        let sum = rest.iter().rev().enumerate().fold(last, |sum, (i, power)| match i {
            0 => format!("{power} + x * {sum}"),
            _ => format!("{power} + x * ({sum})"),
        });
        format!("        {sum},")
    };
    (0..TERMS).map(polynomial).collect::<Vec<_>>().join("\n")
}

/// A polynomial of u as one of u - 1/2, by synthetic division.
fn about_half(mut powers: [f64; POWERS]) -> [f64; POWERS] {
    for first in 0..POWERS {
        for j in (first..POWERS - 1).rev() {
            powers[j] += 0.5 * powers[j + 1];
        }
    }
    powers
}

fn self_test(
    inputs: &Inputs,
    document: &RadianceParametersDocument,
) -> Result<[(&'static str, String); 4], CodegenError> {
    let twin = Twin::new(inputs, document)?;
    let vector =
        |[mu_l, mu_v, theta_deg, tau]: &[f64; 4]| twin.vector([*mu_l, *mu_v, versine(*theta_deg), *tau]);
    let vectors = TESTED.iter().map(vector).collect::<Result<Vec<_>, _>>()?;
    let sight = vectors.iter().map(|s| {
        let numbers = [s.mu_l, s.mu_v, s.v, s.tau].map(literal);
        format!("StratiformSight({})", numbers.join(", "))
    });
    let [top, bottom] =
        [0, 1].map(|side| vectors.iter().map(|v| literal(v.sums()[side])).collect::<Vec<_>>());
    Ok([
        ("COUNT", vectors.len().to_string()),
        ("SIGHTS", cases(&sight.collect::<Vec<_>>())),
        ("EXPECTED_TOP", cases(&top)),
        ("EXPECTED_BOTTOM", cases(&bottom)),
    ])
}

fn head(inputs: &Inputs, document: &RadianceParametersDocument) -> String {
    banner(
        inputs,
        "Radiance of a stratiform layer: single scattering exactly, everything beyond it as one fitted exponential.",
    ) + "//\n\
           // Use        @USE@.\n\
           // Check      stratiform_shade_self_test() returns the number of wrong values: 0, each held to\n\
           //            1e-4 (0.02 + |value|).\n\
           // Unit       reflectance factor pi L / (mu_l F0) of the sun's light, F0 its irradiance normal to the beam.\n\
           // Sight      mu_l, mu_v: cosines of sun and viewer to the slab's normal, both positive. v = 1 - cosTheta =\n\
           //            |V + L|^2 / 2 of unit vectors to viewer and sun. top: both are on the same side of the slab.\n\
           // Many       sights at one tau: stratiform_shade_of_top(STRATIFORM_SIMILARITY * tau) once, then\n\
           //            stratiform_shade_top_with for each; likewise bottom.\n\
           // Droplets   of another effective radius, 4 to 20 um: stratiform_shade_once_top with their P_S(v) and\n\
           //            (1 - P_f) tau, plus stratiform_shade_more_top with their (1 - g) tau. Lossless clouds only.\n\
           // Domain     mu_l in [0, 1], mu_v in (0, 1], v in [0, 2], tau in [0, 1e6]; never negative. Left out: the sun's\n\
           //            disc, and the halo of light that met forward events only, which stratiform_halo adds.\n"
        + &medium_line(inputs)
        + &format!(
            "// Fit        {} of {}\n",
            crate::text::comment(&document.provenance.config_hash),
            crate::text::comment(&document.provenance.method)
        )
        + "// Error      relative to the exact radiance of this cloud: median, 95 %, worst and where.\n"
        + &document.misfit.iter().map(error_line).collect::<String>()
}

/// Median, 95th percentile and largest error at a set of points.
fn error_line(misfit: &RadianceMisfit) -> String {
    let RadianceMisfit { sample, worst_at: [tau, theta_l, theta_v, phi], .. } = misfit;
    let points = if misfit.fitted { "fitted" } else { "other" };
    let percent = |share: f64| format!("{:.1} %", 100.0 * share);
    format!(
        "//   {:<6} {:>5} {points} points, tau {} to {}, angles to {} deg: {}, {}, {}\n\
         //          at tau {tau:.2}, theta_l {theta_l:.0}, theta_v {theta_v:.0}, phi {phi:.0} deg\n",
        misfit.side.to_string(),
        misfit.points,
        sample.tau[0],
        sample.tau[1],
        sample.theta_deg[1],
        percent(misfit.median),
        percent(misfit.p95),
        percent(misfit.worst),
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_polynomial_about_a_half_has_the_same_values() {
        let powers = [1.0, -2.0, 3.0, -4.0, 5.0];
        let value = |powers: [f64; POWERS], x: f64| powers.iter().rev().fold(0.0, |sum, a| sum * x + a);
        for u in [0.0, 0.3, 0.5, 1.0] {
            assert!((value(powers, u) - value(about_half(powers), u - 0.5)).abs() < 1e-14);
        }
    }
}
