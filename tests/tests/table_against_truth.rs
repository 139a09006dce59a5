//! The committed table against fresh photons.

#![allow(clippy::unwrap_used, reason = "a test may stop where it fails")]

use stratiform_fit::{compare, fit, regression};
use stratiform_tests::{accepted_cloud, fresh_reference, paper_config};

/// The table passes the bounds of its config, and a slip of 2 % in t does not, at whichever angle it is.
#[test]
fn the_table_agrees_and_a_slip_of_two_percent_in_t_does_not() {
    let config = paper_config();
    let (table, cloud) = accepted_cloud(&config);
    let gate = &config.regression;
    let fresh = fresh_reference(&config, &cloud, gate.photons, gate.seed);
    let hold =
        |table: &_| regression(table, &config.fit, &fresh, &gate.bounds, gate.false_alarm_rate).unwrap();

    let verdict = hold(&table);
    assert!(verdict.held.len() > 1000, "guard against checking nothing");
    assert!(verdict.failures().is_empty(), "{:#?}", verdict.failures());

    for angle in 0..9 {
        for slip in [0.98, 1.02] {
            let mut planted = table.clone();
            let t = &mut planted.optical.rows[angle].t;
            t.value = t.value.map(|value| value * slip);
            t.emitted *= slip;
            let verdict = hold(&planted);
            let found = verdict.failures();
            assert!(!found.is_empty(), "a slip of {slip} at row {angle} went unseen");
            let row = planted.optical.rows[angle].theta_l_deg.to_string();
            assert!(found.iter().all(|held| held.theta_l_deg == row), "{found:#?}");
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
