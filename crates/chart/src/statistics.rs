//! What a list of relative errors comes to.

/// Median, 95th percentile (nearest rank) and maximum of the magnitude, and the signed median.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Statistics {
    /// Median of |e|.
    pub median: f64,
    /// The smallest |e| that at least 95 % of all do not exceed.
    pub p95: f64,
    /// Largest |e|.
    pub worst: f64,
    /// Median of e.
    pub bias: f64,
}

impl Statistics {
    /// Of signed errors, all finite; `None` of none.
    pub fn of(errors: &[f64]) -> Option<Self> {
        let mut signed = errors.to_vec();
        signed.sort_by(f64::total_cmp);
        let mut sizes: Vec<f64> = errors.iter().map(|error| error.abs()).collect();
        sizes.sort_by(f64::total_cmp);
        let worst = *sizes.last()?;
        // ⌈0.95 n⌉ in whole numbers.
        let rank = (95 * sizes.len()).div_ceil(100);
        Some(Self { median: median(&sizes), p95: sizes[rank - 1], worst, bias: median(&signed) })
    }
}

/// Of sorted values: the middle one, or the mean of both.
fn median(sorted: &[f64]) -> f64 {
    let half = sorted.len() / 2;
    if sorted.len() % 2 == 1 { sorted[half] } else { 0.5 * (sorted[half - 1] + sorted[half]) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn of_known_lists() {
        // 1, -2, 3, … 19, -20: |e| = 1…20.
        let errors: Vec<f64> = (1..=20).map(|i| f64::from(if i % 2 == 0 { -i } else { i })).collect();
        let found = Statistics::of(&errors).unwrap();
        assert_eq!(found, Statistics { median: 10.5, p95: 19.0, worst: 20.0, bias: -0.5 });
        let one = Statistics::of(&[-0.25]).unwrap();
        assert_eq!(one, Statistics { median: 0.25, p95: 0.25, worst: 0.25, bias: -0.25 });
        assert_eq!(Statistics::of(&[]), None);
    }

    #[test]
    fn a_planted_bias_and_a_planted_outlier_show() {
        let noise = |i: i32| 0.01 * f64::from(i - 50) / 50.0;
        let clean: Vec<f64> = (0..=100).map(noise).collect();
        let biased: Vec<f64> = clean.iter().map(|e| e + 0.1).collect();
        let mut outlier = clean.clone();
        outlier[3] = -4.0;
        let [clean, biased, outlier] = [clean, biased, outlier].map(|list| Statistics::of(&list).unwrap());
        assert!(clean.bias.abs() < 1e-12 && (biased.bias - 0.1).abs() < 1e-12);
        assert!(outlier.worst == 4.0 && outlier.p95 < 0.011 && (outlier.median - clean.median).abs() < 1e-3);
    }
}
