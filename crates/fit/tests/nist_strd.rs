//! The 27 nonlinear regression sets of NIST StRD, each from both certified starts, held to the certified
//! parameters and standard deviations.
//!
//! Agreement is counted in digits: the least of -log10 |relative error| over the parameters. Asked for: 6 (4
//! for the level "Higher"), and 4 for the standard deviations. `EXCEPTIONS` names what is held to less, with
//! the reason.
#![allow(clippy::unwrap_used, clippy::print_stdout, reason = "a test that prints what it measured")]

mod nist;

use nist::{Dataset, Fit};
use stratiform_fit::least_squares::{Bounds, Options, solve};

/// (dataset, start, digits of parameters, digits of standard deviations, reason).
const EXCEPTIONS: &[(&str, usize, f64, f64, &str)] = &[
    ("Lanczos1", 0, 6.0, 0.0, "its sum of squares, 1.4e-25, is rounding noise of the data and of the model"),
    ("Lanczos1", 1, 6.0, 0.0, "its sum of squares, 1.4e-25, is rounding noise of the data and of the model"),
];

fn digits(got: &[f64], certified: &[f64]) -> f64 {
    let digit = |(g, c): (&f64, &f64)| -libm::log10((g / c - 1.0).abs());
    got.iter()
        .zip(certified)
        .map(digit)
        .fold(11.0, |least, d| if d.is_nan() { f64::NEG_INFINITY } else { least.min(d) })
}

fn fit(dataset: &Dataset, start: usize) -> (f64, f64, String) {
    let bounds = Bounds::none(dataset.certified.len());
    let solution = solve(&Fit(dataset), &dataset.starts[start], &bounds, &Options::default()).unwrap();
    let errors = solution.scatter_errors().unwrap_or_else(|| vec![f64::NAN; dataset.certified.len()]);
    let stopped = format!("{} after {}", solution.outcome, solution.iterations);
    (digits(&solution.parameters, &dataset.certified), digits(&errors, &dataset.certified_errors), stopped)
}

#[test]
fn certified_values_are_met_from_both_starts() {
    let mut failures = Vec::new();
    let sets = nist::all();
    assert_eq!(sets.len(), 27);
    for set in &sets {
        for start in 0..2 {
            let (parameters, errors, stopped) = fit(set, start);
            let exception = EXCEPTIONS.iter().find(|e| e.0 == set.name && e.1 == start);
            let asked = if set.level == "Higher" { 4.0 } else { 6.0 };
            let (least, least_errors) = exception.map_or((asked, 4.0), |e| (e.2, e.3));
            println!(
                "{:10} {:8} start {}: {parameters:5.1} digits, std. dev. {errors:5.1}; {stopped}",
                set.name,
                set.level,
                start + 1
            );
            if parameters < least || errors < least_errors {
                failures.push(format!("{} start {}", set.name, start + 1));
            }
        }
    }
    assert!(failures.is_empty(), "too few digits: {failures:?}");
}

/// The comparison itself: a slip in the seventh digit is seen.
#[test]
fn digits_count_the_worst_parameter() {
    assert!((digits(&[1.0, 2.000_002], &[1.0, 2.0]) - 6.0).abs() < 1e-6);
    assert_eq!(digits(&[1.0, f64::NAN], &[1.0, 2.0]), f64::NEG_INFINITY);
    assert_eq!(digits(&[1.0], &[1.0]), 11.0);
}
