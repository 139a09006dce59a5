//! Beer–powder: the sun's light at depth d is 2 e^{-d}(1 - e^{-2d}) instead of e^{-d}.
//!
//! A. Schneider, *The real-time volumetric cloudscapes of Horizon: Zero Dawn* (SIGGRAPH 2015, Advances in real-time rendering): energy = 2 ·
//! Beer · powder · Henyey–Greenstein, Beer = e^{-d}, powder = 1 - e^{-2d}, d the density towards the sun; dimmed along the view. The talk leaves
//! g to the artist; here it is the cloud's. With d = t/μ_l, p = τ/μ_l, q = τ/μ_v and the second divided difference D of e^{-x} the march is closed:
//!
//! ```text
//! ω HG(Θ) p/(4 μ_v) · 4p D(0, p+q, 3p+q)     top;   e^-m D(0, |p-q|, 3p-m or q-p … ) below, m = min(p, q)
//! ```
//!
//! which is 2(single scattering with p) - 2(with 3p) without the cancellation. Hufnagel & Held's class: heuristic (4.1.7). No fluxes.

use crate::lobe::henyey_greenstein;
use crate::scalar::{Scalar, second_mean};
use crate::shade::{InSingle, Shade, Shaded};
use crate::simple::Simple;
use crate::{Card, Class, Cloud, Domain, Promises};
use stratiform_model::angular::Sight;
use stratiform_quantities::Side;

struct BeerPowder<F> {
    omega: F,
    g: F,
}

impl<F: Scalar> BeerPowder<F> {
    fn new(cloud: &Cloud) -> Self {
        Self { omega: F::of(cloud.omega().get()), g: F::of(cloud.asymmetry()) }
    }
}

/// ½∫ (e^-d - e^-3d) · way out dt, per single scattering's τ/(4 μ_l μ_v).
fn powdered<F: Scalar>(p: F, q: F, side: Side) -> F {
    let (two, three) = (F::of(2.0), F::of(3.0));
    let mean = match side {
        Side::Top => second_mean(p + q, three * p + q),
        Side::Bottom if q < p => (-q).exp() * second_mean(p - q, three * p - q),
        Side::Bottom => (-p).exp() * second_mean(q - p, two * p),
    };
    two * p * mean
}

impl<F: Scalar> Shade<F> for BeerPowder<F> {
    fn radiance(&self, tau: F, sight: &Sight<F>) -> F {
        let (p, q) = (tau / sight.mu_l, tau / sight.mu_v);
        let phase = self.omega * henyey_greenstein(self.g, sight.v);
        F::of(0.5) * phase * (p / sight.mu_v) * powdered(p, q, sight.side)
    }

    fn fluxes(&self, _tau: F, _mu_l: F) -> (F, F) {
        (F::of(0.0), F::of(0.0))
    }
}

/// With the cloud's g.
pub(crate) fn method() -> Simple {
    let card = Card {
        name: "beer-powder".to_owned(),
        title: "Beer–powder",
        source: "Schneider 2015, The real-time volumetric cloudscapes of Horizon: Zero Dawn",
        class: Class::Heuristic,
        domain: Domain::EVERYWHERE,
        promises: Promises::default(),
        radiance: true,
        flux: false,
        table_bytes: Some(0),
    };
    Simple::new(card, |card, cloud| {
        Ok(Box::new(Shaded {
            card: card.clone(),
            double: BeerPowder::<f64>::new(cloud),
            single: InSingle(BeerPowder::<f32>::new(cloud)),
        }))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The march of the talk, by midpoints.
    #[test]
    fn the_closed_form_is_the_march() {
        let shade = BeerPowder { omega: 1.0, g: 0.2 };
        for (tau, mu_l, mu_v) in [(0.01, 0.5, 0.9), (2.0, 0.5, 0.9), (2.0, 0.9, 0.2), (2.0, 0.5, 0.5)] {
            for side in Side::BOTH {
                let sight = Sight::new(mu_l, mu_v, 50.0, side).unwrap();
                let steps = 20_000;
                let march = (0..steps).fold(0.0, |sum, i| {
                    let t = tau * (f64::from(i) + 0.5) / f64::from(steps);
                    let d = t / mu_l;
                    let light = 2.0 * libm::exp(-d) * (1.0 - libm::exp(-2.0 * d));
                    let way = if side == Side::Top { t } else { tau - t };
                    sum + light * libm::exp(-way / mu_v) * tau / f64::from(steps) / (4.0 * mu_l * mu_v)
                });
                let value = shade.radiance(tau, &sight) / henyey_greenstein(0.2, sight.v);
                assert!((value / march - 1.0).abs() < 1e-6, "{tau} {side}");
            }
        }
    }

    /// The talk's curve is brightest at d = ½ ln 3, where 2 e^-d (1 - e^-2d) = 4/(3√3).
    #[test]
    fn the_curve_is_the_talks() {
        let d = 0.5 * libm::log(3.0);
        // Light per depth: the derivative of 2 ∫ (e^-d - e^-3d).
        let upto = |d: f64| 2.0 * d * powdered(d, 0.0, Side::Top);
        let slope = (upto(d + 1e-5) - upto(d - 1e-5)) / 2e-5;
        assert!((slope - 4.0 / (3.0 * 3.0_f64.sqrt())).abs() < 1e-9, "{slope}");
    }
}
