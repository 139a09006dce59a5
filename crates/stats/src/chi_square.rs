//! Pearson's χ² of counts against expected counts or other counts, with pooling of thin cells.

use special::Gamma;

/// Why counts cannot be compared.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ChiSquareError {
    /// The two lists differ in length.
    #[error("{observed} cells cannot be compared with {expected}")]
    Lengths {
        /// Cells observed, or of the first histogram.
        observed: usize,
        /// Cells expected, or of the second histogram.
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
    same_length(observed.len(), expected.len())?;
    if let Some((cell, value)) = expected.iter().enumerate().find(|(_, e)| !(e.is_finite() && **e >= 0.0)) {
        return Err(ChiSquareError::Expected { cell, value: *value });
    }
    let cells = pool(observed.iter().zip(expected).map(|(o, e)| [*o as f64, *e]), |[_, e]| e);
    outcome(&cells, |[o, e]| (o - e) * (o - e) / e)
}

/// Compares two histograms of independent draws: whether both come from one distribution. Their totals A and B may differ
/// and are not tested.
///
/// χ² = Σ (√(B/A) a - √(A/B) b)²/(a + b) (Pearson 1911, Biometrika 8, 250). A cell is pooled until the smaller histogram
/// expects [`MIN_EXPECTED`] of the joint distribution, so empty tails change nothing.
///
/// # Errors
/// [`ChiSquareError`] for unequal lengths, or fewer than two pooled cells (an empty histogram has none).
pub fn chi_square_two_sample(a: &[u64], b: &[u64]) -> Result<ChiSquare, ChiSquareError> {
    same_length(a.len(), b.len())?;
    let [total_a, total_b] = [a, b].map(|counts| counts.iter().fold(0.0, |sum, count| sum + *count as f64));
    let smaller_share = total_a.min(total_b) / (total_a + total_b).max(1.0);
    let counts = a.iter().zip(b).map(|(a, b)| [*a as f64, *b as f64]);
    let cells = pool(counts, |[a, b]| (a + b) * smaller_share);
    let weight = (total_b / total_a).sqrt();
    outcome(&cells, |[a, b]| {
        let difference = weight * a - b / weight;
        difference * difference / (a + b)
    })
}

fn same_length(observed: usize, expected: usize) -> Result<(), ChiSquareError> {
    if observed == expected { Ok(()) } else { Err(ChiSquareError::Lengths { observed, expected }) }
}

/// Sums the cells' parts of χ².
fn outcome(cells: &[[f64; 2]], part: impl Fn([f64; 2]) -> f64) -> Result<ChiSquare, ChiSquareError> {
    if cells.len() < 2 {
        return Err(ChiSquareError::TooFewCells { cells: cells.len() });
    }
    let statistic = cells.iter().fold(0.0, |sum, cell| sum + part(*cell));
    let degrees_of_freedom = cells.len() - 1;
    // Far in the tail the difference is rounding.
    let p_value = (1.0 - (0.5 * statistic).inc_gamma(0.5 * degrees_of_freedom as f64)).max(0.0);
    Ok(ChiSquare { statistic, degrees_of_freedom, p_value })
}

/// Merges neighbours until each cell expects [`MIN_EXPECTED`]; what is left over joins the last cell.
fn pool(counts: impl Iterator<Item = [f64; 2]>, expected: impl Fn([f64; 2]) -> f64) -> Vec<[f64; 2]> {
    let mut cells: Vec<[f64; 2]> = Vec::new();
    let mut open = [0.0; 2];
    for [a, b] in counts {
        open = [open[0] + a, open[1] + b];
        if expected(open) >= MIN_EXPECTED {
            cells.push(open);
            open = [0.0; 2];
        }
    }
    match cells.last_mut() {
        Some(last) => *last = [last[0] + open[0], last[1] + open[1]],
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
        let pooled = |cells: &[[f64; 2]]| pool(cells.iter().copied(), |[_, e]| e);
        assert_eq!(
            pooled(&[[1.0, 2.0], [2.0, 2.0], [3.0, 2.0], [10.0, 10.0]]),
            vec![[6.0, 6.0], [10.0, 10.0]]
        );
        assert_eq!(pooled(&[[9.0, 9.0], [1.0, 1.0]]), vec![[10.0, 10.0]]);
        assert!(matches!(chi_square(&[1], &[1.0]), Err(ChiSquareError::TooFewCells { cells: 1 })));
        assert!(matches!(chi_square(&[1, 2], &[1.0]), Err(ChiSquareError::Lengths { .. })));
        assert!(matches!(
            chi_square(&[1, 2], &[1.0, f64::NAN]),
            Err(ChiSquareError::Expected { cell: 1, .. })
        ));
    }
}
