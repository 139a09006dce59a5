//! Single scattering, in closed form: light scattered once, and nothing else.
//!
//! Chandrasekhar 1950, *Radiative Transfer*, ch. 7 §45.3. With p = τ/μ_l, q = τ/μ_v and E(x) = (1-e^{-x})/x, as reflectance factor:
//!
//! ```text
//! top      ω P(Θ) p/(4 μ_v) E(p+q)        = ω P(Θ)/(4 (μ_l+μ_v)) (1 - e^-(p+q))
//! bottom   ω P(Θ) p/(4 μ_v) e^-min(p,q) E(|p-q|)
//! ```
//!
//! The surveys' single-scattering methods (Hufnagel & Held 2012, section 4.1.1: Kajiya & von Herzen 1984, Blinn 1982 and their
//! successors) march this integral; in a homogeneous slab it is closed. P is the cloud's own, or Henyey and Greenstein's with the
//! cloud's g, or the blend of Jendersie & d'Eon 2023 at the diameter that suits the cloud best. No fluxes.

use crate::lobe::{Hg, HgDraine, Lobe};
use crate::lookup::{EMITTED_TEXELS, Exact, Texels};
use crate::scalar::{Scalar, least, mean_decay};
use crate::shade::{InSingle, Shade, Shaded};
use crate::simple::Simple;
use crate::{Card, Class, Cloud, Domain, MethodError, Promises, Ready};
use stratiform_model::angular::Sight;
use stratiform_quantities::{Range, Side};
use stratiform_tables::nearest::{Objective, jendersie_deon, nearest_diameter};

/// Light scattered once per unit of ωP; the sun's path is dimmed by `dimming` times its extinction.
pub(crate) fn once<F: Scalar>(tau: F, sight: &Sight<F>, dimming: F) -> F {
    let (p, q) = (tau / sight.mu_l, tau / sight.mu_v);
    let sun = dimming * p;
    let seen = match sight.side {
        Side::Top => mean_decay(sun + q),
        Side::Bottom if sun < q => (-sun).exp() * mean_decay(q - sun),
        Side::Bottom => (-least(sun, q)).exp() * mean_decay(sun - q),
    };
    F::of(0.25) * (p / sight.mu_v) * seen
}

/// ω and P.
pub(crate) struct SingleScattering<F, P> {
    pub(crate) omega: F,
    pub(crate) phase: P,
}

impl<F: Scalar, P: Lobe<F>> Shade<F> for SingleScattering<F, P> {
    fn radiance(&self, tau: F, sight: &Sight<F>) -> F {
        self.omega * self.phase.at(sight.v) * once(tau, sight, F::of(1.0))
    }

    fn fluxes(&self, _tau: F, _mu_l: F) -> (F, F) {
        (F::of(0.0), F::of(0.0))
    }
}

fn card(name: &str, title: &'static str, source: &'static str, table_bytes: usize) -> Card {
    Card {
        name: name.to_owned(),
        title,
        source,
        class: Class::SingleScattering,
        domain: Domain::EVERYWHERE,
        promises: Promises::default(),
        radiance: true,
        flux: false,
        table_bytes: Some(table_bytes),
    }
}

/// The formula with these phase functions.
fn shaded<D: Lobe<f64> + 'static, S: Lobe<f32> + 'static>(
    card: &Card,
    cloud: &Cloud,
    (double, single): (D, S),
) -> Box<dyn Ready> {
    let omega = cloud.omega().get();
    Box::new(Shaded {
        card: card.clone(),
        double: SingleScattering { omega, phase: double },
        single: InSingle(SingleScattering { omega: omega as f32, phase: single }),
    })
}

/// With the cloud's phase function: exact in double precision, and on [`EMITTED_TEXELS`] in single.
pub(crate) fn mie() -> Simple {
    let source = "Chandrasekhar 1950, Radiative Transfer, section 45.3; Mie phase function";
    let card = card("single-mie", "Single scattering, Mie", source, 4 * EMITTED_TEXELS);
    Simple::new(card, |card, cloud| {
        Ok(shaded(card, cloud, (Exact::once(cloud), Texels::once(cloud, EMITTED_TEXELS)?)))
    })
}

/// With the cloud's phase function on this many texels in both precisions.
pub(crate) fn mie_texels(texels: usize) -> Simple {
    let source = "Chandrasekhar 1950, Radiative Transfer, section 45.3; Mie phase function in a texture";
    let card = card(&format!("single-mie:{texels}"), "Single scattering, Mie", source, 4 * texels);
    Simple::new(card, move |card, cloud| {
        Ok(shaded(card, cloud, (Texels::once(cloud, texels)?, Texels::once(cloud, texels)?)))
    })
}

/// With Henyey and Greenstein's function of the cloud's g.
pub(crate) fn hg() -> Simple {
    let source = "Chandrasekhar 1950, Radiative Transfer, section 45.3; Henyey & Greenstein 1941, eq. 2";
    let card = card("single-hg", "Single scattering, Henyey–Greenstein", source, 0);
    Simple::new(card, |card, cloud| {
        let g = cloud.asymmetry();
        Ok::<_, MethodError>(shaded(card, cloud, (Hg { g }, Hg { g: g as f32 })))
    })
}

/// With the Henyey–Greenstein and Draine blend of the droplet diameter that is nearest to the cloud's phase function. The fit is for
/// diameters from 5 to 50 µm.
pub(crate) fn hg_draine() -> Simple {
    let source = "Chandrasekhar 1950, Radiative Transfer, section 45.3; Jendersie & d'Eon 2023, An Approximate Mie Scattering Function for Fog \
                  and Cloud Rendering";
    let card = card("single-hg-draine", "Single scattering, Henyey–Greenstein and Draine", source, 0);
    let card = Card { domain: Domain { r_eff_um: Range::closed(2.5, 25.0), ..card.domain }, ..card };
    Simple::new(card, |card, cloud| {
        let blend = jendersie_deon(nearest_diameter(cloud.phase(), Objective::Scattered)?)?;
        Ok(shaded(card, cloud, (HgDraine::new(&blend), HgDraine::new(&blend))))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Chandrasekhar's closed forms with P = 1, where they lose no digits; equal cosines are their limit τ/(4μ²) e^(-τ/μ).
    #[test]
    fn the_factor_is_chandrasekhars() {
        let (tau, mu_l, mu_v) = (0.8, 0.7, 0.4);
        let of = |mu_v: f64, side| once(tau, &Sight::new(mu_l, mu_v, 30.0, side).unwrap(), 1.0);
        let top = (1.0 - libm::exp(-tau / mu_l - tau / mu_v)) / (4.0 * (mu_l + mu_v));
        let bottom = (libm::exp(-tau / mu_l) - libm::exp(-tau / mu_v)) / (4.0 * (mu_l - mu_v));
        let equal = tau / (4.0 * mu_l * mu_l) * libm::exp(-tau / mu_l);
        assert!((of(mu_v, Side::Top) / top - 1.0).abs() < 1e-14);
        assert!((of(mu_v, Side::Bottom) / bottom - 1.0).abs() < 1e-14);
        assert!((of(mu_l, Side::Bottom) / equal - 1.0).abs() < 1e-14);
        assert!((of(mu_l * (1.0 + 1e-9), Side::Bottom) / equal - 1.0).abs() < 1e-8);
    }
}
