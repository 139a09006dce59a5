//! Both tracers against what is known exactly.

mod common;

use common::{
    Family, beam, exact, full, half_space, hg, isotropic, modified, plain, reflectance, request,
    transmittance,
};
use std::f64::consts::PI;
use stratiform_optics::phase::PhaseFunction;
use stratiform_quantities::{Incidence, Order};
use stratiform_stats::Estimate;
use stratiform_transport::{Quantity, TraceMedium, Traced};

const ALPHA: f64 = 1e-3;
const TAU: [f64; 4] = [2.0, 0.0, 0.3, 8.0];
const MU0: [f64; 4] = [1.0, 0.6, 0.15, 0.0];

fn both(medium: &TraceMedium, tau: &[f64], incidence: Incidence, photons: u64) -> [Traced; 2] {
    let request = request(tau, incidence, photons);
    [half_space(medium, &request), plain(medium, &request)]
}

#[test]
fn nothing_is_lost_in_a_lossless_slab() {
    for traced in both(&full(hg(0.85), 1.0), &TAU, beam(0.6), 5_000) {
        for i in 0..TAU.len() {
            let hits = |quantity| traced.hits(i, quantity);
            let out = hits(Quantity::Reflectance(Order::Total)) + hits(Quantity::Transmittance(Order::Total));
            assert_eq!(out, 5_000);
            assert_eq!(traced.absorbed_hits(i), 0);
        }
    }
}

#[test]
fn no_slab_lets_everything_through_unscattered() {
    for incidence in [beam(1.0), beam(0.0), Incidence::Diffuse] {
        for traced in both(&full(hg(0.85), 0.5), &[0.0], incidence, 1_000) {
            assert_eq!(traced.hits(0, Quantity::Transmittance(Order::Exactly(0))), 1_000);
            assert_eq!(traced.mean_scatterings(0), exact(0.0));
        }
    }
}

/// e^{-τ/μ0}, in the modified medium e^{-(1-ωP_f)τ/μ0}, and in diffuse light ∫2μ e^{-τ/μ} dμ. False alarms: one seed
/// in 1000.
#[test]
fn unscattered_light_is_exponential() {
    let mut family = Family::default();
    let (omega, forward) = (0.9, 0.45);
    let media = [(full(hg(0.5), omega), 1.0), (modified(hg(0.5), omega, forward), 1.0 - omega * forward)];
    for (medium, extinction) in &media {
        for mu0 in MU0 {
            for traced in both(medium, &TAU, beam(mu0), 20_000) {
                for (i, tau) in TAU.iter().enumerate() {
                    let transmitted = if *tau == 0.0 { 1.0 } else { libm::exp(-extinction * tau / mu0) };
                    let got = transmittance(&traced, i, Order::Exactly(0));
                    family.compare(format!("mu0 {mu0} tau {tau}"), got, exact(transmitted));
                }
            }
        }
        for traced in both(medium, &TAU, Incidence::Diffuse, 20_000) {
            for (i, tau) in TAU.iter().enumerate() {
                let diffuse = midpoint(4000, |mu| 2.0 * mu * libm::exp(-extinction * tau / mu));
                let got = transmittance(&traced, i, Order::Exactly(0));
                family.compare(format!("diffuse tau {tau}"), got, exact(diffuse));
            }
        }
    }
    family.assert(ALPHA);
}

/// ∫₀¹ f.
fn midpoint(points: u32, f: impl Fn(f64) -> f64) -> f64 {
    (0..points).fold(0.0, |sum, k| sum + f((f64::from(k) + 0.5) / f64::from(points))) / f64::from(points)
}

/// Mean of P over the azimuth between directions of cosines `mu` and `mu0`.
fn azimuthal_mean(phase: &dyn PhaseFunction, mu: f64, mu0: f64) -> f64 {
    let sines = ((1.0 - mu * mu) * (1.0 - mu0 * mu0)).sqrt();
    midpoint(100, |half_turn| phase.value(1.0 - mu * mu0 - sines * libm::cos(PI * half_turn)))
}

