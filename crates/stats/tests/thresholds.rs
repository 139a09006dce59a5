//! Every comparator rejects an error just above its threshold, accepts one just below, ignores what it must ignore, and
//! refuses what it cannot judge.

#![allow(clippy::unwrap_used, reason = "a test may stop where it fails")]

use stratiform_stats::{
    ChiSquareError, Estimate, KolmogorovSmirnovError, chi_square, chi_square_two_sample, family_threshold,
    kolmogorov_smirnov, kolmogorov_smirnov_two_sample, z_score,
};

#[test]
fn z_at_its_threshold() {
    let threshold = family_threshold(1e-3, 40).unwrap();
    let reference = Estimate { value: 0.3, std_error: 3e-4 };
    for sign in [1.0, -1.0] {
        let off = |errors: f64| {
            let value = Estimate { value: 0.3 + sign * errors * 5e-4, std_error: 4e-4 };
            z_score(value, reference).abs() > threshold
        };
        assert!(off(threshold + 1e-6) && !off(threshold - 1e-6));
    }
}

/// 36.191 is the 1 % point of χ² with 19 degrees of freedom (Abramowitz & Stegun 1964, table 26.8). Moving k of 100 counts
/// from one cell to another gives k²/50.
#[test]
fn chi_square_at_its_threshold() {
    let expected = [100.0; 20];
    let moved = |k: u64| {
        let mut counts = [100; 20];
        (counts[3], counts[8]) = (100 - k, 100 + k);
        chi_square(&counts, &expected).unwrap()
    };
    let (below, above) = (moved(42), moved(43));
    assert!(below.statistic < 36.191 && below.p_value > 0.01, "{below:?}");
    assert!(above.statistic > 36.191 && above.p_value < 0.01, "{above:?}");
}

/// 21.666 is the 1 % point with 9 degrees of freedom. The sum of both histograms is kept: k moves from a to b in one cell and
/// back in another.
#[test]
fn two_sample_chi_square_at_its_threshold() {
    let moved = |k: u64| {
        let (mut a, mut b) = ([1000; 10], [500; 10]);
        (a[2], a[5], b[2], b[5]) = (1000 + k, 1000 - k, 500 - k, 500 + k);
        chi_square_two_sample(&a, &b).unwrap()
    };
    let k = (0..100).find(|k| moved(*k).statistic > 21.666).unwrap();
    let (below, above) = (moved(k - 1), moved(k));
    assert!(below.degrees_of_freedom == 9 && below.p_value > 0.01 && above.p_value < 0.01);
    // By hand: (k/√2 + √2 k)²/1500 twice.
    let by_hand = 2.0 * 4.5 * (k * k) as f64 / 1500.0;
    assert!((above.statistic / by_hand - 1.0).abs() < 1e-12, "{above:?} {by_hand}");
}

/// Values (i-1)/n + d, cut at 1: their distance from the uniform distribution is d. Miller's 5 % point at n = 20.
#[test]
fn kolmogorov_smirnov_at_its_threshold() {
    let point = 0.29408;
    let p_value = |d: f64| {
        let sample: Vec<f64> = (0..20).map(|i| (f64::from(i) / 20.0 + d).min(1.0)).collect();
        let result = kolmogorov_smirnov(&sample, |x| x).unwrap();
        assert!((result.statistic - d).abs() < 1e-15);
        result.p_value
    };
    assert!(p_value(point + 1e-5) < 0.05 && p_value(point - 1e-5) > 0.05);
}

/// Two combs of 50, k apart: the distance is k/50. P(D ≥ 13/50) = 0.0678, P(D ≥ 14/50) = 0.0392 (Gnedenko & Korolyuk 1951).
#[test]
fn two_sample_kolmogorov_smirnov_at_its_threshold() {
    let comb = |from: f64| -> Vec<f64> { (0..50).map(|i| f64::from(i) + from).collect() };
    let p_value = |k: f64| kolmogorov_smirnov_two_sample(&comb(0.0), &comb(k - 0.5)).unwrap().p_value;
    assert!((p_value(13.0) - 0.0678).abs() < 5e-5 && (p_value(14.0) - 0.0392).abs() < 5e-5);
    assert!(p_value(13.0) > 0.05 && p_value(14.0) < 0.05);
}

