//! Parameters from the droplet diameter: J. Jendersie, E. d'Eon, An Approximate Mie Scattering Function for Fog and Cloud
//! Rendering, SIGGRAPH Talks 2023, the fit for 5 µm ≤ d ≤ 50 µm.
//!
//! g_HG = exp(-0.0990567/(d - 1.67154)), g_D = exp(-2.20679/(d + 3.91029) - 0.428934),
//! α = exp(3.62489 - 8.29288/(d + 5.52825)), w_D = exp(-0.599085/(d - 0.641583) - 0.665888), d in µm.
//! For a cloud of many sizes take the effective diameter 2 r_e: P is an average weighted by cross-section.

use super::Blend;
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

#[cfg(test)]
mod tests {
    use super::*;

    /// The same paper's fit for 1.5 µm ≤ d ≤ 5 µm, written independently of the one above, meets it at 5 µm: two pieces
    /// fitted to one function. A wrong coefficient in either opens a gap.
    #[test]
    fn it_meets_the_fit_for_smaller_droplets() {
        let ln = libm::log(5.0);
        let alpha = 7.30354 * ln + 6.31675;
        let g2 = 0.500411 - 0.081287 / (-2.0 * ln + libm::tan(ln) + 1.27551);
        let g1 = 0.0604931 * libm::log(ln) + 0.940256;
        let w = 0.026914 * (ln - libm::cos(5.68947 * (libm::log(ln) - 0.0292149))) + 0.376475;
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
