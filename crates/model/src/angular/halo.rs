//! I0: light that met no wide scattering (the paper's section 4.2, corrected).
//!
//! Unscattered light is e^{-τ/μ_v} of what lies behind: transparency, no radiance of the sun but in its own direction. Light
//! that met n ≥ 1 forward events keeps close to the sun's direction. With q the full medium's optical path and y = P_f q:
//!
//! ```text
//! L = F0/4π Σ_{n≥1} e^-q y^n/n! P_F^{*n}        P_F^{*n}: n-fold convolution on the sphere, moments χ_l^n
//! ```
//!
//! (Goudsmit & Saunderson 1940, as Σ(2l+1)(e^{-q(1-P_f χ_l)} - e^-q)P_l). n = 1 comes from P itself, whose edge at θ_f is
//! hard; the rest is smooth and comes from a table of its shape, which the caller has.
//!
//! * **Path.** The sum knows one path, but μ_l ≠ μ_v within the halo: q = τ(1/μ_l + 1/μ_v)/2, and πL/(μ_l F0) = Σ/(2(μ_l+μ_v)).
//!   This is the printed path τ/μ_v at μ_v = μ_l and can be reversed. n = 1 needs no such mean and is exact.
//! * **As printed:** τ_S(H_v) P_F^{*κH_v}, [`Halo::weight_as_printed`]: e^{-q(1-P_f)} counts the unscattered light again, and
//!   κH_v is the number of all events, not of the forward ones (P_f κH_v).

use super::{Angular, PhaseLookup, Sight, path};
use crate::Real;
use crate::brackets::{once_each, rise};
use stratiform_quantities::Side;

/// The shape of the light that met two or more forward events.
pub trait HaloLookup<F> {
    /// Distribution over the sphere at v = 1 - cosΘ, mean 1, after a path of optical thickness `q` of the full medium:
    /// Σ_{n≥2} y^n/n! P_F^{*n}/(e^y - 1 - y).
    fn several(&self, v: F, q: F) -> F;
}

impl<F, T: Fn(F, F) -> F> HaloLookup<F> for T {
    fn several(&self, v: F, q: F) -> F {
        self(v, q)
    }
}

/// The forward peak of a medium.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Peak<F> {
    /// P_f.
    pub forward_fraction: F,
    /// 1 - cosθ_f.
    pub edge: F,
}

/// The halo of one slab along one line, as reflectance factors; dark on the lit face.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Halo<F> {
    tau: F,
    sight: Sight<F>,
    peak: Peak<F>,
}

impl<F: Real> Halo<F> {
    /// `slab` gives the line of sight; `tau` is the optical thickness of the full medium.
    pub fn new(slab: &Angular<F>, tau: F, peak: Peak<F>) -> Self {
        Self { tau, sight: slab.sight, peak }
    }

    /// Light that met one forward event: P/4 with the full medium's path, exact.
    pub fn once(&self, phase: &impl PhaseLookup<F>) -> F {
        if self.dark() || self.sight.v >= self.peak.edge {
            return F::of(0.0);
        }
        F::of(0.25) * phase.full(self.sight.v) * path::weights(self.tau, &self.sight).0
    }

    /// Light that met two or more.
    pub fn several(&self, shape: &impl HaloLookup<F>) -> F {
        if self.dark() {
            return F::of(0.0);
        }
        let q = self.path();
        let weight = weight_of_several(q, self.peak.forward_fraction);
        F::of(0.5) * weight * shape.several(self.sight.v, q) / (self.sight.mu_l + self.sight.mu_v)
    }

    /// Both.
    pub fn total(&self, phase: &impl PhaseLookup<F>, shape: &impl HaloLookup<F>) -> F {
        self.once(phase) + self.several(shape)
    }

    /// The share e^{-q(1-P_f)} that the printed form gives to P_F^{*q}, with q = τ/μ_v.
    pub fn weight_as_printed(&self) -> F {
        let kept = F::of(1.0) - self.peak.forward_fraction;
        (-(kept * path::slant(self.tau, self.sight.mu_v))).exp()
    }

    /// Mean optical path.
    fn path(&self) -> F {
        let (mu_l, mu_v) = (self.sight.mu_l, self.sight.mu_v);
        F::of(0.5) * (path::slant(self.tau, mu_l) + path::slant(self.tau, mu_v))
    }

    fn dark(&self) -> bool {
        let light = self.sight.side == Side::Bottom && self.tau > F::of(0.0);
        !light
    }
}