#[test]
fn order_scale_and_empty_tails_are_ignored() {
    let a: Vec<f64> = (0..40).map(|i| libm::sin(f64::from(i * i))).collect();
    let b: Vec<f64> = (0..30).map(|i| libm::cos(f64::from(i * i + 1))).collect();
    let turned = |values: &[f64]| -> Vec<f64> { values.iter().rev().copied().collect() };
    let scaled = |values: &[f64]| -> Vec<f64> { values.iter().map(|x| libm::exp(3.0 * x) + 7.0).collect() };
    let two = kolmogorov_smirnov_two_sample(&a, &b).unwrap();
    assert_eq!(kolmogorov_smirnov_two_sample(&turned(&a), &b).unwrap(), two);
    assert_eq!(kolmogorov_smirnov_two_sample(&scaled(&a), &scaled(&b)).unwrap(), two);
    let swapped = kolmogorov_smirnov_two_sample(&b, &a).unwrap();
    assert!(swapped.statistic == two.statistic && (swapped.p_value / two.p_value - 1.0).abs() < 1e-12);
    let cdf = |x: f64| 0.5 + 0.5 * x;
    assert_eq!(kolmogorov_smirnov(&turned(&a), cdf).unwrap(), kolmogorov_smirnov(&a, cdf).unwrap());

    let (counts, others) = ([30, 50, 80, 20], [300, 420, 900, 260]);
    let plain = chi_square_two_sample(&counts, &others).unwrap();
    let tail = |counts: &[u64]| [&[0, 0], counts, &[0, 0, 0]].concat();
    assert_eq!(chi_square_two_sample(&tail(&counts), &tail(&others)).unwrap(), plain);
    let swapped = chi_square_two_sample(&others, &counts).unwrap();
    assert!((swapped.p_value - plain.p_value).abs() < 1e-12);
    let (turned, others) = ([20, 80, 50, 30], [260, 900, 420, 300]);
    assert!((chi_square_two_sample(&turned, &others).unwrap().p_value - plain.p_value).abs() < 1e-12);
}

/// Equal shares of different totals, and a sample against itself.
#[test]
fn equals_are_accepted() {
    let same = chi_square_two_sample(&[10, 20, 30], &[100, 200, 300]).unwrap();
    assert!(same.statistic < 1e-12 && same.p_value > 1.0 - 1e-12);
    let a = [0.3, 0.1, 0.1, f64::INFINITY];
    let same = kolmogorov_smirnov_two_sample(&a, &a).unwrap();
    assert_eq!((same.statistic, same.p_value), (0.0, 1.0));
    // A tie between the samples is compared after both.
    assert_eq!(kolmogorov_smirnov_two_sample(&[1.0, 2.0], &[2.0, 1.0]).unwrap().statistic, 0.0);
}

#[test]
fn what_cannot_be_judged_is_refused() {
    assert_eq!(kolmogorov_smirnov(&[], |x| x), Err(KolmogorovSmirnovError::Empty));
    assert_eq!(kolmogorov_smirnov_two_sample(&[1.0], &[]), Err(KolmogorovSmirnovError::Empty));
    assert_eq!(
        kolmogorov_smirnov_two_sample(&[1.0, f64::NAN], &[1.0]),
        Err(KolmogorovSmirnovError::NotANumber { index: 1 })
    );
    for cdf in [|x: f64| 2.0 * x, |x: f64| 1.0 - x, |_: f64| f64::NAN, |x: f64| x - 1.0] {
        let refused = kolmogorov_smirnov(&[0.2, 0.9], cdf);
        assert!(matches!(refused, Err(KolmogorovSmirnovError::Distribution { .. })), "{refused:?}");
    }
    assert!(matches!(chi_square_two_sample(&[9, 9], &[9]), Err(ChiSquareError::Lengths { .. })));
    for empty in [chi_square_two_sample(&[9, 9], &[0, 0]), chi_square_two_sample(&[], &[])] {
        assert!(matches!(empty, Err(ChiSquareError::TooFewCells { .. })), "{empty:?}");
    }
}
