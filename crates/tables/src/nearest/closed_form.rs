//! Parameters from the droplet diameter: J. Jendersie, E. d'Eon, An Approximate Mie Scattering Function for Fog and Cloud
//! Rendering, SIGGRAPH Talks 2023, the fit for 5 µm ≤ d ≤ 50 µm.
//!
//! g_HG = exp(-0.0990567/(d - 1.67154)), g_D = exp(-2.20679/(d + 3.91029) - 0.428934),
//! α = exp(3.62489 - 8.29288/(d + 5.52825)), w_D = exp(-0.599085/(d - 0.641583) - 0.665888), d in µm.
//! Which diameter stands for a cloud of many sizes the paper leaves open: small droplets widen the peak, so that a broad
//! distribution looks like droplets smaller than its effective diameter 2 r_e. [`nearest_diameter`] finds the one.

use super::measure::Sphere;
use super::{Blend, Objective};
use stratiform_optics::phase::PhaseTable;
use stratiform_quantities::{DomainError, Range};

/// Diameters for which the fit was made, µm.
pub const DIAMETER_UM: Range = Range::closed(5.0, 50.0);

/// The blend for droplets of diameter `diameter_um`.
///
/// # Errors
/// [`DomainError`] outside [`DIAMETER_UM`].
pub fn jendersie_deon(diameter_um: f64) -> Result<Blend, DomainError> {
    let d = DIAMETER_UM.check("droplet diameter_um", diameter_um)?;
    Ok(Blend {
        w: libm::exp(-0.599085 / (d - 0.641583) - 0.665888),
        g1: libm::exp(-0.0990567 / (d - 1.67154)),
        g2: libm::exp(-2.20679 / (d + 3.91029) - 0.428934),
        alpha: libm::exp(3.62489 - 8.29288 / (d + 5.52825)),
    })
}

/// Steps of the search over ln d, which are then halved.
const STEPS: u32 = 60;

/// The diameter in [`DIAMETER_UM`] whose blend is nearest to `table`, to 1e-4 of itself.
///
/// # Errors
/// None in practice: every diameter tried is in the fit's domain.
pub fn nearest_diameter(table: &PhaseTable, objective: Objective) -> Result<f64, DomainError> {
    let sphere = Sphere::new(table);
    let distance = |ln: f64| -> Result<f64, DomainError> {
        let d = libm::exp(ln).clamp(DIAMETER_UM.min, DIAMETER_UM.max);
        Ok(objective.of(&sphere, &jendersie_deon(d)?.phase()?))
    };
    let (first, last) = (libm::log(DIAMETER_UM.min), libm::log(DIAMETER_UM.max));
    let mut step = (last - first) / f64::from(STEPS);
    let mut best = (f64::INFINITY, first);
    for i in 0..=STEPS {
        let ln = first + step * f64::from(i);
        let off = distance(ln)?;
        best = if off < best.0 { (off, ln) } else { best };
    }
    while step > 1e-4 {
        step *= 0.5;
        for ln in [best.1 - step, best.1 + step] {
            let off = distance(ln.clamp(first, last))?;
            best = if off < best.0 { (off, ln.clamp(first, last)) } else { best };
        }
    }
    Ok(libm::exp(best.1).clamp(DIAMETER_UM.min, DIAMETER_UM.max))
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::HashMap;

    fn coefficients() -> HashMap<String, f64> {
        let rows =
            stratiform_reference_data::rows::<(String, f64)>("jendersie-deon-2023", "coefficients.csv");
        rows.unwrap().into_iter().collect()
    }

    #[test]
    fn the_coefficients_are_those_published() {
        let all = coefficients();
        let c = |name: &str| all[&format!("large_{name}")];
        for d in [5.0, 14.0, 50.0] {
            let blend = jendersie_deon(d).unwrap();
            let expected = [
                libm::exp(-c("g_hg_1") / (d - c("g_hg_2"))),
                libm::exp(-c("g_d_1") / (d + c("g_d_2")) - c("g_d_3")),
                libm::exp(c("alpha_1") - c("alpha_2") / (d + c("alpha_3"))),
                libm::exp(-c("w_d_1") / (d - c("w_d_2")) - c("w_d_3")),
            ];
            assert_eq!([blend.g1, blend.g2, blend.alpha, blend.w], expected);
        }
    }

    /// The same paper's fit for 1.5 µm ≤ d < 5 µm, of another form, meets it at 5 µm: a coefficient wrong in either would open
    /// a gap.
    #[test]
    fn it_meets_the_fit_for_smaller_droplets() {
        let all = coefficients();
        let c = |name: &str| all[&format!("small_{name}")];
        let l = libm::log(5.0);
        let g1 = c("g_hg_1") * libm::log(l) + c("g_hg_2");
        let g2 = c("g_d_1") - c("g_d_2") / (-2.0 * l + libm::tan(l) + c("g_d_3"));
        let alpha = c("alpha_1") * l + c("alpha_2");
        let wave = libm::cos(c("w_d_2") * (libm::log(l) - c("w_d_3")));
        let w = c("w_d_1") * (l - wave) + c("w_d_4");
        let blend = jendersie_deon(5.0).unwrap();
        assert!((blend.g1 - g1).abs() < 2e-3 && (blend.g2 - g2).abs() < 6e-3, "{blend:?} {g1} {g2}");
        assert!(
            (blend.w - w).abs() < 7e-3 && (blend.alpha / alpha - 1.0).abs() < 0.06,
            "{blend:?} {w} {alpha}"
        );
    }

    #[test]
    fn diameters_outside_the_fit_are_refused() {
        for d in [4.99, 50.01, f64::NAN] {
            assert!(jendersie_deon(d).is_err(), "{d}");
        }
    }
}