/// e^{-τ/μ_v}: how much of what lies behind is seen; 0 at μ_v = 0.
pub fn transparency<F: Real>(tau: F, mu_v: F) -> F {
    (-path::slant(tau, mu_v)).exp()
}

/// α = 1 - e^{-τ/μ_v}, for blending; keeps its digits in thin slabs.
pub fn opacity<F: Real>(tau: F, mu_v: F) -> F {
    rise(path::slant(tau, mu_v))
}

/// Share of a beam that met two or more events, all forward, after a path q: e^{-q}(e^y - 1 - y), y = P_f q.
pub fn weight_of_several<F: Real>(q: F, forward_fraction: F) -> F {
    let y = forward_fraction * q;
    (y - q).exp() * once_each(y)
}

#[cfg(test)]
mod tests {
    use super::*;

    struct Flat;

    impl PhaseLookup<f64> for Flat {
        fn full(&self, _: f64) -> f64 {
            100.0
        }

        fn wide(&self, _: f64) -> f64 {
            0.0
        }

        fn wide_squared(&self, _: f64) -> f64 {
            0.0
        }
    }

    fn halo(tau: f64, mu_l: f64, mu_v: f64, v: f64, side: Side) -> Halo<f64> {
        let slab = Angular::new(tau, Sight { mu_l, mu_v, v, side }).unwrap();
        Halo::new(&slab, tau, Peak { forward_fraction: 0.45, edge: 0.004 })
    }

    /// Straight ahead n = 1 is the Poisson term e^{-q} q P_f P_F/(4μ), and ends at θ_f.
    #[test]
    fn one_event_is_the_poisson_term_up_to_the_edge() {
        for (tau, mu) in [(1e-6, 1.0), (0.5, 0.5), (20.0, 0.3)] {
            let q: f64 = tau / mu;
            let expected = libm::exp(-q) * q * 100.0 / (4.0 * mu);
            let found = halo(tau, mu, mu, 0.001, Side::Bottom).once(&Flat);
            assert!((found / expected - 1.0).abs() < 1e-14, "{tau} {mu}");
            assert_eq!(halo(tau, mu, mu, 0.004, Side::Bottom).once(&Flat), 0.0);
            assert_eq!(halo(tau, mu, mu, 0.001, Side::Top).total(&Flat, &|_, _| 1.0), 0.0);
        }
    }

    /// Unscattered, once and several times: the Poisson distribution of forward events.
    #[test]
    fn shares_add_up_to_the_modified_mediums_transmission() {
        for q in [1e-8, 1e-3, 0.5, 2.0, 30.0, 1e4] {
            let (none, one) = (libm::exp(-q), 0.45 * q * libm::exp(-q));
            let all = libm::exp(-0.55 * q);
            let several = weight_of_several(q, 0.45);
            assert!((none + one + several - all).abs() <= 1e-15, "{q}");
            assert!(several >= 0.0);
        }
        let thin = weight_of_several(1e-8_f32, 0.45);
        assert!((thin / (0.5 * 0.45e-8 * 0.45e-8) - 1.0).abs() < 1e-6);
        assert!(weight_of_several(1e4_f32, 0.45) == 0.0);
    }

    #[test]
    fn the_printed_weight_counts_unscattered_light_again() {
        let halo = halo(2.0, 0.5, 0.5, 0.001, Side::Bottom);
        let honest = libm::exp(-4.0) * 0.45 * 4.0 + weight_of_several(4.0, 0.45);
        assert!((halo.weight_as_printed() - honest - transparency(2.0, 0.5)).abs() < 1e-15);
        assert!((opacity(1e-9_f32, 0.5) / 2e-9 - 1.0).abs() < 1e-6);
        assert_eq!((transparency(1.0, 0.0), opacity(1.0, 0.0)), (0.0, 1.0));
    }

    #[test]
    fn nothing_is_negative_or_not_a_number() {
        for (mu_l, mu_v) in [(0.0, 1e-4), (1e-4, 1e-4), (1.0, 0.3), (0.3, 0.31)] {
            for tau in [0.0, 1e-8, 1.0, 1e4] {
                let halo = halo(tau, mu_l, mu_v, 0.001, Side::Bottom);
                let total = halo.total(&Flat, &|_, _| 300.0);
                assert!(total >= 0.0 && total.is_finite(), "{total} {mu_l} {mu_v} {tau}");
            }
        }
    }
}
