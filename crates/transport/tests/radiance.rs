//! Radiance against closed forms, laws, and the fluxes of the other solver.

#![allow(clippy::unwrap_used, reason = "a test stops where it fails")]

mod common;

use common::{beam, cloud, full, h_function, hg, isotropic, modified_cloud};
use std::f64::consts::PI;
use std::sync::Arc;
use stratiform_optics::phase::{PhaseFunction, Rayleigh};
use stratiform_quantities::{Order, Side, SingleScatteringAlbedo};
use stratiform_transport::TransportError;
use stratiform_transport::solve::{RadianceOrder, RadianceSolver, Radiances, SolveMedium, Solver, View};

use RadianceOrder::{One, Total, Two};
use Side::{Bottom, Top};

fn medium(phase: Arc<dyn PhaseFunction>, omega: f64) -> SolveMedium {
    SolveMedium::full(phase, SingleScatteringAlbedo::new(omega).unwrap())
}

fn solver(medium: SolveMedium, tolerance: f64) -> RadianceSolver {
    RadianceSolver::new(medium, tolerance).unwrap()
}

fn view(side: Side, mu: f64, phi_deg: f64) -> View {
    View { side, mu, phi_deg }
}

fn total(solver: &RadianceSolver, tau: f64, mu0: f64, view: View) -> f64 {
    solver.radiance(&[tau], &[mu0], &[view]).unwrap().estimate(0, 0, 0, Total).value
}

/// Zenith angles and weights of ∫f μ dμ over one hemisphere: Gauss rules of five points on panels that halve towards the
/// normal.
fn hemisphere() -> Vec<(f64, f64)> {
    const X: [f64; 3] = [0.0, 0.538_469_310_105_683, 0.906_179_845_938_664];
    const W: [f64; 3] = [0.568_888_888_888_889, 0.478_628_670_499_366, 0.236_926_885_056_189];
    let mut ends: Vec<f64> = (0..=8).map(|k| 0.4 / f64::from(1 << k)).chain([0.0]).rev().collect();
    // The rim of the cut peak, where order 1 jumps.
    ends.extend([5.0_f64.to_radians(), 0.7, 1.0, 1.25, 1.45, 1.54, 0.5 * PI]);
    ends.sort_by(f64::total_cmp);
    let mut rule = Vec::new();
    for pair in ends.windows(2) {
        for (x, w) in [(-X[2], W[2]), (-X[1], W[1]), (X[0], W[0]), (X[1], W[1]), (X[2], W[2])] {
            let theta = 0.5 * (pair[0] + pair[1] + (pair[1] - pair[0]) * x);
            let (sine, cosine) = (libm::sin(theta), libm::cos(theta));
            rule.push((cosine, 0.5 * (pair[1] - pair[0]) * w * sine * cosine));
        }
    }
    rule
}

/// (1/π)∫∫ value μ dμ dφ for `azimuths` midpoints of half a turn.
fn flux(medium: &SolveMedium, tau: f64, mu0: f64, azimuths: u32, tolerance: f64) -> [[f64; 3]; 2] {
    let rule = hemisphere();
    let azimuth = |k: u32| 180.0 * (f64::from(k) + 0.5) / f64::from(azimuths);
    let mut views = Vec::new();
    for side in [Top, Bottom] {
        for (mu, _) in &rule {
            views.extend((0..azimuths).map(|k| view(side, *mu, azimuth(k))));
        }
    }
    let solved = solver(medium.clone(), tolerance).radiance(&[tau], &[mu0], &views).unwrap();
    let mut flux = [[0.0; 3]; 2];
    for (v, view) in views.iter().enumerate() {
        let weight = rule[v / azimuths as usize % rule.len()].1 * 2.0 / f64::from(azimuths);
        for (n, order) in RadianceOrder::ALL.into_iter().enumerate() {
            flux[view.side as usize][n] += weight * solved.estimate(0, 0, v, order).value;
        }
    }
    flux
}

