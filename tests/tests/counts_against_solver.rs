//! The stored photon counts against the deterministic solver: two methods that share nothing but the cloud.

#![allow(clippy::unwrap_used, reason = "a test may stop where it fails")]

use stratiform_cli::check::counts::{CountRow, read};
use stratiform_cli::pipeline::fluxes::{light, nodes};
use stratiform_cli::pipeline::reference::Media;
use stratiform_quantities::{Medium, Order};
use stratiform_stats::{Estimate, Hits, p_value_of_share};
use stratiform_tests::{accepted_cloud, paper_config};
use stratiform_transport::solve::Solver;

/// Probability that a correct tracer fails.
const FALSE_ALARM_RATE: f64 = 1e-6;

/// Hits and what the solver expects, by row of the table.
fn pairs(rows: &[CountRow], medium: Medium, tolerance: f64) -> Vec<(String, Hits, Estimate)> {
    let config = paper_config();
    let (_, cloud) = accepted_cloud(&config);
    let media = Media::new(&config, &cloud).unwrap();
    let (incidences, tau) = (nodes(&config), &config.check.tracer.as_ref().unwrap().tau);
    let lights: Vec<_> = incidences.iter().map(|row| light(row).unwrap()).collect();
    let solver = Solver::new(media.get(medium).into(), tolerance).unwrap();
    let solved = solver.orders(tau, &lights, 2).unwrap();
    let mut pairs = Vec::new();
    for row in rows.iter().filter(|row| row.medium == medium) {
        let i = incidences.iter().position(|incidence| *incidence == row.theta_l_deg).unwrap();
        let k = tau.iter().position(|tau| *tau == row.tau).unwrap();
        let n = solved.orders().iter().position(|order| *order == row.order).unwrap();
        let (reflectance, transmittance) = solved.estimate(i, k, n);
        let place = format!("{medium} {} tau {} order {}", row.theta_l_deg, row.tau, row.order);
        let hits = |hits| Hits { hits, trials: row.photons };
        if row.order != Order::Exactly(0) {
            pairs.push((format!("{place} reflected"), hits(row.reflected), reflectance));
        }
        pairs.push((format!("{place} transmitted"), hits(row.transmitted), transmittance));
    }
    pairs
}

/// The p-value with the solver's error given away.
fn p_value(hits: Hits, truth: Estimate) -> f64 {
    let nearest = hits.share().clamp(truth.value - truth.std_error, truth.value + truth.std_error);
    p_value_of_share(hits, nearest.clamp(0.0, 1.0)).unwrap()
}

#[test]
fn every_stored_count_is_what_the_solver_expects() {
    let rows = read(&stratiform_reference_data::root().join("paper-cloud-counts/counts.csv")).unwrap();
    let photons = paper_config().check.tracer.unwrap().stored_photons;
    assert!(rows.iter().all(|row| row.photons == photons), "the config says how they were made");
    let mut all = pairs(&rows, Medium::Full, 1e-5);
    all.extend(pairs(&rows, Medium::Modified, 1e-5));
    assert_eq!(all.len(), rows.len() / 4 * 7, "every row is compared");
    assert!(rows.len() >= 2 * 11 * 8 * 4, "guard against checking nothing");
    let alpha = FALSE_ALARM_RATE / all.len() as f64;
    let off: Vec<_> = all.iter().filter(|(_, hits, truth)| p_value(*hits, *truth) < alpha).collect();
    assert!(off.is_empty(), "{off:#?}");

    // Planted: each expectation off by eight standard errors of its count and twice the solver's error is rejected.
    for (place, hits, truth) in
        all.iter().filter(|(_, hits, _)| (1000..hits.trials - 1000).contains(&hits.hits))
    {
        let p = hits.share();
        let far = 8.0 * (p * (1.0 - p) / hits.trials as f64).sqrt() + 2.0 * truth.std_error;
        for value in [p - far, p + far] {
            let planted = Estimate { value, ..*truth };
            assert!(p_value(*hits, planted) < alpha, "{place}: {planted:?} for {hits:?}");
        }
    }
}
