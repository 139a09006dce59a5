//! The octave approximation: single scattering repeated with less extinction, less weight and a rounder phase function.
//!
//! M. Wrenninge, C. Kulla, V. Lundqvist, *Oz: the great and volumetric* (SIGGRAPH Talks 2013): L = Σ_{i<N} bⁱ σ_s p(Θ, cⁱ g)
//! e^{-aⁱ ∫σ_t} L_sun with a = b = c = ½; taken over by S. Hillaire, *Physically Based Sky, Atmosphere and Cloud Rendering in
//! Frostbite* (SIGGRAPH 2016 course), and by Unreal's volumetric cloud, whose defaults are ½ for all three. Only the sun's path
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
use crate::{Card, Class, Cloud, Domain};
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
        source: "Wrenninge, Kulla & Lundqvist 2013, Oz: the great and volumetric; Hillaire 2016; Unreal's volumetric cloud",
        class: Class::Heuristic,
        domain: Domain::EVERYWHERE,
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