/// Orders 1 and 2 and the scattered total, integrated over each hemisphere, are R_n and T_n of the flux solver.
fn assert_fluxes(name: &str, medium: &SolveMedium, (tau, mu0): (f64, f64), azimuths: u32, allowed: f64) {
    let found = flux(medium, tau, mu0, azimuths, 3.0 * allowed);
    let expected = Solver::new(medium.clone(), 1e-7).unwrap().orders(&[tau], &[beam(mu0)], 2).unwrap();
    let place = |order: Order| expected.orders().iter().position(|other| *other == order).unwrap();
    let unscattered = expected.estimate(0, 0, 0).1.value;
    for (n, order) in [Order::Exactly(1), Order::Exactly(2), Order::Total].into_iter().enumerate() {
        let (r, t) = expected.estimate(0, 0, place(order));
        let t = t.value - if order == Order::Total { unscattered } else { 0.0 };
        let off = [found[0][n] - r.value, found[1][n] - t];
        assert!(off.iter().all(|off| off.abs() <= allowed), "{name} {order}: {off:?} of {} {t}", r.value);
    }
}

#[test]
fn hemispheres_hold_the_fluxes_of_smooth_functions() {
    assert_fluxes("isotropic", &medium(isotropic(), 1.0), (1.0, 0.6), 1, 2e-6);
    assert_fluxes("isotropic, absorbing", &medium(isotropic(), 0.8), (5.0, 0.1), 1, 2e-6);
    assert_fluxes("rayleigh", &medium(Arc::new(Rayleigh), 1.0), (0.3, 0.3), 4, 2e-6);
}

#[test]
fn hemispheres_hold_the_fluxes_of_peaked_functions() {
    assert_fluxes("hg 0.85", &medium(hg(0.85), 1.0), (3.0, 1.0), 1, 1e-5);
    assert_fluxes("modified cloud", &SolveMedium::from(&modified_cloud()), (5.0, 1.0), 1, 1e-3);
}

/// The comparison of fluxes rejects ω off by 1e-4.
#[test]
fn a_planted_absorption_is_rejected() {
    let found = flux(&medium(isotropic(), 1.0 - 1e-4), 1.0, 0.6, 1, 1e-6);
    let exact = Solver::new(medium(isotropic(), 1.0), 1e-7).unwrap().totals(&[1.0], &[beam(0.6)]).unwrap();
    assert!((found[0][2] - exact.total(0, 0).0.value).abs() > 2e-6);
}

/// ω/4 · H(μ)H(μ0)/(μ+μ0) of the isotropic half-space (Chandrasekhar 1950, ch. 5 § 38).
#[test]
fn the_half_space_is_chandrasekhars() {
    for omega in [0.5, 0.9, 0.99] {
        let solver = solver(medium(isotropic(), omega), 1e-6);
        for mu0 in [0.01, 0.3, 1.0] {
            for mu in [0.01, 0.3, 0.77] {
                let found = total(&solver, 1e4, mu0, view(Top, mu, 0.0));
                let h = h_function(omega, mu) * h_function(omega, mu0);
                let expected = 0.25 * omega * h / (mu + mu0);
                assert!(
                    (found - expected).abs() < 1e-6 * expected.max(1.0),
                    "{omega} {mu0} {mu}: {found} {expected}"
                );
            }
        }
    }
}

/// Light from Ω0 towards Ω is light from Ω towards Ω0, above and below; in πL/(μ0F0) both are the same number.
#[test]
fn radiance_is_reciprocal() {
    for (medium, tolerance) in [
        (medium(hg(0.75), 0.97), 1e-6),
        (SolveMedium::from(&modified_cloud()), 1e-3),
        (medium(cloud(), 1.0), 1e-2),
    ] {
        let solver = solver(medium, tolerance);
        for side in [Top, Bottom] {
            for phi in [0.0, 70.0, 180.0] {
                let there = solver.radiance(&[2.0], &[0.9], &[view(side, 0.3, phi)]).unwrap();
                let back = solver.radiance(&[2.0], &[0.3], &[view(side, 0.9, phi)]).unwrap();
                for (order, allowed) in [(One, 1e-13), (Two, 0.02 * tolerance), (Total, 0.1 * tolerance)] {
                    let (a, b) = (there.estimate(0, 0, 0, order), back.estimate(0, 0, 0, order));
                    assert!(
                        (a.value - b.value).abs() <= allowed * a.value.max(1.0),
                        "{side:?} {phi} {order:?}: {a:?} {b:?}"
                    );
                }
            }
        }
    }
}

