//! Many tests at once, with one stated rate of false alarms for all of them together.

/// Which of several tests fail at family-wise rate `alpha`, by Holm's step-down (1979, Scand. J. Stat. 6, 65).
///
/// The smallest p-value is held against α/n, the next against α/(n-1), …, up to the first that passes. Whatever the
/// dependence of the tests, the probability of one or more false alarms is at most α; never fewer true errors are found
/// than by α/n for all.
///
/// Out-of-domain input (`alpha` outside (0, 1), a p-value outside \[0, 1\] or NaN) gives `None`.
pub fn holm(p_values: &[f64], alpha: f64) -> Option<Vec<bool>> {
    if !(alpha > 0.0 && alpha < 1.0) || p_values.iter().any(|p| !(0.0..=1.0).contains(p)) {
        return None;
    }
    let mut order: Vec<usize> = (0..p_values.len()).collect();
    order.sort_by(|&i, &j| p_values[i].total_cmp(&p_values[j]));
    let mut fails = vec![false; p_values.len()];
    for (rank, &i) in order.iter().enumerate() {
        if p_values[i] * (p_values.len() - rank) as f64 > alpha {
            break;
        }
        fails[i] = true;
    }
    Some(fails)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// α/4, α/3, α/2, α: the third fails to fail, so the fourth is not looked at.
    #[test]
    fn thresholds_step_down_to_the_first_that_passes() {
        let alpha = 0.06;
        assert_eq!(holm(&[0.9, 0.0149, 0.0199, 0.0301], alpha), Some(vec![false, true, true, false]));
        assert_eq!(holm(&[0.05, 0.0149, 0.0199, 0.0299], alpha), Some(vec![true; 4]));
        assert_eq!(holm(&[0.0151, 0.0152, 0.0153, 0.0154], alpha), Some(vec![false; 4]));
        assert_eq!(holm(&[], alpha), Some(vec![]));
    }

    #[test]
    fn nonsense_has_no_answer() {
        for (p, alpha) in
            [(0.5, 0.0), (0.5, 1.0), (0.5, f64::NAN), (-0.1, 0.05), (1.1, 0.05), (f64::NAN, 0.05)]
        {
            assert_eq!(holm(&[p], alpha), None);
        }
    }
}
