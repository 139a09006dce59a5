//! Two-stream approximations: quadrature two-stream, δ-Eddington, diffusion.
//!
//! W. E. Meador, W. R. Weaver, *Two-stream approximations to radiative transfer in planetary atmospheres* (J. Atmos. Sci. 37, 1980), table 1
//! has γ1…γ4; forward peaks are scaled as by Joseph, Wiscombe & Weinman 1976: f = g², τ' = (1-ωf)τ, ω' = ω(1-f)/(1-ωf), g' = g/(1+g).
//!
//! | method | γ1 + γ2 | γ1 - γ2 | γ3 | radiance per flux of its face |
//! | --- | --- | --- | --- | --- |
//! | two-stream (quadrature) | √3(1-ωg) | √3(1-ω) | (1-√3gμ_l)/2 | Lambertian: 1 |
//! | δ-Eddington | 3/2(1-ωg) | 2(1-ω) | (2-3gμ_l)/4 | Eddington's at the face: (2+3μ_v)/4 |
//! | diffusion (Stam 1995; σ_s' = (1-g)σ_s, g' = 0) | 3/2 | 2(1-ω) | 1/2 | the same |
//!
//! Meador & Weaver's eqs. 14 and 15 divide by 1 - k²μ_l², which may vanish. Here R and T are integrals of the beam's source with the
//! slab's Green function, with a = 1/μ_l, k² = γ1²-γ2², S = sinh(kt)/k, C = cosh(kt):
//!
//! ```text
//! R = ω a ∫ e^-at [γ3 (C + γ1 S)(τ-t) + γ4 γ2 S(τ-t)] dt / (C + γ1 S)(τ)
//! T = e^-aτ + ω a ∫ e^-at [γ4 (C + γ1 S)(t) + γ3 γ2 S(t)] dt / (C + γ1 S)(τ)
//! ```
//!
//! all terms positive, scaled by e^{-kτ}, in divided differences of e^x: nothing cancels, k = 0 and k = a are ordinary. The radiance
//! below leaves out the scaled beam e^{-aτ'}, peak included. Domain: γ2 ≥ 0, hence ω from 0.8 (quadrature: any); g ∈ [0, 1).
//! Hufnagel & Held's class: diffusion (4.1.2).

use crate::promise::region;
use crate::scalar::{Scalar, mean_decay, second_mean};
use crate::shade::{InSingle, Shade, Shaded};
use crate::simple::Simple;
use crate::{Card, Class, Cloud, Domain, MethodError, Promise, Promises};
use stratiform_model::angular::Sight;
use stratiform_quantities::{Range, Side};

/// Which closure.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Closure {
    Quadrature,
    DeltaEddington,
    Diffusion,
}

/// A closure for one medium.
struct TwoStream<F> {
    closure: Closure,
    /// τ' per τ.
    extinction: F,
    omega: F,
    g: F,
    gamma1: F,
    gamma2: F,
    k: F,
}

impl<F: Scalar> TwoStream<F> {
    fn new(closure: Closure, omega: f64, g: f64) -> Self {
        // Diffusion counts the share g of events as none, the others g².
        let (forward, g_scaled) =
            if closure == Closure::Diffusion { (g, 0.0) } else { (g * g, g / (1.0 + g)) };
        let extinction = 1.0 - omega * forward;
        let omega = (omega * (1.0 - forward) / extinction).min(1.0);
        let (sum, difference) = match closure {
            Closure::Quadrature => {
                (3.0_f64.sqrt() * (1.0 - omega * g_scaled), 3.0_f64.sqrt() * (1.0 - omega))
            }
            Closure::DeltaEddington | Closure::Diffusion => {
                (1.5 * (1.0 - omega * g_scaled), 2.0 * (1.0 - omega))
            }
        };
        let of = F::of;
        Self {
            closure,
            extinction: of(extinction),
            omega: of(omega),
            g: of(g_scaled),
            gamma1: of(0.5 * (sum + difference)),
            gamma2: of(0.5 * (sum - difference)),
            k: of((sum * difference).sqrt()),
        }
    }

