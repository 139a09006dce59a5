//! What rivals need of a number beyond the model's functions, and the integrals of exponentials over a slab.

use stratiform_model::Real;

/// A floating-point number with a square root.
pub trait Scalar: Real + Send + Sync + 'static {
    /// Square root, correctly rounded.
    fn sqrt(self) -> Self;
}

impl Scalar for f32 {
    fn sqrt(self) -> Self {
        f32::sqrt(self)
    }
}

impl Scalar for f64 {
    fn sqrt(self) -> Self {
        f64::sqrt(self)
    }
}

/// The smaller of two numbers.
pub(crate) fn least<F: Real>(a: F, b: F) -> F {
    if a < b { a } else { b }
}

/// The larger of two numbers.
pub(crate) fn most<F: Real>(a: F, b: F) -> F {
    if a < b { b } else { a }
}

/// (1 - e^{-x})/x for x ≥ 0, 1 at 0: the mean of e^{-t} over a path x. Its series serves x < 1.
pub(crate) fn mean_decay<F: Real>(x: F) -> F {
    let one = F::of(1.0);
    if x < one {
        // Σ (-x)^k/(k+1)!, from its far end.
        return (1..=F::TAIL_TERMS + 1).rev().fold(one, |sum, k| one - x / F::of(f64::from(k) + 1.0) * sum);
    }
    (one - (-x).exp()) / x
}

/// (E(a) - E(b))/(b - a) with E = [`mean_decay`], for a, b ≥ 0; ½ at 0. The second divided difference of
/// e^{-x} at 0, a, b. Series below 1, two terms of Taylor's where a and b are near.
pub(crate) fn second_mean<F: Real>(a: F, b: F) -> F {
    let one = F::of(1.0);
    let (low, high) = (least(a, b), most(a, b));
    if high < one {
        return second_series(low, high);
    }
    let (middle, apart) = (F::of(0.5) * (low + high), high - low);
    if apart > F::of(0.02) * middle {
        return (mean_decay(low) - mean_decay(high)) / apart;
    }
    let (m, decay) = (middle, (-middle).exp());
    let slope = (one - (one + m) * decay) / (m * m);
    let cubic =
        (F::of(6.0) - (((m + F::of(3.0)) * m + F::of(6.0)) * m + F::of(6.0)) * decay) / (m * m * m * m);
    slope + apart * apart / F::of(24.0) * cubic
}

/// Σ (-1)^n h_n(a,b)/(n+2)!, h_n the complete homogeneous polynomial.
fn second_series<F: Real>(a: F, b: F) -> F {
    let (mut sum, mut power, mut complete) = (F::of(0.5), F::of(1.0), F::of(1.0));
    let mut factor = F::of(0.5);
    for n in 1..=F::TAIL_TERMS + 2 {
        power = power * b;
        complete = a * complete + power;
        factor = -factor / F::of(f64::from(n) + 2.0);
        sum = sum + factor * complete;
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_branches_of_the_mean_meet() {
        assert!((mean_decay(1.0 - f64::EPSILON) / mean_decay(1.0) - 1.0).abs() < 1e-15);
        assert!((mean_decay(1.0 - f32::EPSILON) / mean_decay(1.0_f32) - 1.0).abs() < 1e-6);
        assert_eq!((mean_decay(0.0), mean_decay(1e300)), (1.0, 1e-300));
    }

    /// Every branch against the double integral ∫_0^1 ds ∫_0^s dt e^{-at-b(s-t)} by midpoints.
    #[test]
    fn the_second_mean_is_its_integral() {
        for (a, b) in
            [(0.0, 0.0), (0.3, 0.9), (0.99, 1.01), (2.0, 2.03), (2.0, 2.05), (5.0, 0.0), (30.0, 30.0)]
        {
            let n = 2000;
            let sum = (0..n).fold(0.0, |sum, i| {
                let s = (f64::from(i) + 0.5) / f64::from(n);
                let x = if a == b {
                    s * libm::exp(-a * s)
                } else {
                    (libm::exp(-a * s) - libm::exp(-b * s)) / (b - a)
                };
                sum + x / f64::from(n)
            });
            assert!((second_mean(a, b) / sum - 1.0).abs() < 1e-5, "{a} {b}");
            let single = f64::from(second_mean(a as f32, b as f32));
            assert!((single / second_mean(a, b) - 1.0).abs() < 1e-5, "{a} {b}: {single}");
        }
    }
}