/// Order 1 above and below, written as in textbooks.
#[test]
fn order_one_is_the_textbooks() {
    let (tau, mu0, mu, phi, omega): (f64, f64, f64, f64, f64) = (1.7, 0.8, 0.4, 50.0, 0.9);
    let solver = solver(medium(hg(0.6), omega), 1e-3);
    let sines = ((1.0 - mu0 * mu0) * (1.0 - mu * mu)).sqrt() * libm::cos(phi.to_radians());
    let exponential = |mu: f64| libm::exp(-tau / mu);
    let above = (1.0 - exponential(mu) * exponential(mu0)) / (mu + mu0);
    let below = (exponential(mu) - exponential(mu0)) / (mu - mu0);
    for (side, cosine, depth) in [(Top, sines - mu * mu0, above), (Bottom, sines + mu * mu0, below)] {
        let solved = solver.radiance_as_reached(One, &[tau], &[mu0], &[view(side, mu, phi)]).unwrap();
        let expected = 0.25 * omega * hg(0.6).value(1.0 - cosine) * depth;
        assert!((solved.estimate(0, 0, 0, One).value / expected - 1.0).abs() < 1e-12, "{side:?}");
    }
}

/// Transmission towards the sun, thickness from nothing to opaque, and grazing are ordinary values: neighbours agree.
#[test]
fn limits_are_met() {
    let solver = solver(medium(hg(0.75), 1.0), 1e-4);
    for tau in [1e-6, 1.0, 1e4] {
        for (near, at) in [(0.5 + 1e-9, 0.5), (1e-9, 0.0), (1.0 - 1e-12, 1.0)] {
            for side in [Top, Bottom] {
                let (a, b) = (
                    total(&solver, tau, 0.5, view(side, near, 0.0)),
                    total(&solver, tau, 0.5, view(side, at, 0.0)),
                );
                assert!((a - b).abs() < 1e-5 * a.abs().max(1.0), "{tau} {at} {side:?}: {a} {b}");
                assert!(a > -1e-7, "{tau} {at} {side:?}: {a}");
                let swapped = total(&solver, tau, at, view(side, 0.5, 0.0));
                assert!((swapped - b).abs() < 1e-4 * b.abs().max(1.0), "{tau} {at} {side:?}: {swapped} {b}");
            }
        }
    }
    assert_eq!(total(&solver, 0.0, 0.5, view(Top, 0.5, 0.0)), 0.0);
}

/// The error reported at a loose tolerance covers the distance to a tight solution, in the glory, at the rim of the cut peak,
/// on both sides of the sun's direction and at grazing.
#[test]
fn the_reported_error_is_a_bound() {
    let views = [
        view(Top, 0.5, 180.0),
        view(Top, 0.45, 180.0),
        view(Top, 0.05, 0.0),
        view(Top, 0.8, 90.0),
        view(Bottom, 0.5, 5.5),
        view(Bottom, 0.42, 0.0),
        view(Bottom, 1.0, 0.0),
        view(Bottom, 0.01, 120.0),
    ];
    let tau = [1e-3, 1.0, 16.0];
    for (name, medium) in [
        ("hg 0.85", medium(hg(0.85), 1.0)),
        ("modified cloud", SolveMedium::from(&modified_cloud())),
        ("cloud", medium(cloud(), 0.99)),
    ] {
        let tight = solver(medium.clone(), 1e-3).radiance(&tau, &[0.5], &views).unwrap();
        for tolerance in [0.1, 1e-2] {
            let loose = solver(medium.clone(), tolerance).radiance(&tau, &[0.5], &views).unwrap();
            assert_bounded(name, &loose, &tight, tolerance);
        }
    }
}

fn assert_bounded(name: &str, loose: &Radiances, tight: &Radiances, tolerance: f64) {
    for t in 0..3 {
        for v in 0..8 {
            for order in RadianceOrder::ALL {
                let (a, b) = (loose.estimate(t, 0, v, order), tight.estimate(t, 0, v, order));
                let off = (a.value - b.value).abs();
                assert!(
                    off <= a.std_error + b.std_error,
                    "{name} {tolerance} {t} {v} {order:?}: {a:?} {b:?}"
                );
                assert!(a.std_error <= tolerance * a.value.max(1.0));
            }
        }
    }
}

#[test]
fn many_geometries_at_once_are_the_same_as_one() {
    let solver = solver(medium(hg(0.75), 0.9), 1e-3);
    let views = [view(Top, 0.3, 20.0), view(Bottom, 0.3, 200.0), view(Top, 0.3, -160.0)];
    let all = solver.radiance(&[0.5, 2.0], &[0.2, 0.7], &views).unwrap();
    let one = solver.radiance(&[2.0], &[0.7], &views[1..2]).unwrap();
    for order in RadianceOrder::ALL {
        let (a, b) = (all.estimate(1, 1, 1, order), one.estimate(0, 0, 0, order));
        assert!((a.value - b.value).abs() <= 2e-3 * b.value.max(1.0));
    }
    assert!(all.streams() >= one.streams());
}

