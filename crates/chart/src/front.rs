//! The Pareto front of cost and error: what nothing else beats.

/// Which of the `(cost, error)` pairs no other dominates: is better in one and no worse in the other. Pairs that tie in both
/// stand on the front together; pairs with a value that is not finite never do.
pub fn front(pairs: &[(f64, f64)]) -> Vec<bool> {
    let finite = |pair: &(f64, f64)| pair.0.is_finite() && pair.1.is_finite();
    let dominates = |a: &(f64, f64), b: &(f64, f64)| a.0 <= b.0 && a.1 <= b.1 && a != b;
    pairs
        .iter()
        .map(|pair| finite(pair) && !pairs.iter().any(|other| finite(other) && dominates(other, pair)))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn dominated_pairs_are_not_on_the_front() {
        let pairs = [(1.0, 0.5), (2.0, 0.2), (3.0, 0.3), (4.0, 0.1), (5.0, 0.1), (1.0, 0.6)];
        assert_eq!(front(&pairs), [true, true, false, true, false, false]);
    }

    #[test]
    fn ties_stand_together() {
        assert_eq!(front(&[(1.0, 1.0), (1.0, 1.0), (1.0, 2.0)]), [true, true, false]);
        assert_eq!(front(&[(1.0, 1.0)]), [true]);
        assert!(front(&[]).is_empty());
    }

    #[test]
    fn what_is_no_number_is_never_on_it_and_beats_nothing() {
        assert_eq!(front(&[(f64::NAN, 0.0), (1.0, f64::INFINITY), (2.0, 0.5)]), [false, false, true]);
    }
}
