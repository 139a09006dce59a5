//! Pearson's χ² of counts against expected counts, with pooling of thin cells.

use special::Gamma;

/// Why counts cannot be compared.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ChiSquareError {
    /// The two lists differ in length.
    #[error("{observed} observed cells but {expected} expected ones")]
    Lengths {
        /// Cells observed.
        observed: usize,
        /// Cells expected.
        expected: usize,
    },
    /// An expected count is negative or not finite.
    #[error("expected count {value} of cell {cell} is outside [0, infinity)")]
    Expected {
        /// Cell, from 0.
        cell: usize,
        /// The refused value.
        value: f64,
    },
    /// Fewer than two cells are left after pooling: nothing is tested.
    #[error("{cells} cells are left after pooling, at least 2 are needed")]
    TooFewCells {
        /// Cells left.
        cells: usize,
    },
}

/// The outcome of a χ² test.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ChiSquare {
    /// Σ (observed - expected)²/expected over the pooled cells.
    pub statistic: f64,
    /// Pooled cells less one.
    pub degrees_of_freedom: usize,
    /// Probability of a larger statistic if the expected counts are right. A test that fails when this is
    /// below α raises a false alarm with probability α (to the χ² approximation's accuracy).
    pub p_value: f64,
}

/// Neighbouring cells are pooled until each expects at least this many (Cochran 1954).
pub const MIN_EXPECTED: f64 = 5.0;

/// Compares counts with expectations that sum to the same total (the total is not tested).
///
/// # Errors
/// [`ChiSquareError`] for unequal lengths, negative or non-finite expectations, or fewer than two pooled cells.
pub fn chi_square(observed: &[u64], expected: &[f64]) -> Result<ChiSquare, ChiSquareError> {
    if observed.len() != expected.len() {
        return Err(ChiSquareError::Lengths { observed: observed.len(), expected: expected.len() });
    }
    if let Some((cell, value)) = expected.iter().enumerate().find(|(_, e)| !(e.is_finite() && **e >= 0.0)) {
        return Err(ChiSquareError::Expected { cell, value: *value });
    }
    let cells = pool(observed, expected);
    if cells.len() < 2 {
        return Err(ChiSquareError::TooFewCells { cells: cells.len() });
    }
    let statistic = cells.iter().fold(0.0, |sum, (o, e)| sum + (o - e) * (o - e) / e);
    let degrees_of_freedom = cells.len() - 1;
    let p_value = 1.0 - (0.5 * statistic).inc_gamma(0.5 * degrees_of_freedom as f64);
    Ok(ChiSquare { statistic, degrees_of_freedom, p_value })
}

/// Merges neighbours until each cell expects [`MIN_EXPECTED`]; what is left over joins the last cell.
fn pool(observed: &[u64], expected: &[f64]) -> Vec<(f64, f64)> {
    let mut cells: Vec<(f64, f64)> = Vec::new();
    let mut open = (0.0, 0.0);
    for (o, e) in observed.iter().zip(expected) {
        open = (open.0 + *o as f64, open.1 + e);
        if open.1 >= MIN_EXPECTED {
            cells.push(open);
            open = (0.0, 0.0);
        }
    }
    match cells.last_mut() {
        Some(last) => *last = (last.0 + open.0, last.1 + open.1),
        None => cells.push(open),
    }
    cells
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Purpose, key, photon_stream};
    use rand::Rng;

    /// χ² = 3.84 with one degree of freedom is the 5 % point, 18.307 with ten (Abramowitz & Stegun 1964,
    /// table 26.8).
    #[test]
    fn p_values_are_the_tabulated_ones() {
        for (statistic, dof, p) in [(3.841_46_f64, 1.0, 0.05), (18.307, 10.0, 0.05), (2.705_54, 1.0, 0.1)] {
            assert!((1.0 - (0.5 * statistic).inc_gamma(0.5 * dof) - p).abs() < 1e-5);
        }
    }

    fn uniform_counts(seed: u64, cells: usize, draws: u64) -> Vec<u64> {
        let mut rng = photon_stream(key(seed, Purpose::Calibration), 0);
        let mut counts = vec![0; cells];
        for _ in 0..draws {
            counts[(rng.next_u32() as usize * cells) >> 32] += 1;
        }
        counts
    }

    /// 2000 true hypotheses at α = 0.01: 20 false alarms expected, 4.5 standard deviations are 20.
    #[test]
    fn the_false_alarm_rate_is_as_stated() {
        let expected = vec![100.0; 20];
        let alarms = (0..2000)
            .filter(|seed| chi_square(&uniform_counts(*seed, 20, 2000), &expected).unwrap().p_value < 0.01)
            .count();
        assert!((5..=40).contains(&alarms), "{alarms} alarms in 2000");
    }

    /// A slope of ±11 % gives non-centrality 89 on 19 degrees of freedom: missed at the 1e-3 point (43.8) less than
    /// once in 1000 seeds.
    #[test]
    fn a_planted_slope_is_rejected() {
        let n = 20_000.0;
        let expected: Vec<f64> =
            (0..20).map(|i| n / 20.0 * (1.0 + 0.11 * (f64::from(i) / 9.5 - 1.0))).collect();
        let flat = uniform_counts(7, 20, n as u64);
        assert!(chi_square(&flat, &expected).unwrap().p_value < 1e-3);
        assert!(chi_square(&flat, &[n / 20.0; 20]).unwrap().p_value > 1e-3);
    }

    #[test]
    fn thin_cells_are_pooled_and_meaningless_tests_refused() {
        let pooled = pool(&[1, 2, 3, 10], &[2.0, 2.0, 2.0, 10.0]);
        assert_eq!(pooled, vec![(6.0, 6.0), (10.0, 10.0)]);
        assert_eq!(pool(&[9, 1], &[9.0, 1.0]), vec![(10.0, 10.0)]);
        assert!(matches!(chi_square(&[1], &[1.0]), Err(ChiSquareError::TooFewCells { cells: 1 })));
        assert!(matches!(chi_square(&[1, 2], &[1.0]), Err(ChiSquareError::Lengths { .. })));
        assert!(matches!(
            chi_square(&[1, 2], &[1.0, f64::NAN]),
            Err(ChiSquareError::Expected { cell: 1, .. })
        ));
    }
}
