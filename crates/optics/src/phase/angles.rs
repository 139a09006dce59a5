//! Θ of v = 1 - cosΘ for many v at once, without branches, so that lanes of a processor work side by side.
//!
//! Θ = 2 asin √(v/2) below 60°, π - 4 asin √((1-√(v/2))/2) above: the argument of the arcsine stays below ½ and 24 terms of its
//! Taylor series, Σ (2n)!/(4ⁿ n!² (2n+1)) x²ⁿ⁺¹, leave less than 1e-16. The same bits on every processor: nothing is fused.

use std::f64::consts::PI;

const TERMS: usize = 24;

/// (2n)!/(4ⁿ n!² (2n+1)).
const SERIES: [f64; TERMS] = {
    let mut series = [1.0; TERMS];
    let (mut n, mut binomial) = (1, 1.0);
    while n < TERMS {
        binomial *= (2 * n - 1) as f64 / (2 * n) as f64;
        series[n] = binomial / (2 * n + 1) as f64;
        n += 1;
    }
    series
};

/// Replaces each v ∈ \[0, 2\] by Θ in radians; what rounding puts outside is taken to the end.
#[multiversion::multiversion(targets("x86_64+avx512f+avx512dq+avx512vl", "x86_64+avx2"))]
pub(super) fn angles(v: &mut [f64]) {
    for v in v {
        // NaN stays NaN.
        let half = if *v < 0.0 { 0.0 } else { 0.5 * *v };
        let half = if half > 1.0 { 1.0 } else { half };
        let narrow = half <= 0.25;
        let square = if narrow { half } else { 0.5 * (1.0 - half.sqrt()) };
        // Two chains, side by side.
        let fourth = square * square;
        let (mut even, mut odd) = (SERIES[TERMS - 2], SERIES[TERMS - 1]);
        for n in (0..TERMS / 2 - 1).rev() {
            even = SERIES[2 * n] + fourth * even;
            odd = SERIES[2 * n + 1] + fourth * odd;
        }
        let arcsine = square.sqrt() * (even + square * odd);
        *v = if narrow { 2.0 * arcsine } else { PI - 4.0 * arcsine };
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::phase::angle;

    /// Against the library's arcsine, relative near 0 and at the seam; near 180° v itself does not know Θ better than 1e-8.
    #[test]
    fn angles_are_those_of_the_library() {
        let mut v: Vec<f64> = (0..=4000).map(|i| f64::from(i) / 2000.0).collect();
        v.extend((0..300).map(|i| libm::exp(-f64::from(i))));
        v.extend([0.5_f64.next_down(), 0.5_f64.next_up(), -1e-17, 2.0_f64.next_up()]);
        let mut found = v.clone();
        angles(&mut found);
        for (v, found) in v.iter().zip(&found) {
            let expected = angle(*v);
            assert!((found - expected).abs() <= 4.0 * f64::EPSILON * expected, "{v}: {found} {expected}");
        }
        let mut wrong = [f64::NAN];
        angles(&mut wrong);
        assert!(wrong[0].is_nan());
    }
}