/// What suns share changes no bit.
#[test]
fn suns_with_views_of_their_own_are_the_same_as_each_alone() {
    let solver = solver(medium(cloud(), 1.0), 1e-2);
    let tau = [0.5, 16.0];
    let suns =
        [(1.0, vec![view(Top, 0.4, 0.0)]), (0.3, vec![view(Top, 0.3, 180.0), view(Bottom, 0.8, 90.0)])];
    let all = solver.radiance_of_suns(&tau, &suns).unwrap();
    for ((mu0, views), found) in suns.iter().zip(&all) {
        let alone = solver.radiance(&tau, &[*mu0], views).unwrap();
        for (t, v) in (0..tau.len()).flat_map(|t| (0..views.len()).map(move |v| (t, v))) {
            for order in RadianceOrder::ALL {
                assert_eq!(found.estimate(t, 0, v, order), alone.estimate(t, 0, v, order), "{mu0} {t} {v}");
            }
        }
    }
    assert!(solver.radiance_of_suns(&tau, &[]).is_err());
    assert!(solver.radiance_of_suns(&tau, &[(1.0, Vec::new())]).is_err());
}

#[test]
fn bad_input_is_refused() {
    let medium = medium(isotropic(), 1.0);
    for tolerance in [f64::NAN, 0.0, 1.0, 1e-12] {
        assert!(RadianceSolver::new(medium.clone(), tolerance).is_err());
    }
    let solver = solver(medium, 1e-3);
    let good = view(Top, 0.5, 0.0);
    let refused =
        |tau: &[f64], mu0: &[f64], views: &[View]| solver.radiance(tau, mu0, views).unwrap_err().to_string();
    assert!(refused(&[], &[1.0], &[good]).contains("tau"));
    assert!(refused(&[1.0], &[], &[good]).contains("mu0"));
    assert!(refused(&[1.0], &[1.0], &[]).contains("view"));
    assert!(refused(&[-1.0], &[1.0], &[good]).contains("-1"));
    assert!(refused(&[1.0], &[1.5], &[good]).contains("mu0 = 1.5"));
    assert!(refused(&[1.0], &[1.0], &[view(Top, f64::NAN, 0.0)]).contains("view mu = NaN"));
    assert!(refused(&[1.0], &[1.0], &[view(Top, 0.5, 400.0)]).contains("phi (degrees) = 400"));
    assert!(refused(&[1.0], &[0.0], &[view(Bottom, 0.0, 0.0)]).contains("mu0 + view mu = 0"));
}

/// A needle (g = 0.9999), no probability (P = 1 + 3cosΘ), and a forward delta: an answer or an error, never NaN.
#[test]
fn nothing_gives_nan() {
    let lossless = SingleScatteringAlbedo::CONSERVATIVE;
    let mut media = vec![medium(hg(0.9999), 1.0)];
    for chi in [vec![1.0, 1.0], vec![1.0, -1.0, -1.0], vec![1.0; 40]] {
        media.push(SolveMedium::from_moments(chi, lossless).unwrap());
    }
    let views = [view(Top, 0.3, 180.0), view(Bottom, 0.3, 1.0)];
    for medium in media {
        match solver(medium, 1e-2).radiance(&[1e-6, 1.0, 1e4], &[0.3], &views) {
            Ok(solved) => (0..6).for_each(|i| {
                let estimate = solved.estimate(i / 2, 0, i % 2, Total);
                assert!(estimate.value.is_finite() && estimate.std_error.is_finite());
            }),
            Err(error) => {
                assert!(
                    matches!(error, TransportError::Tolerance { .. } | TransportError::Rule { .. }),
                    "{error}"
                );
            }
        }
    }
}

/// The full medium of a tracer is that of its phase function.
#[test]
fn media_of_the_tracer_are_the_same() {
    let there = solver(SolveMedium::from(&full(hg(0.5), 0.9)), 1e-4);
    let here = solver(medium(hg(0.5), 0.9), 1e-4);
    let at = view(Top, 0.7, 33.0);
    assert_eq!(total(&there, 2.0, 0.4, at), total(&here, 2.0, 0.4, at));
}
