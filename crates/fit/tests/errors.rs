//! Propagated errors against the scatter of repeated fits, and the comparison of two fits.
#![allow(clippy::unwrap_used, clippy::print_stdout, reason = "a test that prints what it measured")]

mod support;

use stratiform_artifact::{FittedParameter, ParametersDocument};
use stratiform_fit::{Reference, compare};
use support::{ANGLES, config, noisy, references, run};

const SPREAD: f64 = 2e-4;

/// Every parameter with its error: β, then row by row.
fn parameters(document: &ParametersDocument) -> Vec<FittedParameter> {
    let beta = document.optical.beta;
    let first =
        FittedParameter { value: Some(beta.value), std_error: Some(beta.std_error), emitted: beta.value };
    let rows = document.optical.rows.iter().flat_map(|r| [r.b, r.c, r.kappa_c, r.t, r.r]);
    std::iter::once(first).chain(rows).collect()
}

fn replicate(references: &[Reference], seed: u64) -> ParametersDocument {
    let disturbed: Vec<_> =
        references.iter().zip(0..).map(|(r, i)| noisy(r, SPREAD, seed * 100 + i)).collect();
    run(&config(&ANGLES), &disturbed).unwrap()
}

/// The χ²/n beyond which lies a standard normal's tail beyond z (Wilson & Hilferty 1931).
fn chi_square_bound(n: f64, z: f64) -> f64 {
    let cube_root = 1.0 - 2.0 / (9.0 * n) + z * (2.0 / (9.0 * n)).sqrt();
    cube_root * cube_root * cube_root
}

/// 31 ratios of scatter to propagated variance over 300 replicates, each within its 99.9 % interval: correct
/// errors fail for at most 3 % of seeds. Errors 20 % off are refused.
#[test]
fn errors_are_those_of_repeated_fits() {
    const REPLICATES: u64 = 300;
    let references = references(0.02, SPREAD);
    let centre = parameters(&run(&config(&ANGLES), &references).unwrap());
    let mut squares = vec![0.0; centre.len()];
    for seed in 0..REPLICATES {
        for ((square, p), c) in squares.iter_mut().zip(parameters(&replicate(&references, seed))).zip(&centre)
        {
            *square += (p.emitted - c.emitted) * (p.emitted - c.emitted);
        }
    }
    let n = REPLICATES as f64;
    let (low, high) = (chi_square_bound(n, -3.29), chi_square_bound(n, 3.29));
    for (i, (square, c)) in squares.iter().zip(&centre).enumerate() {
        let error = c.std_error.expect("every parameter is free");
        let ratio = square / n / (error * error);
        println!("parameter {i}: {:.3e} +- {error:.2e}, variance ratio {ratio:.3}", c.emitted);
        assert!((low..high).contains(&ratio), "parameter {i}: {ratio} outside {low}..{high}");
        for slip in [0.8, 1.2] {
            assert!(!(low..high).contains(&(1.0 / (slip * slip))), "a slip of {slip} passes");
        }
    }
}

#[test]
fn two_fits_agree_unless_one_is_wrong() {
    let references = references(0.02, SPREAD);
    let (a, b) = (replicate(&references, 1001), replicate(&references, 1002));
    let rate = 1e-4;
    let comparison = compare(&a, &b, rate).unwrap();
    assert_eq!(comparison.deviations.len(), 31);
    assert!(comparison.agrees(), "{:?}", comparison.differing().collect::<Vec<_>>());
    assert!(compare(&a, &a, rate).unwrap().deviations.iter().all(|d| d.z == 0.0));
    for row in 0..a.optical.rows.len() {
        let mut wrong = b.clone();
        let t = &mut wrong.optical.rows[row].t;
        let error = t.std_error.unwrap();
        t.value =
            a.optical.rows[row].t.value.map(|v| v + 1.02 * comparison.threshold * 2.0_f64.sqrt() * error);
        let comparison = compare(&a, &wrong, rate).unwrap();
        let differing: Vec<_> =
            comparison.differing().map(|d| (d.theta_l_deg.as_str(), d.parameter)).collect();
        assert_eq!(differing, [(a.optical.rows[row].theta_l_deg.to_string().as_str(), "t")]);
    }
    let mut without = b.clone();
    without.optical.rows[2].c.value = None;
    assert_eq!(compare(&a, &without, rate).unwrap().deviations.len(), 29);
    without.optical.rows.pop();
    assert!(compare(&a, &without, rate).is_err());
    assert!(compare(&a, &b, 0.0).is_err());
}
