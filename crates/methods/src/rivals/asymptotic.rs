//! Thick lossless slabs in closed form.
//!
//! Van de Hulst 1980; A. A. Kokhanovsky, *Cloud optics* (2006): with K(μ) = (3/7)(1+2μ) and t = 1/(¾(1-g)τ + 1.07) (`stratiform_model::asymptotic`)
//!
//! ```text
//! R = 1 - t K(μ_l)      top      R_∞(μ_l, μ_v, φ) - t K(μ_l) K(μ_v)
//! T = t K(μ_l)          bottom   t K(μ_l) K(μ_v)
//! ```
//!
//! R_∞ is the reflection of the half-space, R_∞ = (A + B(μ_l+μ_v) + Cμ_lμ_v + P(Θ))/(4(μ_l+μ_v)) with the cloud's P (Kokhanovsky's
//! A = 3.944, B = -2.5, C = 10.664 for water droplets). Domain: ω = 1, τ from 10, g ≤ 0.9; both μ from 0.3: at 0.1 R_∞ reflects 24 % more than all light.
//! Hufnagel & Held's class: diffusion (4.1.2).

use crate::lobe::Lobe;
use crate::lookup::{EMITTED_TEXELS, Exact, Texels};
use crate::promise::region;
use crate::scalar::Scalar;
use crate::shade::{InSingle, Shade, Shaded};
use crate::simple::Simple;
use crate::{Card, Class, Domain, Promise, Promises};
use stratiform_model::angular::{Emission, Sight};
use stratiform_model::asymptotic::EXTRAPOLATION;
use stratiform_quantities::{Range, Side};

/// A, B, C.
const HALF_SPACE: [f64; 3] = [3.944, -2.5, 10.664];

struct Asymptotic<F, P> {
    /// 1 - g.
    backward: F,
    phase: P,
}

/// R_∞.
fn half_space<F: Scalar>(mu_l: F, mu_v: F, phase: F) -> F {
    let [a, b, c] = HALF_SPACE.map(F::of);
    let sum = mu_l + mu_v;
    (a + b * sum + c * mu_l * mu_v + phase) / (F::of(4.0) * sum)
}

impl<F: Scalar, P: Lobe<F>> Asymptotic<F, P> {
    /// t K(μ_l).
    fn through(&self, tau: F, mu_l: F) -> F {
        let reduced = F::of(0.75) * self.backward * tau + F::of(EXTRAPOLATION);
        Emission::Escape.factor(mu_l) / reduced
    }
}

impl<F: Scalar, P: Lobe<F>> Shade<F> for Asymptotic<F, P> {
    fn radiance(&self, tau: F, sight: &Sight<F>) -> F {
        let through = self.through(tau, sight.mu_l) * Emission::Escape.factor(sight.mu_v);
        match sight.side {
            Side::Top => half_space(sight.mu_l, sight.mu_v, self.phase.at(sight.v)) - through,
            Side::Bottom => through,
        }
    }

    fn fluxes(&self, tau: F, mu_l: F) -> (F, F) {
        let through = self.through(tau, mu_l);
        (F::of(1.0) - through, through)
    }
}

/// With the cloud's phase function, on texels in single precision.
pub(crate) fn method() -> Simple {
    let card = Card {
        name: "asymptotic".to_owned(),
        title: "Thick-slab asymptotics",
        source: "van de Hulst 1980, Multiple light scattering; Kokhanovsky 2006, Cloud optics",
        class: Class::Diffusion,
        domain: Domain {
            tau: Range::closed(10.0, 1e6),
            mu_l: Range::closed(0.3, 1.0),
            mu_v: Range::closed(0.3, 1.0),
            omega: Range::closed(1.0, 1.0),
            ..Domain::EVERYWHERE
        },
        promises: Promises {
            radiance: Some(Promise::relative(0.3, region([10.0, 1e6], 0.3))),
            flux: Some(Promise::absolute(0.05, region([10.0, 1e6], 0.3))),
        },
        radiance: true,
        flux: true,
        table_bytes: Some(4 * EMITTED_TEXELS),
    };
    Simple::new(card, |card, cloud| {
        let backward = 1.0 - Range::closed(0.0, 0.9).check("g", cloud.asymmetry())?;
        Ok(Box::new(Shaded {
            card: card.clone(),
            double: Asymptotic { backward, phase: Exact::once(cloud) },
            single: InSingle(Asymptotic {
                backward: backward as f32,
                phase: Texels::<f32>::once(cloud, EMITTED_TEXELS)?,
            }),
        }))
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use stratiform_model::asymptotic;
    use stratiform_optics::phase::{HenyeyGreenstein, PhaseFunction};
    use stratiform_quantities::{Asymmetry, CosZenith, Incidence, OpticalThickness};

    /// A lossless half-space reflects everything: 2∫⟨R_∞⟩ μ_v dμ_v = 1. The formula does to 3 % for μ_l ≥ 0.5.
    #[test]
    fn the_half_space_reflects_all_light() {
        let phase = HenyeyGreenstein::new(Asymmetry::new(0.85).unwrap());
        let cells = 60;
        let middle = |i: i32| (f64::from(i) + 0.5) / f64::from(cells);
        for mu_l in [0.5, 0.7, 1.0] {
            let flux = (0..cells * cells).fold(0.0, |sum, i| {
                let (mu_v, phi) = (middle(i % cells), 180.0 * middle(i / cells));
                let sight = Sight::new(mu_l, mu_v, phi, Side::Top).unwrap();
                sum + 2.0 * mu_v * half_space(mu_l, mu_v, phase.value(sight.v)) / f64::from(cells * cells)
            });
            assert!((flux - 1.0).abs() < 0.03, "{mu_l}: {flux}");
        }
    }

    #[test]
    fn transmittance_is_the_models() {
        let shade = Asymptotic { backward: 0.15, phase: crate::lobe::Hg { g: 0.85 } };
        let beam = Incidence::Beam(CosZenith::new(0.4).unwrap());
        let t = asymptotic::t_ms(beam, Asymmetry::new(0.85).unwrap(), OpticalThickness::new(30.0).unwrap());
        assert!((shade.fluxes(30.0, 0.4).1 / t - 1.0).abs() < 1e-14);
    }
}
