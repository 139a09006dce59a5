//! Radiance where methods fail: at the horizon, where a series could end too early, and where two rules agree by chance.

#![allow(clippy::unwrap_used, reason = "a test stops where it fails")]

mod common;

use common::{cloud, modified_cloud};
use stratiform_quantities::{Side, SingleScatteringAlbedo};
use stratiform_transport::solve::{RadianceOrder, RadianceSolver, Radiances, SolveMedium, View};

use RadianceOrder::{Total, Two};
use Side::{Bottom, Top};

fn view(side: Side, mu: f64, phi_deg: f64) -> View {
    View { side, mu, phi_deg }
}

/// P = 1 + P_l, which any sum that looks at the wrong places misses.
fn one_wave(l: usize) -> SolveMedium {
    let mut chi = vec![0.0; l + 1];
    (chi[0], chi[l]) = (1.0, 1.0 / (2 * l + 1) as f64);
    SolveMedium::from_moments(chi, SingleScatteringAlbedo::CONSERVATIVE).unwrap()
}

fn solve(medium: &SolveMedium, tolerance: f64, tau: f64, mu0: f64, views: &[View]) -> Radiances {
    RadianceSolver::new(medium.clone(), tolerance).unwrap().radiance(&[tau], &[mu0], views).unwrap()
}

/// Towards the horizon radiance has a limit that it reaches smoothly, for a function with an edge and one with a peak,
/// and for a sun at the horizon the same by reciprocity.
#[test]
fn the_horizon_is_a_limit() {
    let cosines = [3e-3, 1e-3, 3e-4, 1e-4, 1e-5, 0.0];
    for (name, medium) in [("modified", SolveMedium::from(&modified_cloud())), ("wave", one_wave(50))] {
        for side in [Top, Bottom] {
            let views = cosines.map(|mu| view(side, mu, 0.0));
            for tau in [0.5, 10.0] {
                let solved = solve(&medium, 2e-2, tau, 0.8, &views);
                let values = [0, 1, 2, 3, 4, 5].map(|i| solved.estimate(0, 0, i, Total));
                for pair in values.windows(2) {
                    let step = (pair[0].value - pair[1].value).abs();
                    assert!(step < 0.03 * pair[0].value.abs(), "{name} {side:?} {tau}: {values:?}");
                }
                let sun = solve(&medium, 2e-2, tau, 0.0, &[view(side, 0.8, 0.0)]).estimate(0, 0, 0, Total);
                let error = sun.std_error + values[5].std_error;
                assert!((sun.value - values[5].value).abs() <= error, "{name} {side:?} {tau}: {sun:?}");
            }
        }
    }
}

/// The cloud's horizon converges slowly: the error reported must know.
#[test]
fn slow_convergence_is_reported() {
    let medium = SolveMedium::full(cloud(), SingleScatteringAlbedo::CONSERVATIVE);
    let views = [5e-4, 1e-3, 5e-3, 0.05].map(|mu| view(Top, mu, 0.0));
    let loose = solve(&medium, 5e-2, 10.0, 1.0, &views);
    let tight = solve(&medium, 1e-2, 10.0, 1.0, &views);
    assert!(loose.streams() < tight.streams());
    for i in 0..views.len() {
        let (loose, tight) = (loose.estimate(0, 0, i, Total), tight.estimate(0, 0, i, Total));
        let off = (loose.value - tight.value).abs();
        assert!(off <= loose.std_error + tight.std_error, "{i}: {loose:?} {tight:?}");
    }
}

/// μ0 at the zero of P_3^1, a view at the horizon where P_3^2 vanishes: mode 3 is none the less there.
#[test]
fn modes_that_vanish_by_symmetry_do_not_end_the_series() {
    let medium = one_wave(3);
    let (sun, horizon) = (0.2_f64.sqrt(), view(Top, 1e-5, 0.0));
    let alone = solve(&medium, 1e-4, 2.0, sun, &[horizon]).estimate(0, 0, 0, Total);
    let among = solve(&medium, 1e-4, 2.0, sun, &[horizon, view(Top, 0.5, 0.0)]).estimate(0, 0, 0, Total);
    assert!((alone.value - among.value).abs() < 1e-5, "{alone:?} {among:?}");
}

/// Fifty waves over the sphere and no peak: order 2's own error covers what a finer rule finds.
#[test]
fn rules_do_not_agree_by_chance() {
    let medium = one_wave(50);
    for (tau, mu0, mu, phi) in [(2.0, 0.9, 0.9, 0.0), (0.18, 0.147, 0.287, 180.0), (1.0, 0.4, 0.63, 77.0)] {
        let views = [view(Top, mu, phi), view(Bottom, mu, phi)];
        let [loose, tight] = [1e-2, 1e-6].map(|tolerance| {
            let solver = RadianceSolver::new(medium.clone(), tolerance).unwrap();
            solver.radiance_as_reached(Two, &[tau], &[mu0], &views).unwrap()
        });
        for i in 0..2 {
            let (loose, tight) = (loose.estimate(0, 0, i, Two), tight.estimate(0, 0, i, Two));
            let off = (loose.value - tight.value).abs();
            assert!(off <= loose.std_error + tight.std_error, "{mu0} {mu} {i}: {loose:?} {tight:?}");
        }
    }
}
