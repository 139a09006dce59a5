//! The deterministic solver's totals against published fluxes, laws and closed forms.

#![allow(clippy::unwrap_used, reason = "a test stops where it fails")]

mod common;

use common::h_function;
use common::published::{Published, coefficients, published};
use common::{beam, full, half_space, hg, isotropic, modified, request};
use std::f64::consts::PI;
use std::sync::Arc;
use stratiform_optics::phase::PhaseFunction;
use stratiform_quantities::{Incidence, SingleScatteringAlbedo};
use stratiform_transport::solve::{SolveMedium, Solver};
use stratiform_transport::{TraceMedium, TransportError};

fn albedo(omega: f64) -> SingleScatteringAlbedo {
    SingleScatteringAlbedo::new(omega).unwrap()
}

fn solver(phase: Arc<dyn PhaseFunction>, omega: f64, tolerance: f64) -> Solver {
    Solver::new(SolveMedium::full(phase, albedo(omega)), tolerance).unwrap()
}

fn totals(solver: &Solver, tau: f64, incidence: Incidence) -> (f64, f64) {
    let solved = solver.totals(&[tau], &[incidence]).unwrap();
    let (reflectance, transmittance) = solved.total(0, 0);
    (reflectance.value, transmittance.value)
}

/// Half a unit of the last of `digits` decimals of a quantity listed in units of `unit`, and a little for
/// our own error.
fn rounding(digits: i32, unit: f64) -> f64 {
    0.51 * libm::pow(10.0, f64::from(-digits)) / unit + 2e-8
}

/// `scale` undoes a division by a rounded incident flux.
fn assert_meets(case: &Published, solver: &Solver, scale: f64, tolerances: [f64; 2]) {
    let (r, t) = totals(solver, case.tau, case.incidence);
    let (dr, dt) = (r - case.reflectance * scale, t - case.transmittance * scale);
    assert!(dr.abs() <= tolerances[0] && dt.abs() <= tolerances[1], "{}: {dr:e} {dt:e}", case.name);
}

#[test]
fn van_de_hulst_to_five_decimals() {
    for case in published().iter().filter(|case| case.name.starts_with("van de Hulst")) {
        let solver = solver(case.phase.clone(), case.omega, 1e-8);
        assert_meets(case, &solver, 1.0, [rounding(5, 1.0); 2]);
    }
}

/// Van de Hulst's table behind problem 3 has 5 digits; the fluxes are those digits times π.
#[test]
fn disort_problem_3_to_five_digits() {
    for case in published().iter().filter(|case| case.name.starts_with("DISORT 3")) {
        let solver = solver(case.phase.clone(), case.omega, 1e-8);
        assert_meets(case, &solver, 1.0, [rounding(5, 1.0); 2]);
    }
}

/// Haze L and cloud C1, from their coefficients: 6 digits of reflected and diffusely transmitted flux.
#[test]
fn disort_problems_4_and_5a_to_six_digits() {
    for (name, file) in
        [("4a", "haze-l.csv"), ("4b", "haze-l.csv"), ("4c", "haze-l.csv"), ("5a", "cloud-c1.csv")]
    {
        let case = published().into_iter().find(|case| case.name == format!("DISORT {name}")).unwrap();
        let medium = SolveMedium::from_moments(coefficients(file), albedo(case.omega)).unwrap();
        let (incident, listed) = if name == "4c" {
            (0.5 * PI, (0.5e4 * PI).round() / 1e4)
        } else {
            (PI, (1e5 * PI).round() / 1e5)
        };
        // Listed are a reflected flux below 1 and a transmitted one of 1 to 10 (direct and diffuse, each
        // rounded).
        let digits = if name == "5a" { [5, 6] } else { [6, if name == "4c" { 6 } else { 5 }] };
        let allowed = digits.map(|digits| 2.0 * rounding(digits, incident));
        assert_meets(&case, &Solver::new(medium, 1e-8).unwrap(), listed / incident, allowed);
    }
}

/// The comparison rejects an asymmetry parameter off by 1e-4.
#[test]
fn a_planted_asymmetry_is_rejected() {
    let case = published().into_iter().find(|case| case.name == "DISORT 3b").unwrap();
    let (r, _) = totals(&solver(hg(0.7501), 1.0, 1e-8), case.tau, case.incidence);
    assert!((r - case.reflectance).abs() > rounding(5, 1.0));
}

