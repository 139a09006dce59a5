//! Both photon tracers against the deterministic solver over a designed grid; `--example agreement` is its full size.

#![allow(
    clippy::unwrap_used,
    clippy::print_stdout,
    reason = "a test may stop where it fails, and says what it measured"
)]

mod common;

use common::agreement::{Agreement, Budget, Case, INCIDENCES, OMEGA, PHASES, TAU, design};
use common::{full, hg};
use std::collections::BTreeSet;

const BUDGET: Budget = Budget { photons: 2e5, plain_share: 0.25, seed: 1, tolerance: 1e-6 };

/// Of each of the four judgements; together they fail a right program in at most 4 of 10 000 seeds.
const ALPHA: f64 = 1e-4;

#[test]
fn every_pair_of_levels_meets() {
    let levels: Vec<[usize; 5]> =
        design().iter().map(|c| [c.phase, c.tau, c.incidence, c.omega, usize::from(c.plain)]).collect();
    let counts = [PHASES.len(), TAU.len(), INCIDENCES, OMEGA.len(), 2];
    for (a, b) in (0..5).flat_map(|a| (0..a).map(move |b| (a, b))) {
        let pairs: BTreeSet<_> = levels.iter().map(|case| (case[a], case[b])).collect();
        assert_eq!(pairs.len(), counts[a] * counts[b], "factors {a} and {b}");
    }
}

#[test]
fn tracers_and_solver_agree() {
    let grid = Agreement::new(BUDGET);
    let (row, worst) = grid.worst();
    let (normal, uniform) = (grid.drawn_are_normal(), grid.chi_squares_are_uniform());
    let summary = format!(
        "{} numbers of {} cases, largest |z| {:.2} (threshold {:.2}) at {} {:?}; normality of z: p = {:.3}; uniformity of \
         chi-square: p = {:.3}; failing cases {:?}",
        grid.numbers(),
        grid.rows.len(),
        worst.z.abs(),
        grid.threshold(ALPHA),
        row.case.name(),
        worst.quantity,
        normal.p_value,
        uniform.p_value,
        grid.chi_square_failures(ALPHA)
    );
    println!("{summary}");
    assert!(grid.numbers() > 200, "guard against checking nothing");
    assert!(grid.accepts(ALPHA), "{summary}");
    // The solver is the exact side: its errors are far below the photons'.
    for score in grid.rows.iter().flat_map(|row| &row.scores) {
        assert!(score.solved.std_error < 0.05 * score.std_error, "{:?}", score.solved);
    }
}

/// g = 0.855 where 0.85 is meant.
#[test]
fn an_asymmetry_off_by_half_a_per_cent_is_rejected() {
    let cases: Vec<Case> = design().into_iter().filter(|case| PHASES[case.phase] == "hg 0.85").collect();
    let budget = Budget { photons: 2e6, ..BUDGET };
    let wrong = Agreement::planted(cases, budget, |case| full(hg(0.855), OMEGA[case.omega]));
    let (row, worst) = wrong.worst();
    println!("largest |z| {:.1} at {} {:?}", worst.z.abs(), row.case.name(), worst.quantity);
    assert!(worst.z.abs() > wrong.threshold(ALPHA) && !wrong.chi_square_failures(ALPHA).is_empty());
}

/// ω = 0.905 where 0.9 is meant.
#[test]
fn an_albedo_off_by_half_a_per_cent_is_rejected() {
    let cases: Vec<Case> =
        design().into_iter().filter(|case| case.phase == 3 && OMEGA[case.omega] == 0.9).collect();
    let wrong = Agreement::planted(cases, Budget { photons: 2e6, ..BUDGET }, |_| full(hg(0.85), 0.905));
    let (row, worst) = wrong.worst();
    println!("largest |z| {:.1} at {} {:?}", worst.z.abs(), row.case.name(), worst.quantity);
    assert!(worst.z.abs() > wrong.threshold(ALPHA) && !wrong.chi_square_failures(ALPHA).is_empty());
}