    /// γ3, the share of the beam's first scattering that goes up.
    fn upward(&self, mu_l: F) -> F {
        match self.closure {
            Closure::Quadrature => F::of(0.5) - F::of(0.75_f64.sqrt()) * self.g * mu_l,
            Closure::DeltaEddington | Closure::Diffusion => F::of(0.5) - F::of(0.75) * self.g * mu_l,
        }
    }

    /// R, and T without the beam.
    fn diffuse(&self, tau: F, mu_l: F) -> (F, F) {
        let (half, two) = (F::of(0.5), F::of(2.0));
        let (k, a, t) = (self.k, F::of(1.0) / mu_l, self.extinction * tau);
        let (up, down) = (self.upward(mu_l), F::of(1.0) - self.upward(mu_l));
        let decay = (-(k * t)).exp();
        // The slab's own C + γ1 S.
        let slab = half + half * decay * decay + self.gamma1 * t * mean_decay(two * k * t);
        // ∫ e^-at {S, C}(τ-t) dt.
        let sines_up = t * second_mean((a + k) * t, two * k * t);
        let both =
            if a < k { (-(a * t)).exp() * mean_decay((k - a) * t) } else { decay * mean_decay((a - k) * t) };
        let cosines_up = decay * both + k * sines_up;
        // ∫ e^-at {S, C}(t) dt.
        let sines_down = if a < k {
            (-(a * t)).exp() * second_mean((k - a) * t, two * k * t)
        } else {
            decay * second_mean((a - k) * t, (a + k) * t)
        };
        let cosines_down = half * (both + decay * mean_decay((a + k) * t));
        let source = self.omega * (a * t) / slab;
        let up_out = up * (cosines_up + self.gamma1 * sines_up) + down * self.gamma2 * sines_up;
        let (sines_down, gamma2) = (t * sines_down, self.gamma2);
        let down_out = down * (cosines_down + self.gamma1 * sines_down) + up * gamma2 * sines_down;
        (source * up_out, source * down_out)
    }
}

impl<F: Scalar> Shade<F> for TwoStream<F> {
    fn radiance(&self, tau: F, sight: &Sight<F>) -> F {
        let (up, down) = self.diffuse(tau, sight.mu_l);
        let flux = if sight.side == Side::Top { up } else { down };
        match self.closure {
            Closure::Quadrature => flux,
            Closure::DeltaEddington | Closure::Diffusion => flux * (F::of(0.5) + F::of(0.75) * sight.mu_v),
        }
    }

    fn fluxes(&self, tau: F, mu_l: F) -> (F, F) {
        let (up, down) = self.diffuse(tau, mu_l);
        (up, down + (-(self.extinction * tau / mu_l)).exp())
    }
}

fn card(closure: Closure) -> Card {
    let (name, title, source) = match closure {
        Closure::Quadrature => (
            "two-stream",
            "Two streams",
            "Meador & Weaver 1980, table 1 (quadrature), scaled as by Joseph et al. 1976",
        ),
        Closure::DeltaEddington => (
            "delta-eddington",
            "δ-Eddington",
            "Joseph, Wiscombe & Weinman 1976; Meador & Weaver 1980, table 1",
        ),
        Closure::Diffusion => (
            "diffusion",
            "Diffusion",
            "Stam 1995, Multiple scattering as a diffusion process; reduced extinction",
        ),
    };
    let bound = if closure == Closure::Diffusion { 0.2 } else { 0.1 };
    let lowest = if closure == Closure::Quadrature { 0.0 } else { 0.8 };
    Card {
        name: name.to_owned(),
        title,
        source,
        class: Class::Diffusion,
        domain: Domain { omega: Range::closed(lowest, 1.0), ..Domain::EVERYWHERE },
        promises: Promises { radiance: None, flux: Some(Promise::absolute(bound, region([0.0, 1e6], 0.2))) },
        radiance: true,
        flux: true,
        table_bytes: Some(0),
    }
}

