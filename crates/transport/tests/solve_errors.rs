//! The error that the solver reports covers the true one, from τ = 1e-6 to 1e4 and from μ0 = 0 to 1.

#![allow(clippy::unwrap_used, reason = "a test stops where it fails")]

mod common;

use common::{beam, cloud, hg, isotropic, modified_cloud};
use stratiform_quantities::{Incidence, SingleScatteringAlbedo};
use stratiform_transport::solve::{SolveMedium, Solved, Solver};

const TAU: [f64; 6] = [1e-6, 1e-4, 0.03, 0.5, 10.0, 1e4];

fn incidence() -> Vec<Incidence> {
    let beams = [0.0, 1e-6, 1e-3, 0.02, 0.1, 0.4, 0.999, 1.0].map(beam);
    beams.into_iter().chain([Incidence::Diffuse]).collect()
}

fn lossless() -> SingleScatteringAlbedo {
    SingleScatteringAlbedo::CONSERVATIVE
}

/// E_1 and E_2 (Abramowitz & Stegun 5.1.11, 5.1.14), x ≤ 2.
fn exponential_integrals(x: f64) -> (f64, f64) {
    const EULER: f64 = 0.577_215_664_901_532_9;
    let mut power = 1.0;
    let series = (1..40).fold(0.0, |sum, k| {
        power *= -x / f64::from(k);
        sum + power / f64::from(k)
    });
    let first = -EULER - libm::log(x) - series;
    (first, libm::exp(-x) - x * first)
}

/// At μ0 = 0 isotropic light gives R_1 = ½, T_1 = ½E_2(τ) and, since ∫E_1E_2 = ½(1 - E_2²), R_2 = (1 -
/// E_2(τ)²)/8.
#[test]
fn grazing_orders_of_thin_slabs_are_exponential_integrals() {
    let tau = [1e-6, 1e-5, 1e-4, 1e-3, 0.01, 0.1, 1.0];
    for tolerance in [1e-6, 1e-8, 2e-9] {
        let solver = Solver::new(SolveMedium::full(isotropic(), lossless()), tolerance).unwrap();
        for tau in tau {
            let solved = solver.orders(&[tau], &[beam(0.0)], 2).unwrap();
            let second = exponential_integrals(tau).1;
            let expected = [(1, 0.5, 0.5 * second), (2, 0.125 * (1.0 - second * second), f64::NAN)];
            for (n, reflected, transmitted) in expected {
                let (r, t) = solved.estimate(0, 0, n);
                for (found, expected) in [(r, reflected), (t, transmitted)] {
                    let off = (found.value - expected).abs();
                    // The last rounding of E_2 is ours.
                    assert!(
                        expected.is_nan() || off <= found.std_error + 1e-15,
                        "{tau} {n}: {off:e} {found:?}"
                    );
                }
            }
        }
    }
}

/// A tenth of the reported error would be too little somewhere: the comparison could fail.
#[test]
fn the_error_is_covered_and_not_by_far() {
    let mut worst = 0.0_f64;
    for (g, omega) in [(0.0, 1.0), (0.75, 0.9), (0.85, 1.0), (-0.5, 0.5)] {
        let omega = SingleScatteringAlbedo::new(omega).unwrap();
        let medium = SolveMedium::full(if g == 0.0 { isotropic() } else { hg(g) }, omega);
        worst = worst.max(covered(&medium, &[1e-4, 1e-7], 1e-8));
    }
    assert!(worst <= 1.0 && worst > 0.1, "{worst}");
}

#[test]
fn the_error_is_covered_for_the_papers_cloud() {
    let media = [SolveMedium::full(cloud(), lossless()), SolveMedium::from(&modified_cloud())];
    for medium in media {
        let worst = covered(&medium, &[1e-3, 1e-5], 1e-6);
        assert!(worst <= 1.0, "{worst}");
    }
}

/// Largest ratio of the true to the reported error of orders 0–2, tail and total; truth is a solution to `truth`.
fn covered(medium: &SolveMedium, tolerances: &[f64], truth: f64) -> f64 {
    let incidence = incidence();
    let exact = Solver::new(medium.clone(), truth).unwrap().orders(&TAU, &incidence, 2).unwrap();
    let mut worst = 0.0_f64;
    for tolerance in tolerances {
        let solver = Solver::new(medium.clone(), *tolerance).unwrap();
        for (t, tau) in TAU.iter().enumerate() {
            // Each alone: in a list the slowest case pulls the others up the ladder.
            for (i, incidence) in incidence.iter().enumerate() {
                let loose = solver.orders(&[*tau], &[*incidence], 2).unwrap();
                assert!(loose.worst_error() <= *tolerance);
                let ratio = ratio(&loose, &exact, (i, t));
                worst = worst.max(ratio);
            }
        }
    }
    worst
}

fn ratio(loose: &Solved, exact: &Solved, (i, t): (usize, usize)) -> f64 {
    (0..loose.orders().len()).fold(0.0, |worst, n| {
        let (a, b) = (loose.estimate(0, 0, n), exact.estimate(i, t, n));
        let of = |a: stratiform_stats::Estimate, b: stratiform_stats::Estimate| {
            (a.value - b.value).abs() / (a.std_error + b.std_error)
        };
        worst.max(of(a.0, b.0)).max(of(a.1, b.1))
    })
}
