//! Solver and photons, the two sources of a fit, held against each other through the whole chain.

#![allow(clippy::unwrap_used, reason = "a test may stop where it fails")]

use stratiform_cli::pipeline::fluxes::nodes;
use stratiform_cli::pipeline::reference::Media;
use stratiform_cli::pipeline::solved::solve;
use stratiform_fit::{Reference, compare, fit};
use stratiform_tests::{accepted_cloud, fresh_reference, paper_config};

/// Probability that agreeing sources fail.
const FALSE_ALARM_RATE: f64 = 1e-4;

/// Parameters from solved fluxes and from 250 000 photons per incidence agree within both errors; a forward fraction 3 %
/// off, which moves the orders, does not.
#[test]
fn both_sources_give_the_same_parameters() {
    let config = paper_config();
    let (table, cloud) = accepted_cloud(&config);
    let media = Media::new(&config, &cloud).unwrap();
    let solved = solve(&config, &media, &cloud.tau(&config), &nodes(&config)).unwrap();
    let solved: Vec<Reference> = solved.into_iter().map(|one| one.reference).collect();
    let traced = fresh_reference(&config, &cloud, 250_000, 11);
    let fitted =
        |list: &[Reference]| fit(&config.fit, list, table.medium.clone(), table.provenance.clone()).unwrap();
    let (from_solver, from_photons) = (fitted(&solved), fitted(&traced));
    let comparison = compare(&from_solver, &from_photons, FALSE_ALARM_RATE).unwrap();
    assert!(comparison.deviations.len() > 50, "guard against checking nothing");
    assert!(comparison.agrees(), "{:#?}", comparison.differing().collect::<Vec<_>>());

    let mut planted = config.clone();
    planted.optics.theta_f_deg = 5.3;
    let media = Media::new(&planted, &cloud).unwrap();
    let other = solve(&planted, &media, &cloud.tau(&config), &nodes(&config)).unwrap();
    let other: Vec<Reference> = other.into_iter().map(|one| one.reference).collect();
    assert!(!compare(&fitted(&other), &from_photons, FALSE_ALARM_RATE).unwrap().agrees());
}

/// The claimed errors of parameters fitted to solved fluxes bound what a tighter tolerance changes.
#[test]
fn claimed_errors_of_solved_parameters_hold() {
    let mut config = paper_config();
    let (table, cloud) = accepted_cloud(&config);
    let media = Media::new(&config, &cloud).unwrap();
    let mut at = |tolerance| {
        config.transport.tolerance = tolerance;
        let solved = solve(&config, &media, &cloud.tau(&config), &nodes(&config)).unwrap();
        let list: Vec<Reference> = solved.into_iter().map(|one| one.reference).collect();
        fit(&config.fit, &list, table.medium.clone(), table.provenance.clone()).unwrap()
    };
    let (coarse, fine) = (at(1e-5), at(1e-7));
    let mut compared = 0;
    for (coarse, fine) in coarse.optical.rows.iter().zip(&fine.optical.rows) {
        for (a, b) in [(coarse.b, fine.b), (coarse.kappa_c, fine.kappa_c), (coarse.t, fine.t)] {
            let (claimed, moved) = (a.std_error.unwrap(), (a.value.unwrap() - b.value.unwrap()).abs());
            assert!(moved <= claimed + b.std_error.unwrap(), "{}: {moved} > {claimed}", coarse.theta_l_deg);
            compared += 1;
        }
    }
    assert_eq!(compared, 33, "guard against checking nothing");
}