#[test]
fn lossless_slabs_lose_nothing() {
    let tau = [0.0, 1e-6, 1e-3, 0.1, 1.0, 30.0, 1e3, 1e4];
    let incidence = [beam(0.0), beam(1e-9), beam(0.01), beam(0.5), beam(1.0), Incidence::Diffuse];
    for phase in [isotropic(), hg(0.85), hg(-0.5)] {
        let solved = solver(phase, 1.0, 1e-3).totals(&tau, &incidence).unwrap();
        for (i, incidence) in incidence.iter().enumerate() {
            for (t, tau) in tau.iter().enumerate() {
                let (r, t) = solved.total(i, t);
                let loss = r.value + t.value - 1.0;
                assert!(loss.abs() < 1e-10, "{incidence} {tau}: {loss:e}");
                assert!(r.value > -1e-15 && t.value > -1e-15, "{incidence} {tau}: {r:?} {t:?}");
            }
        }
    }
}

/// μ0 → 0 meets its limit, and R → ½ as τ → 0 there: the first event happens at the surface.
#[test]
fn grazing_incidence_is_a_limit() {
    let solver = solver(isotropic(), 1.0, 1e-5);
    let at = |mu0: f64, tau: f64| totals(&solver, tau, beam(mu0)).0;
    assert!((at(0.0, 5.0) - at(1e-9, 5.0)).abs() < 1e-7);
    assert!((at(0.0, 1e-6) - 0.5).abs() < 1e-4);
    assert_eq!(totals(&solver, 0.0, beam(0.0)), (0.0, 1.0));
}

/// A stream of the rule itself (μ = ½ is one of every odd rule; 0.9801449282487681 of the rule of eight) is
/// nothing special.
#[test]
fn incidence_on_a_stream_is_ordinary() {
    let solver = solver(hg(0.75), 0.9, 1e-3);
    for mu0 in [0.980_144_928_248_768_1, 0.5] {
        let (r, t) = totals(&solver, 3.0, beam(mu0));
        let near = totals(&solver, 3.0, beam(mu0 + 1e-9));
        assert!((r - near.0).abs() < 1e-8 && (t - near.1).abs() < 1e-8);
    }
}

/// Plane albedo of the half-space: 1 - √(1-ω) H(μ0) (Chandrasekhar 1950, ch. 5).
#[test]
fn the_half_space_has_chandrasekhars_albedo() {
    for omega in [0.2, 0.9, 0.99] {
        let solver = solver(isotropic(), omega, 1e-8);
        for mu0 in [0.0, 0.05, 0.3, 1.0] {
            let (r, t) = totals(&solver, 1e4, beam(mu0));
            let expected = 1.0 - (1.0 - omega).sqrt() * h_function(omega, mu0);
            assert!((r - expected).abs() < 1e-8, "{omega} {mu0}: {:e}", r - expected);
            assert!(t.abs() < 1e-12);
        }
    }
}

/// Collisions of diffuse light, (1-R-T)/(1-ω), tend to 2τ as ω → 1, whatever the phase function:
/// extrapolated in 1-ω.
#[test]
fn diffuse_light_scatters_twice_the_optical_thickness() {
    for (g, tau) in [(0.0, 0.1), (0.0, 10.0), (0.85, 1.0), (0.85, 30.0)] {
        let collisions = |loss: f64| {
            let omega = 1.0 - loss;
            let (r, t) = totals(&solver(hg(g), omega, 1e-3), tau, Incidence::Diffuse);
            (1.0 - r - t) / (1.0 - omega)
        };
        let mut row: Vec<f64> = (0..5).map(|i| collisions(0.01 / (1.0 + tau) / f64::from(1 << i))).collect();
        for level in 1..5 {
            let two = f64::from(1 << level);
            row = row.windows(2).map(|pair| (two * pair[1] - pair[0]) / (two - 1.0)).collect();
        }
        assert!((row[0] / (2.0 * tau) - 1.0).abs() < 1e-8, "{g} {tau}: {:e}", row[0] / (2.0 * tau) - 1.0);
    }
}