/// R_1 and T_1 by quadrature over the exit cosine μ. A photon collides at depth s with density e^{-s/μ0}/μ0, turns
/// to μ with density ω p̄/2, and leaves with probability e^{-s/μ} or e^{-(τ-s)/μ}.
fn first_order(phase: &dyn PhaseFunction, omega: f64, tau: f64, mu0: f64) -> (f64, f64) {
    let exp = |optical_path: f64| libm::exp(-optical_path);
    let reflected = |mu: f64| {
        let share = if mu0 == 0.0 { 1.0 } else { mu / (mu + mu0) * (1.0 - exp(tau / mu + tau / mu0)) };
        0.5 * omega * azimuthal_mean(phase, -mu, mu0) * share
    };
    let transmitted = |mu: f64| {
        let share = if mu0 == 0.0 {
            exp(tau / mu)
        } else if (mu - mu0).abs() < 1e-9 {
            tau / mu0 * exp(tau / mu0)
        } else {
            mu / (mu - mu0) * (exp(tau / mu) - exp(tau / mu0))
        };
        0.5 * omega * azimuthal_mean(phase, mu, mu0) * share
    };
    (midpoint(2000, reflected), midpoint(2000, transmitted))
}

/// False alarms: one seed in 1000.
#[test]
fn single_scattering_is_its_quadrature() {
    let mut family = Family::default();
    for (phase, omega) in [(isotropic(), 1.0), (hg(0.75), 0.9), (hg(-0.3), 1.0)] {
        let medium = full(phase.clone(), omega);
        for mu0 in MU0 {
            for traced in both(&medium, &TAU, beam(mu0), 20_000) {
                for (i, &tau) in TAU.iter().enumerate().filter(|(_, tau)| **tau > 0.0) {
                    let (r, t) = first_order(phase.as_ref(), omega, tau, mu0);
                    let order = Order::Exactly(1);
                    let name = format!("g {} mu0 {mu0} tau {tau}", phase.asymmetry());
                    family.compare(format!("{name} R_1"), reflectance(&traced, i, order), exact(r));
                    family.compare(format!("{name} T_1"), transmittance(&traced, i, order), exact(t));
                }
            }
        }
    }
    family.assert(ALPHA);
}

/// At grazing incidence the first collision is at the surface, and half of what it scatters leaves. False
/// alarms: one seed in 1000.
#[test]
fn half_of_grazing_light_is_reflected_at_once() {
    let mut family = Family::default();
    for phase in [isotropic(), hg(0.85)] {
        for traced in both(&full(phase, 1.0), &[1e-3, 1.0, 30.0], beam(0.0), 10_000) {
            for i in 0..3 {
                family.compare("R_1", reflectance(&traced, i, Order::Exactly(1)), exact(0.5));
                assert_eq!(transmittance(&traced, i, Order::Exactly(0)).value, 0.0);
            }
        }
    }
    family.assert(ALPHA);
}

/// Diffuse light scatters 2τ times on average in a lossless slab, whatever the phase function. False alarms:
/// one seed in 1000.
#[test]
fn diffuse_light_scatters_twice_the_optical_thickness() {
    let mut family = Family::default();
    let forward = 0.45;
    let media = [
        (full(isotropic(), 1.0), 1.0),
        (full(hg(0.85), 1.0), 1.0),
        (modified(hg(0.7), 1.0, forward), 1.0 - forward),
    ];
    for (medium, extinction) in &media {
        for traced in both(medium, &TAU, Incidence::Diffuse, 20_000) {
            for (i, tau) in TAU.iter().enumerate() {
                let expected = exact(2.0 * extinction * tau);
                family.compare(format!("tau {tau}"), traced.mean_scatterings(i), expected);
            }
        }
    }
    family.assert(ALPHA);
}

/// The comparison of mean scatterings rejects 2τ wrong by 3 %.
#[test]
fn a_planted_mean_is_rejected() {
    let request = request(&[8.0], Incidence::Diffuse, 500_000);
    let traced = half_space(&full(isotropic(), 1.0), &request);
    let mut family = Family::default();
    let off = Estimate { value: 16.0 * 1.03, std_error: 0.0 };
    family.compare("scatterings", traced.mean_scatterings(0), off);
    assert!(!family.accepts(ALPHA));
}
