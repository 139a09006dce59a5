//! The committed table against the deterministic truth, and against fresh photons.

#![allow(clippy::unwrap_used, reason = "a test may stop where it fails")]

use stratiform_cli::check::model::ModelTruth;
use stratiform_cli::pipeline::reference::Media;
use stratiform_fit::{compare, fit};
use stratiform_tests::{accepted_cloud, fresh_reference, paper_config};

/// The table passes the bounds of its config, and a slip of 2 % in t does not, at whichever angle it is.
#[test]
fn the_table_agrees_and_a_slip_of_two_percent_in_t_does_not() {
    let config = paper_config();
    let (table, cloud) = accepted_cloud(&config);
    let truth = ModelTruth::solve(&config, &cloud, &Media::new(&config, &cloud).unwrap()).unwrap();
    let hold = |table: &_| {
        let mut held = truth.compare(&config, table).unwrap();
        let compared = held.len();
        held.retain(|one| !one.passes());
        (held, compared)
    };

    let (failures, compared) = hold(&table);
    assert!(compared > 1500, "guard against checking nothing");
    assert!(failures.is_empty(), "{failures:#?}");

    for angle in 0..9 {
        for slip in [0.98, 1.02] {
            let mut planted = table.clone();
            let row = &mut planted.optical.rows[angle];
            row.t.value = row.t.value.map(|value| value * slip);
            row.t.emitted *= slip;
            let incidence = row.theta_l_deg.clone();
            let (found, _) = hold(&planted);
            let parameter = found.iter().find(|held| held.quantity == "parameter t");
            assert_eq!(parameter.unwrap().place.theta_l_deg, incidence, "a slip of {slip} at row {angle}");
        }
    }
}

/// A fresh fit's parameters differ from the committed ones by no more than both standard errors explain. False-alarm
/// rate 1e-4; the planted change is one of five standard errors beyond the threshold.
#[test]
fn a_fresh_reproduction_agrees_with_the_committed_parameters() {
    const FALSE_ALARM_RATE: f64 = 1e-4;
    let config = paper_config();
    let (table, cloud) = accepted_cloud(&config);
    let fresh = fresh_reference(&config, &cloud, 50_000, 7);
    let refit = fit(&config.fit, &fresh, table.medium.clone(), table.provenance.clone()).unwrap();
    let comparison = compare(&table, &refit, FALSE_ALARM_RATE).unwrap();
    assert!(comparison.deviations.len() > 50, "guard against checking nothing");
    assert!(comparison.agrees(), "{:#?}", comparison.differing().collect::<Vec<_>>());

    let mut planted = refit.clone();
    let kappa_c = &mut planted.optical.rows[3].kappa_c;
    let far = (comparison.threshold + 5.0) * kappa_c.std_error.unwrap();
    kappa_c.value = kappa_c.value.map(|value| value + far);
    assert!(!compare(&table, &planted, FALSE_ALARM_RATE).unwrap().agrees());
}
