//! Integrals of exponentials over depth, as divided differences of exp: no cancellation where rates meet.
//!
//! Light that runs down or up with rates a = 1/μ leaves integrals ∫∫e^{-as}e^{-b(t-s)}e^{-c(τ-t)} over 0 < s < t < τ.
//! They are τ² exp\[-aτ, -bτ, -cτ\], the second divided difference of the exponential (Hermite–Genocchi), symmetric in
//! a, b, c and positive. With a the smallest, x ≤ y the excesses of the others and ψ(x) = (1-e^{-x})/x, it is
//! e^{-aτ}(ψ(x) - e^{-x}ψ(y-x))/y, and its power series below y = 1.

/// ψ(x) = (1 - e^{-x})/x = exp\[0, -x\].
pub(super) fn mean_exponential(x: f64) -> f64 {
    if x == 0.0 { 1.0 } else { -libm::expm1(-x) / x }
}

/// exp\[-a, -b\].
pub(super) fn first(a: f64, b: f64) -> f64 {
    libm::exp(-a.min(b)) * mean_exponential((a - b).abs())
}

/// exp\[-a, -b, -c\].
pub(super) fn second(a: f64, b: f64, c: f64) -> f64 {
    let (low, high) = (a.min(b), a.max(b));
    let (least, middle, most) = (low.min(c), low.max(high.min(c)), high.max(c));
    let (x, y) = (middle - least, most - least);
    let rest = if y < 1.0 {
        series(x, y)
    } else {
        (mean_exponential(x) - libm::exp(-x) * mean_exponential(y - x)) / y
    };
    libm::exp(-least) * rest
}

/// Σ(-1)ⁿh_n(x, y)/(n+2)!, h_n the complete homogeneous polynomials.
fn series(x: f64, y: f64) -> f64 {
    let (mut power, mut h, mut factor, mut sum) = (1.0, 1.0, 0.5, 0.0);
    for n in 0..20 {
        sum += factor * h;
        power *= x;
        h = y * h + power;
        factor /= -f64::from(n + 3);
    }
    sum
}

/// Where light leaves, and its depth integrals; λ, k, κ are 1/μ of sun, intermediate and view direction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Exit {
    pub(super) top: bool,
    pub(super) tau: f64,
    /// λ = 1/μ0.
    pub(super) sun: f64,
    /// κ = 1/μ.
    pub(super) view: f64,
}

impl Exit {
    /// ∫e^{-λt}·(way out of depth t) dt.
    pub(super) fn once(&self) -> f64 {
        let Self { top, tau, sun, view } = *self;
        tau * if top { mean_exponential((sun + view) * tau) } else { first(sun * tau, view * tau) }
    }

    /// The same with a way down at rate `k` between two depths.
    pub(super) fn via_down(&self, k: f64) -> f64 {
        let Self { top, tau, sun, view } = *self;
        let by = if top {
            second((sun + view) * tau, (k + view) * tau, 0.0)
        } else {
            second(sun * tau, k * tau, view * tau)
        };
        tau * tau * by
    }

    /// The same with a way up at rate `k` between two depths.
    pub(super) fn via_up(&self, k: f64) -> f64 {
        let Self { top, tau, sun, view } = *self;
        let by = if top {
            second((sun + view) * tau, (k + sun) * tau, 0.0)
        } else {
            second(sun * tau, (k + sun + view) * tau, view * tau)
        };
        tau * tau * by
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// ∫₀¹ds∫_s^1dt of the integrand, by the midpoint rule in both, extrapolated once.
    fn by_hand(a: f64, b: f64, c: f64) -> f64 {
        let rule = |n: u32| {
            let h = 1.0 / f64::from(n);
            let at = |i: u32| h * (f64::from(i) + 0.5);
            // Inner: from s to 1, mapped to the unit interval.
            (0..n).fold(0.0, |sum, i| {
                let s = at(i);
                (0..n).fold(sum, |sum, j| {
                    let t = s + (1.0 - s) * at(j);
                    sum + h * h * (1.0 - s) * libm::exp(-a * s - b * (t - s) - c * (1.0 - t))
                })
            })
        };
        (4.0 * rule(400) - rule(200)) / 3.0
    }

    #[test]
    fn divided_differences_are_the_integrals() {
        for (a, b, c) in [
            (0.0, 0.0, 0.0),
            (1.0, 1.0, 1.0),
            (0.3, 0.3, 5.0),
            (5.0, 5.0 + 1e-9, 0.0),
            (0.2, 1.1999, 1.2001),
            (0.0, 1e-7, 20.0),
            (3.0, 3.0 + 1e-12, 3.0 - 1e-12),
        ] {
            let (found, expected) = (second(a, b, c), by_hand(a, b, c));
            assert!((found / expected - 1.0).abs() < 1e-6, "{a} {b} {c}: {found} {expected}");
            assert_eq!(found, second(c, a, b));
        }
    }

    /// Both sides of the switch between series and closed form.
    #[test]
    fn the_forms_meet() {
        for x in [0.0, 0.3, 0.999_999_999] {
            let (below, above) = (second(0.0, x, 1.0 - 1e-13), second(0.0, x, 1.0 + 1e-13));
            assert!((below / above - 1.0).abs() < 1e-12, "{x}");
        }
    }

    #[test]
    fn extremes_are_finite() {
        for (a, b, c) in [(1e14, 1e10, 0.0), (1e14, 1e14, 1e14), (1e-12, 0.0, 1e-9), (0.0, 1e300, 1e300)] {
            let value = second(a, b, c);
            assert!(value.is_finite() && value >= 0.0, "{a} {b} {c}: {value}");
        }
    }
}
