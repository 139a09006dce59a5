//! The octave approximation: single scattering repeated with less extinction, less weight and a rounder phase function.
//!
//! M. Wrenninge, C. Kulla, V. Lundqvist, *Oz: the great and volumetric* (SIGGRAPH Talks 2013): L = Σ_{i<N} bⁱ σ_s p(Θ, cⁱ g)
//! e^{-aⁱ ∫σ_t} L_sun, a, b, c = ½ as commonly quoted; taken over by S. Hillaire, *Physically Based Sky, Atmosphere and Cloud Rendering in
//! Frostbite* (SIGGRAPH 2016 course), by Unreal (material output with occlusion, contribution and eccentricity, two octaves more than
//! single scattering at most) and Unity (HDRP, VolumetricCloudsUtilities.hlsl: one number for all three, two octaves). Only the sun's path
//! is dimmed by aⁱ: light on its way to the eye meets the true extinction. In a homogeneous slab the march is closed:
//!
//! ```text
//! Σ bⁱ ω HG(cⁱ g, Θ) · single scattering with p = aⁱ τ/μ_l
//! ```
//!
//! The sun's light that reaches a point is a beam, so that each octave is `single_scattering` with its own extinction. Hufnagel &
//! Held's class: heuristic (4.1.7). No fluxes.

use super::single_scattering::once;
use crate::lobe::henyey_greenstein;
use crate::scalar::Scalar;
use crate::shade::{InSingle, Shade, Shaded};
use crate::simple::Simple;
use crate::{Card, Class, Cloud, Domain, Promises};
use stratiform_model::angular::Sight;

/// a, b and c of the sources.
const HALF: f64 = 0.5;

struct Octaves<F> {
    omega: F,
    g: F,
    count: u32,
}

impl<F: Scalar> Octaves<F> {
    fn new(cloud: &Cloud, count: u32) -> Self {
        Self { omega: F::of(cloud.omega().get()), g: F::of(cloud.asymmetry()), count }
    }
}

impl<F: Scalar> Shade<F> for Octaves<F> {
    fn radiance(&self, tau: F, sight: &Sight<F>) -> F {
        let (mut sum, mut share) = (F::of(0.0), F::of(1.0));
        for _ in 0..self.count {
            // aⁱ = bⁱ = cⁱ.
            let phase = henyey_greenstein(share * self.g, sight.v);
            sum = sum + share * phase * once(tau, sight, share);
            share = share * F::of(HALF);
        }
        self.omega * sum
    }

    fn fluxes(&self, _tau: F, _mu_l: F) -> (F, F) {
        (F::of(0.0), F::of(0.0))
    }
}

/// With `count` octaves.
pub(crate) fn method(count: u32) -> Simple {
    let card = Card {
        name: format!("octaves:{count}"),
        title: "Octaves of single scattering",
        source: "Wrenninge, Kulla & Lundqvist 2013, Oz: the great and volumetric; Hillaire 2016; Unity, VolumetricCloudsUtilities.hlsl",
        class: Class::Heuristic,
        domain: Domain::EVERYWHERE,
        promises: Promises::default(),
        radiance: true,
        flux: false,
        table_bytes: Some(0),
    };
    Simple::new(card, move |card, cloud| {
        Ok(Box::new(Shaded {
            card: card.clone(),
            double: Octaves::<f64>::new(cloud, count),
            single: InSingle(Octaves::<f32>::new(cloud, count)),
        }))
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use stratiform_quantities::Side;

    /// An opaque slab with P = 1: octave i is bⁱ/(4(μ_l + aⁱ μ_v)).
    #[test]
    fn octaves_add_up() {
        let shade = Octaves { omega: 1.0, g: 0.0, count: 4 };
        let sight = Sight::new(0.6, 0.9, 10.0, Side::Top).unwrap();
        let octave = |share: f64| share / (4.0 * (0.6 + share * 0.9));
        let expected = octave(1.0) + octave(0.5) + octave(0.25) + octave(0.125);
        assert!((shade.radiance(1e6, &sight) / expected - 1.0).abs() < 1e-12);
    }

    /// Octave 2 alone, by a march: half the extinction towards the sun, half the weight, half of g.
    #[test]
    fn the_closed_form_is_the_march() {
        let sight = Sight::new(0.5, 0.8, 70.0, Side::Bottom).unwrap();
        let of = |count| Octaves { omega: 0.9, g: 0.85, count }.radiance(2.0, &sight);
        let march = (0..20_000).fold(0.0, |sum, i| {
            let t = 2.0 * (f64::from(i) + 0.5) / 20_000.0;
            sum + libm::exp(-0.5 * t / 0.5 - (2.0 - t) / 0.8) * 2.0 / 20_000.0
        });
        let expected = 0.5 * 0.9 * henyey_greenstein(0.425, sight.v) * march / (4.0 * 0.5 * 0.8);
        assert!(((of(2) - of(1)) / expected - 1.0).abs() < 1e-7);
    }
}