/// The photon tracer, full and modified media, ω below 1. False alarms: one seed in 1000.
#[test]
fn the_tracer_agrees() {
    let mut family = common::Family::default();
    let media: [(&str, TraceMedium); 3] = [
        ("isotropic", full(isotropic(), 0.9)),
        ("hg 0.85", full(hg(0.85), 1.0)),
        ("modified", modified(hg(0.5), 0.95, 0.3)),
    ];
    let tau = [0.5, 3.0, 20.0];
    let incidence = [beam(0.0), beam(0.3), beam(1.0), Incidence::Diffuse];
    for (name, medium) in &media {
        let solved = Solver::new(SolveMedium::from(medium), 1e-6).unwrap().totals(&tau, &incidence).unwrap();
        for (i, incidence) in incidence.iter().enumerate() {
            let traced = half_space(medium, &request(&tau, *incidence, 200_000));
            for (t, tau) in tau.iter().enumerate() {
                let (a, b) = (traced.estimate(t, stratiform_quantities::Order::Total), solved.total(i, t));
                family.compare(format!("{name} {incidence} {tau} R"), a.0, b.0);
                family.compare(format!("{name} {incidence} {tau} T"), a.1, b.1);
            }
        }
    }
    family.assert(1e-3);
}

/// The error reported at a loose tolerance covers the distance to a tight solution: 3 phase functions, 3 albedos, 7 thicknesses,
/// 5 incidences, 3 tolerances.
#[test]
fn the_reported_error_is_a_bound() {
    let tau = [1e-3, 0.03, 0.3, 1.0, 5.0, 50.0, 1e3];
    let incidence = [beam(0.02), beam(0.1), beam(0.4), beam(0.999), Incidence::Diffuse];
    for (phase, omega) in
        [0.0, 0.75, 0.9].into_iter().flat_map(|g| [(hg(g), 1.0), (hg(g), 0.99), (hg(g), 0.5)])
    {
        let exact = solver(phase.clone(), omega, 1e-8).totals(&tau, &incidence).unwrap();
        for tolerance in [1e-2, 1e-3, 1e-5] {
            let loose = solver(phase.clone(), omega, tolerance);
            for (t, tau) in tau.iter().enumerate() {
                let loose = loose.totals(&[*tau], &incidence).unwrap();
                assert!(loose.worst_error() <= tolerance);
                for (i, incidence) in incidence.iter().enumerate() {
                    let (a, b) = (loose.total(i, 0), exact.total(i, t));
                    for (a, b) in [(a.0, b.0), (a.1, b.1)] {
                        let off = (a.value - b.value).abs();
                        assert!(
                            off <= a.std_error + b.std_error,
                            "{omega} {tau} {incidence}: {off:e} {:e}",
                            a.std_error
                        );
                    }
                }
            }
        }
    }
}

#[test]
fn a_tolerance_out_of_reach_says_what_was_reached() {
    let error = solver(isotropic(), 1.0, 1e-12).totals(&[1e-4], &[beam(0.0)]).unwrap_err();
    assert!(
        matches!(error, TransportError::Tolerance { reached, .. } if reached > 1e-12 && reached < 1e-6),
        "{error}"
    );
}

#[test]
fn bad_input_is_refused() {
    let medium = SolveMedium::full(isotropic(), SingleScatteringAlbedo::CONSERVATIVE);
    assert!(Solver::new(medium.clone(), f64::NAN).is_err());
    let solver = Solver::new(medium, 1e-3).unwrap();
    assert!(solver.totals(&[], &[Incidence::Diffuse]).is_err());
    assert!(solver.totals(&[1.0], &[]).is_err());
    assert!(solver.totals(&[f64::NAN], &[Incidence::Diffuse]).is_err());
    assert!(SolveMedium::from_moments(vec![0.5], albedo(1.0)).is_err());
}

/// Moments of no probability (P = 1 + 3cosΘ is negative backwards), a pure forward delta, and moments beyond the last one kept:
/// either a finite answer or an error, never NaN.
#[test]
fn nothing_gives_nan() {
    let lossless = SingleScatteringAlbedo::CONSERVATIVE;
    let odd = [vec![1.0, 1.0], vec![1.0, -1.0, -1.0], vec![1.0; 300]];
    let mut media: Vec<SolveMedium> =
        odd.into_iter().map(|chi| SolveMedium::from_moments(chi, lossless).unwrap()).collect();
    media.push(SolveMedium::full(hg(0.9999), lossless));
    for medium in media {
        match Solver::new(medium, 1e-5).unwrap().orders(&[1e-6, 1.0, 1e4], &[beam(0.3)], 2) {
            Ok(solved) => (0..3).for_each(|t| assert!(solved.total(0, t).0.value.is_finite())),
            Err(error) => assert!(matches!(error, TransportError::Tolerance { .. }), "{error}"),
        }
    }
}
