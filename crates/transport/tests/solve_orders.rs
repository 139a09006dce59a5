//! The deterministic solver's orders against closed forms, the law R(ω) = ΣR_nωⁿ, and the photon tracer.

#![allow(clippy::unwrap_used, reason = "a test stops where it fails")]

mod common;

use common::{Family, beam, cloud, full, h_function, half_space, hg, isotropic, modified_cloud, request};
use std::f64::consts::PI;
use std::sync::Arc;
use stratiform_optics::phase::{Modified, PhaseFunction};
use stratiform_quantities::{Incidence, Order, SingleScatteringAlbedo};
use stratiform_transport::solve::{SolveMedium, Solved, Solver};
use stratiform_transport::{TraceMedium, TransportError};

fn solver(phase: Arc<dyn PhaseFunction>, omega: f64, tolerance: f64) -> Solver {
    let omega = SingleScatteringAlbedo::new(omega).unwrap();
    Solver::new(SolveMedium::full(phase, omega), tolerance).unwrap()
}

/// The two values of an order.
fn pair(solved: &Solved, i: usize, t: usize, order: Order) -> [f64; 2] {
    let n = solved.orders().iter().position(|listed| *listed == order).unwrap();
    let (r, t) = solved.estimate(i, t, n);
    [r.value, t.value]
}

/// ½∫ f(μ) μ/… dμ over (0, 1) with μ = s², so that grazing directions are well sampled (Simpson).
fn integral(f: impl Fn(f64) -> f64) -> f64 {
    const PANELS: usize = 4000;
    let h = 1.0 / PANELS as f64;
    let sum = (1..=PANELS).fold(0.0, |sum, i| {
        let s = h * i as f64;
        let weight = if i == PANELS { 1.0 } else { [2.0, 4.0][i % 2] };
        sum + weight * 2.0 * s * f(s * s)
    });
    sum * h / 3.0
}

/// P averaged over azimuth between direction cosines `a` and `b` (periodic trapezoid).
fn mean_over_azimuth(phase: &dyn PhaseFunction, a: f64, b: f64) -> f64 {
    const STEPS: u32 = 400;
    let sines = ((1.0 - a * a) * (1.0 - b * b)).sqrt();
    let at =
        |k: u32| phase.value(1.0 - a * b - sines * libm::cos(2.0 * PI * f64::from(k) / f64::from(STEPS)));
    (0..STEPS).fold(0.0, |sum, k| sum + at(k)) / f64::from(STEPS)
}

/// R_1 = ½∫P(-μ,μ0) μ/(μ+μ0) (1 - e^{-τ(1/μ+1/μ0)}) dμ and T_1 = ½∫P(μ,μ0) μ (e^{-τ/μ0} - e^{-τ/μ})/(μ0-μ)
/// dμ.
#[test]
fn first_orders_have_their_closed_forms() {
    for (phase, tolerance) in [(isotropic(), 1e-8), (hg(0.5), 1e-8), (hg(0.75), 1e-8), (hg(0.85), 1e-7)] {
        let solver = solver(phase.clone(), 1.0, tolerance);
        for (mu0, tau) in [(0.2003, 0.3), (0.2003, 4.0), (0.7001, 1.0), (0.999_99, 10.0)] {
            let found = pair(&solver.orders(&[tau], &[beam(mu0)], 1).unwrap(), 0, 0, Order::Exactly(1));
            let reflected = 0.5
                * integral(|mu| {
                    let escape = -libm::expm1(-tau / mu - tau / mu0);
                    mean_over_azimuth(phase.as_ref(), -mu, mu0) * mu / (mu + mu0) * escape
                });
            let transmitted = 0.5
                * integral(|mu| {
                    let difference = tau / mu - tau / mu0;
                    let quotient =
                        if difference.abs() < 1e-9 { 1.0 } else { -libm::expm1(-difference) / difference };
                    mean_over_azimuth(phase.as_ref(), mu, mu0) * tau / mu0 * libm::exp(-tau / mu0) * quotient
                });
            let off = [found[0] - reflected, found[1] - transmitted];
            assert!(off.iter().all(|off| off.abs() < tolerance), "{mu0} {tau}: {off:?}");
        }
    }
}

