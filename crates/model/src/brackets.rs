//! The three brackets of the model, free of cancellation for every y ≥ 0.
//!
//! With q(y) = 2 (e^y - 1 - y)/y², whose series converges fast for |y| ≤ 1:
//!
//! ```text
//! rise(y)        = 1 - e^-y         = y - y²/2 q(-y)
//! twice_back(y)  = y - 1 + e^-y     = y²/2 q(-y)
//! once_each(y)   = 1 - (1+y) e^-y   = y²/2 q(y) e^-y
//! ```
//!
//! The left-hand sides serve y ≥ 1, where they lose nothing. The emitted shaders have the same branch, and below
//! it a polynomial of fixed degree through values at Chebyshev's points.

use crate::Real;

/// q(y) = 2 (e^y - 1 - y)/y² for |y| ≤ 1, by Horner's scheme.
fn exp_tail<F: Real>(y: F) -> F {
    let one = F::of(1.0);
    (1..=F::TAIL_TERMS).rev().fold(one, |sum, k| one + y / F::of(f64::from(k) + 2.0) * sum)
}

/// 1 - e^{-y}.
pub(crate) fn rise<F: Real>(y: F) -> F {
    let one = F::of(1.0);
    if y < one { y * mean_decay(y) } else { one - (-y).exp() }
}

/// (1 - e^{-y})/y, the mean of e^{-yu} over u from 0 to 1, for y < 1.
pub(crate) fn mean_decay<F: Real>(y: F) -> F {
    F::of(1.0) - F::of(0.5) * y * exp_tail(-y)
}

/// (1 - (1+y)e^{-y})/y, the mean of yu e^{-yu}, for y < 1.
pub(crate) fn mean_decay_weighted<F: Real>(y: F) -> F {
    F::of(0.5) * y * exp_tail(y) * (-y).exp()
}

/// y - 1 + e^{-y}: scattered backward twice.
pub(crate) fn twice_back<F: Real>(y: F) -> F {
    let one = F::of(1.0);
    if y < one { F::of(0.5) * y * y * exp_tail(-y) } else { (y - one) + (-y).exp() }
}

/// 1 - (1+y)e^{-y}: scattered once backward and once forward.
pub(crate) fn once_each<F: Real>(y: F) -> F {
    let one = F::of(1.0);
    let decay = (-y).exp();
    if y < one { F::of(0.5) * y * y * exp_tail(y) * decay } else { one - (one + y) * decay }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_branches_meet_at_one() {
        let below = 1.0 - f64::EPSILON;
        for bracket in [rise::<f64>, twice_back, once_each] {
            assert!((bracket(below) / bracket(1.0) - 1.0).abs() < 2e-15);
        }
        for bracket in [rise::<f32>, twice_back, once_each] {
            assert!((bracket(1.0 - f32::EPSILON) / bracket(1.0) - 1.0).abs() < 1e-6);
        }
    }

    #[test]
    fn the_leading_terms_survive_in_single_precision() {
        let y = 1e-8_f32;
        assert!((rise(y) / y - 1.0).abs() < 1e-6);
        assert!((twice_back(y) / (0.5 * y * y) - 1.0).abs() < 1e-6);
        assert!((once_each(y) / (0.5 * y * y) - 1.0).abs() < 1e-6);
    }
}