/// The method of one closure.
pub(crate) fn method(closure: Closure) -> Simple {
    Simple::new(card(closure), move |card, cloud: &Cloud| {
        let g = Range { max_included: false, ..Range::closed(0.0, 1.0) }.check("g", cloud.asymmetry())?;
        let omega = cloud.omega().get();
        Ok::<_, MethodError>(Box::new(Shaded {
            card: card.clone(),
            double: TwoStream::<f64>::new(closure, omega, g),
            single: InSingle(TwoStream::<f32>::new(closure, omega, g)),
        }))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    const CLOSURES: [Closure; 3] = [Closure::Quadrature, Closure::DeltaEddington, Closure::Diffusion];

    /// Meador & Weaver's eq. 24, lossless: R = (γ1 τ + (γ3 - γ1 μ)(1 - e^(-τ/μ)))/(1 + γ1 τ), T = 1 - R.
    #[test]
    fn lossless_slabs_are_meador_and_weavers() {
        for closure in CLOSURES {
            let slab = TwoStream::<f64>::new(closure, 1.0, 0.85);
            for (tau, mu) in [(0.3, 0.9), (10.0, 0.5), (100.0, 1.0)] {
                let t = slab.extinction * tau;
                let rise = 1.0 - libm::exp(-t / mu);
                let r =
                    (slab.gamma1 * t + (slab.upward(mu) - slab.gamma1 * mu) * rise) / (1.0 + slab.gamma1 * t);
                let (found, through) = slab.fluxes(tau, mu);
                assert!((found / r - 1.0).abs() < 1e-12, "{closure:?} {tau} {mu}: {found} {r}");
                assert!((found + through - 1.0).abs() < 1e-13);
            }
        }
    }

    /// Their eqs. 14 and 15 where these divide by nothing small.
    #[test]
    fn absorbing_slabs_are_meador_and_weavers() {
        for closure in CLOSURES {
            let slab = TwoStream::<f64>::new(closure, 0.9, 0.85);
            for (tau, mu) in [(1.0, 0.9), (10.0, 0.4)] {
                let (t, k, w) = (slab.extinction * tau, slab.k, slab.omega);
                let (g1, g2, g3) = (slab.gamma1, slab.gamma2, slab.upward(mu));
                let g4 = 1.0 - g3;
                let (a1, a2) = (g1 * g4 + g2 * g3, g1 * g3 + g2 * g4);
                let (up, down) = (libm::exp(k * t), libm::exp(-k * t));
                let whole = (1.0 - k * k * mu * mu) * ((k + g1) * up + (k - g1) * down);
                let beam = libm::exp(-t / mu);
                let r = w / whole
                    * ((1.0 - k * mu) * (a2 + k * g3) * up
                        - (1.0 + k * mu) * (a2 - k * g3) * down
                        - 2.0 * k * (g3 - a2 * mu) * beam);
                let through = beam
                    * (1.0
                        - w / whole
                            * ((1.0 + k * mu) * (a1 + k * g4) * up
                                - (1.0 - k * mu) * (a1 - k * g4) * down
                                - 2.0 * k * (g4 + a1 * mu) / beam));
                let (found_r, found_t) = slab.fluxes(tau, mu);
                assert!((found_r / r - 1.0).abs() < 1e-9, "{closure:?} R {found_r} {r}");
                assert!((found_t / through - 1.0).abs() < 1e-9, "{closure:?} T {found_t} {through}");
            }
        }
    }

    /// Where eq. 14 has a pole, k μ = 1, values pass smoothly.
    #[test]
    fn the_pole_is_none() {
        let slab = TwoStream::<f64>::new(Closure::Quadrature, 0.5, 0.85);
        let mu = 1.0 / slab.k;
        assert!(mu < 1.0);
        let [before, at, after] = [mu - 1e-6, mu, mu + 1e-6].map(|mu| slab.fluxes(3.0, mu));
        assert!((0.5 * (before.0 + after.0) / at.0 - 1.0).abs() < 1e-9);
        assert!((0.5 * (before.1 + after.1) / at.1 - 1.0).abs() < 1e-9);
    }
}