/// R_1 of the paper's cloud, full and modified, from its table by the same integral; T_0 of diffuse light is 2E_3(τ).
#[test]
fn the_clouds_first_order_has_its_closed_form() {
    let full = SolveMedium::full(cloud(), SingleScatteringAlbedo::CONSERVATIVE);
    let cut = Modified::new(cloud(), 5.0).unwrap();
    let extinction = 1.0 - cut.forward_fraction();
    let cases: [(Arc<dyn PhaseFunction>, SolveMedium, f64); 2] =
        [(cloud(), full, 1.0), (Arc::new(cut), SolveMedium::from(&modified_cloud()), extinction)];
    for (phase, medium, extinction) in cases {
        let (mu0, tau) = (0.5, 5.0);
        let incidence = [beam(mu0), Incidence::Diffuse];
        let solved = Solver::new(medium, 5e-6).unwrap().orders(&[tau], &incidence, 1).unwrap();
        let reflected = 0.5
            * integral(|mu| {
                let escape = -libm::expm1(-extinction * (tau / mu + tau / mu0));
                mean_over_azimuth(phase.as_ref(), -mu, mu0) * mu / (mu + mu0) * escape
            });
        let off = pair(&solved, 0, 0, Order::Exactly(1))[0] - reflected;
        assert!(off.abs() < 5e-6, "{off:e}");
        let unscattered = integral(|mu| 2.0 * mu * libm::exp(-extinction * tau / mu));
        assert!((pair(&solved, 1, 0, Order::Exactly(0))[1] - unscattered).abs() < 5e-6);
    }
}

/// All orders of the half-space at once: ΣR_nωⁿ = 1 - √(1-ω)H(μ0), with R_n from the lossless medium.
#[test]
fn orders_sum_to_chandrasekhars_albedo() {
    let mu0 = [0.1, 0.5, 1.0];
    let solved = solver(isotropic(), 1.0, 1e-8).orders(&[1e4], &mu0.map(beam), 60).unwrap();
    for (i, mu0) in mu0.iter().enumerate() {
        for omega in [0.1, 0.3, 0.6] {
            let sum =
                (0..=60).rev().fold(0.0, |sum, n| sum * omega + pair(&solved, i, 0, Order::Exactly(n))[0]);
            let expected = 1.0 - (1.0_f64 - omega).sqrt() * h_function(omega, *mu0);
            assert!((sum - expected).abs() < 1e-8, "{omega} {mu0}: {:e}", sum - expected);
        }
    }
}

/// ΣR_nωⁿ and ΣT_nωⁿ of the lossless slab are the totals of the absorbing one, which the modes give.
#[test]
fn orders_sum_to_absorbing_totals() {
    let (tau, omega) = ([0.3, 5.0], 0.6);
    let incidence = [beam(0.0), beam(0.2), beam(1.0), Incidence::Diffuse];
    let powers =
        |g: f64| -> Vec<f64> { std::iter::successors(Some(1.0), |p| Some(p * g)).take(300).collect() };
    let c1 = common::published::coefficients("cloud-c1.csv");
    for (chi, tolerance) in [(powers(0.75), 1e-8), (powers(0.85), 1e-7), (c1, 1e-7)] {
        let of = |omega| SolveMedium::from_moments(chi.clone(), omega).unwrap();
        orders_sum_to_totals(of, (&tau, &incidence), omega, tolerance);
    }
}

/// The same for the paper's cloud, full and modified, to 1e-5.
#[test]
fn the_clouds_orders_sum_to_absorbing_totals() {
    let incidence = [beam(0.1), beam(0.3), beam(1.0), Incidence::Diffuse];
    let cut: Arc<dyn PhaseFunction> = Arc::new(Modified::new(cloud(), 5.0).unwrap());
    for phase in [cloud(), cut] {
        orders_sum_to_totals(
            |omega| SolveMedium::full(phase.clone(), omega),
            (&[0.5, 10.0], &incidence),
            0.6,
            1e-5,
        );
    }
}

fn orders_sum_to_totals(
    medium: impl Fn(SingleScatteringAlbedo) -> SolveMedium,
    (tau, incidence): (&[f64], &[Incidence]),
    omega: f64,
    tolerance: f64,
) {
    let [lossless, absorbing] = [1.0, omega]
        .map(|omega| Solver::new(medium(SingleScatteringAlbedo::new(omega).unwrap()), tolerance).unwrap());
    let orders = lossless.orders(tau, incidence, 45).unwrap();
    let totals = absorbing.totals(tau, incidence).unwrap();
    for (i, t) in (0..incidence.len()).flat_map(|i| [(i, 0), (i, 1)]) {
        let expected = pair(&totals, i, t, Order::Total);
        for (side, expected) in expected.into_iter().enumerate() {
            let term = |n| pair(&orders, i, t, Order::Exactly(n))[side];
            let sum = (0..=45).rev().fold(0.0, |sum, n| sum * omega + term(n));
            assert!((sum - expected).abs() < tolerance, "{i} {t}: {:e}", sum - expected);
        }
    }
}

