//! Multiple forward scattering: the sun's beam keeps what is scattered into a small cone around it; one scattering more leads to the eye.
//!
//! M. J. Harris, A. Lastra, *Real-time cloud rendering* (Eurographics 2001), section 3: with I_k the light that reaches slice k along
//! the sun's direction, I_k = T_{k-1} I_{k-1} + a τ p(l,-l) I_{k-1} γ/4π, T = e^{-τ}, and first-order scattering a τ p(ω,-l) I_k/4π towards
//! the eye. In a homogeneous slab with slices ever thinner:
//!
//! ```text
//! I(t) = e^-(1-η)t/μ_l     η = ω p(0) γ/4π
//! ```
//!
//! so that the radiance is `single_scattering` with the sun's extinction times 1-η. `harris-lastra` is as published: Rayleigh's phase
//! function, p(0) = 3/2, and the cone of the authors' program SkyWorks (`SkyCloud::Illuminate`), γ = 0.09 sr. `multiple-forward` has
//! Henyey and Greenstein's function of the cloud's g, and instead of p(0) γ/4π the share that it sends into that cone. Hufnagel &
//! Held's class: single scattering (4.1.1, forward orders). No fluxes.

use super::single_scattering::once;
use crate::lobe::{Hg, Lobe, Rayleigh};
use crate::scalar::Scalar;
use crate::shade::{InSingle, Shade, Shaded};
use crate::simple::Simple;
use crate::{Card, Class, Cloud, Domain, Promises, Ready};
use std::f64::consts::PI;
use stratiform_model::angular::Sight;
use stratiform_optics::phase::{HenyeyGreenstein, PhaseFunction};
use stratiform_quantities::Asymmetry;

/// γ of SkyWorks, sr.
const SOLID_ANGLE: f64 = 0.09;

struct MultipleForward<F, P> {
    omega: F,
    /// 1 - η.
    dimming: F,
    phase: P,
}

impl<F: Scalar, P: Lobe<F>> Shade<F> for MultipleForward<F, P> {
    fn radiance(&self, tau: F, sight: &Sight<F>) -> F {
        self.omega * self.phase.at(sight.v) * once(tau, sight, self.dimming)
    }

    fn fluxes(&self, _tau: F, _mu_l: F) -> (F, F) {
        (F::of(0.0), F::of(0.0))
    }
}

fn shaded<D: Lobe<f64> + 'static, S: Lobe<f32> + 'static>(
    card: &Card,
    cloud: &Cloud,
    share: f64,
    (double, single): (D, S),
) -> Box<dyn Ready> {
    let omega = cloud.omega().get();
    let dimming = 1.0 - omega * share;
    Box::new(Shaded {
        card: card.clone(),
        double: MultipleForward { omega, dimming, phase: double },
        single: InSingle(MultipleForward { omega: omega as f32, dimming: dimming as f32, phase: single }),
    })
}

fn card(name: &str, title: &'static str) -> Card {
    Card {
        name: name.to_owned(),
        title,
        source: "Harris & Lastra 2001, Real-time cloud rendering, section 3; SkyWorks, SkyCloud.cpp",
        class: Class::SingleScattering,
        domain: Domain::EVERYWHERE,
        promises: Promises::default(),
        radiance: true,
        flux: false,
        table_bytes: Some(0),
    }
}

/// As published.
pub(crate) fn published() -> Simple {
    Simple::new(card("harris-lastra", "Multiple forward scattering, as published"), |card, cloud| {
        Ok(shaded(card, cloud, 1.5 * SOLID_ANGLE / (4.0 * PI), (Rayleigh, Rayleigh)))
    })
}

/// With a cloud's phase function.
pub(crate) fn of_cloud() -> Simple {
    let card = card("multiple-forward", "Multiple forward scattering, Henyey–Greenstein");
    Simple::new(card, |card, cloud| {
        let g = cloud.asymmetry();
        let share = HenyeyGreenstein::new(Asymmetry::new(g)?).cumulative(SOLID_ANGLE / (2.0 * PI));
        Ok(shaded(card, cloud, share, (Hg { g }, Hg { g: g as f32 })))
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use stratiform_quantities::Side;

    /// The paper's recursion over 20 000 slices, light and eye, against the closed form.
    #[test]
    fn thin_slices_give_the_closed_form() {
        let (tau, slices) = (3.0, 20_000);
        let sight = Sight::new(0.6, 0.4, 120.0, Side::Top).unwrap();
        let eta = 1.5 * SOLID_ANGLE / (4.0 * PI);
        let (step, mut light, mut seen, mut way_out) = (tau / f64::from(slices), 1.0, 0.0, 1.0);
        for _ in 0..slices {
            let (along, out) = (step / sight.mu_l, step / sight.mu_v);
            seen += out * Rayleigh.at(sight.v) / (4.0 * PI) * light * way_out;
            light = libm::exp(-along) * light + eta * along * light;
            way_out *= libm::exp(-out);
        }
        let shade = MultipleForward { omega: 1.0, dimming: 1.0 - eta, phase: Rayleigh };
        let factor = PI * seen / sight.mu_l;
        assert!((shade.radiance(tau, &sight) / factor - 1.0).abs() < 1e-3);
    }
}