#[test]
fn orders_and_tail_make_the_total_and_scale_with_albedo() {
    let incidence = [beam(0.4), Incidence::Diffuse];
    let [full, absorbing] =
        [1.0, 0.7].map(|omega| solver(hg(0.75), omega, 1e-5).orders(&[0.0, 2.0], &incidence, 3).unwrap());
    for (i, t) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
        for side in 0..2 {
            let of = |order| pair(&absorbing, i, t, order)[side];
            let sum = (0..=3).fold(of(Order::Tail), |sum, n| sum + of(Order::Exactly(n)));
            assert!((sum - of(Order::Total)).abs() < 1e-14);
            assert!(of(Order::Tail) > -1e-15);
            let lossless = pair(&full, i, t, Order::Exactly(3))[side];
            assert!((of(Order::Exactly(3)) - 0.343 * lossless).abs() < 2e-5);
        }
    }
    assert_eq!(pair(&absorbing, 0, 0, Order::Exactly(0)), [0.0, 1.0]);
}

/// Grazing light first scatters at the surface: R_1 = ½ for any thickness; isotropic light then gives R_2 =
/// ⅛ in the half-space.
#[test]
fn grazing_orders_are_exact() {
    let solved = solver(isotropic(), 1.0, 1e-7).orders(&[0.3, 1e3], &[beam(0.0)], 2).unwrap();
    for t in 0..2 {
        assert!((pair(&solved, 0, t, Order::Exactly(1))[0] - 0.5).abs() < 1e-9);
        assert_eq!(pair(&solved, 0, t, Order::Exactly(0)), [0.0, 0.0]);
    }
    let expected = 0.25 * integral(|mu| 1.0 - mu * libm::log1p(1.0 / mu));
    assert!((pair(&solved, 0, 1, Order::Exactly(2))[0] - expected).abs() < 1e-7);
}

/// The paper's cloud: errors stated at 1e-5 cover the distance to a solution at 1e-6.
#[test]
fn the_clouds_errors_are_bounds() {
    let (tau, incidence) = ([0.5, 20.0], [beam(0.1), beam(0.5), beam(1.0), Incidence::Diffuse]);
    let full = SolveMedium::full(cloud(), SingleScatteringAlbedo::CONSERVATIVE);
    for medium in [full, SolveMedium::from(&modified_cloud())] {
        let [loose, tight] = [1e-4, 2e-6].map(|tolerance| {
            Solver::new(medium.clone(), tolerance).unwrap().orders(&tau, &incidence, 2).unwrap()
        });
        for (i, t) in (0..incidence.len()).flat_map(|i| [(i, 0), (i, 1)]) {
            for n in 0..loose.orders().len() {
                let (a, b) = (loose.estimate(i, t, n), tight.estimate(i, t, n));
                for (a, b) in [(a.0, b.0), (a.1, b.1)] {
                    let off = (a.value - b.value).abs();
                    assert!(off <= a.std_error + b.std_error, "{i} {t} {n}: {off:e} {:e}", a.std_error);
                }
            }
        }
    }
}

fn compare(family: &mut Family, medium: &TraceMedium, solved: &Solved, photons: u64) {
    for (i, incidence) in solved.incidence().iter().enumerate() {
        let traced = half_space(medium, &request(solved.tau(), *incidence, photons));
        for t in 0..solved.tau().len() {
            for (n, order) in solved.orders().iter().enumerate() {
                let (a, b) = (traced.estimate(t, *order), solved.estimate(i, t, n));
                family.compare(format!("{incidence} {} R {order}", solved.tau()[t]), a.0, b.0);
                family.compare(format!("{incidence} {} T {order}", solved.tau()[t]), a.1, b.1);
            }
        }
    }
}

/// The photon tracer, the paper's cloud, full and modified. False alarms: one seed in 1000.
#[test]
fn the_tracer_agrees_on_the_papers_cloud() {
    let (tau, incidence) = ([1.0, 10.0], [beam(0.0), beam(0.2), beam(1.0), Incidence::Diffuse]);
    let mut family = Family::default();
    for medium in [full(cloud(), 1.0), modified_cloud()] {
        let solver = Solver::new(SolveMedium::from(&medium), 2e-5).unwrap();
        compare(&mut family, &medium, &solver.orders(&tau, &incidence, 2).unwrap(), 200_000);
    }
    family.assert(1e-3);
}

/// The same comparison rejects orders of an asymmetry parameter 0.01 off.
#[test]
fn planted_orders_are_rejected() {
    let mut family = Family::default();
    let solved = solver(hg(0.84), 1.0, 1e-5).orders(&[5.0], &[beam(0.5)], 2).unwrap();
    compare(&mut family, &full(hg(0.85), 1.0), &solved, 200_000);
    assert!(!family.accepts(1e-3), "{:?}", family.worst());
}

#[test]
fn more_than_sixty_orders_are_refused() {
    let error = solver(isotropic(), 1.0, 1e-3).orders(&[1.0], &[Incidence::Diffuse], 61).unwrap_err();
    assert!(matches!(error, TransportError::Domain(_)), "{error}");
}
