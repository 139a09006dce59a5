//! Integrals of exponentials over depth, as divided differences of exp: no cancellation where rates meet.
//!
//! Light that runs down or up with rates a = 1/μ leaves integrals ∫∫e^{-as}e^{-b(t-s)}e^{-c(τ-t)} over 0 < s < t < τ.
//! They are τ² exp\[-aτ, -bτ, -cτ\], the second divided difference of the exponential (Hermite–Genocchi), symmetric in
//! a, b, c and positive. With a the smallest, x ≤ y the excesses of the others and ψ(x) = (1-e^{-x})/x, it is
//! e^{-aτ}(ψ(x) - e^{-x}ψ(y-x))/y, and its power series below y = ¼. All without branches, for lanes.

use super::elementary::{exponentials, mean_exponential, more_than_0};

/// Below this difference of rates the power series stands in.
const CLOSE: f64 = 0.25;

/// (-1)ⁿ/(n+2)!; the next term is below 1e-17.
const SERIES: [f64; 11] = {
    let mut series = [0.5; 11];
    let mut n = 1;
    while n < series.len() {
        series[n] = -series[n - 1] / (n + 2) as f64;
        n += 1;
    }
    series
};

/// exp\[-a, -b\].
pub(super) fn first(a: f64, b: f64) -> f64 {
    exponentials(-a.min(b)).0 * mean_exponential((a - b).abs()).0
}

/// exp\[-a, -b, -c\].
#[inline(always)]
pub(super) fn second(a: f64, b: f64, c: f64) -> f64 {
    let (low, high) = ordered(a, b);
    let (low, least) = {
        let (least, other) = ordered(low, c);
        (other, least)
    };
    let (middle, most) = ordered(low, high);
    exponentials(-least).0 * second_from_0(middle - least, most - least)
}

/// exp\[0, -x, -y\], x ≤ y.
#[inline(always)]
fn second_from_0(x: f64, y: f64) -> f64 {
    let (near, rest) = (more_than_0(x), more_than_0(y - x));
    let ((faded, less), (_, less_again)) = (exponentials(-near), exponentials(-rest));
    // Quotients are slow: one for all.
    let apart = (faded * less_again * near - less * rest) / (near * rest * y);
    if y < CLOSE { series(x, y) } else { apart }
}

#[inline(always)]
fn ordered(a: f64, b: f64) -> (f64, f64) {
    if a < b { (a, b) } else { (b, a) }
}

/// Σ(-1)ⁿh_n(x, y)/(n+2)!, h_n the complete homogeneous polynomials.
#[inline(always)]
fn series(x: f64, y: f64) -> f64 {
    let (mut power, mut h, mut sum) = (1.0, 1.0, 0.0);
    for factor in SERIES {
        sum += factor * h;
        power *= x;
        h = y * h + power;
    }
    sum
}

/// Two of the three rates of a path of two events, with τ, and what is added to the third.
#[derive(Clone, Copy)]
struct Legs {
    a: f64,
    c: f64,
    more: f64,
    tau: f64,
}

impl Legs {
    /// τ² exp\[-a, -(rate+more)τ, -c\].
    #[inline(always)]
    fn second(&self, rate: f64) -> f64 {
        self.tau * self.tau * second(self.a, (rate + self.more) * self.tau, self.c)
    }

    /// The same with c = 0.
    #[inline(always)]
    fn second_from_0(&self, rate: f64) -> f64 {
        let (x, y) = ordered(self.a, (rate + self.more) * self.tau);
        self.tau * self.tau * second_from_0(x, y)
    }
}

/// Replaces each rate by its integral.
#[multiversion::multiversion(targets("x86_64+avx512f+avx512dq+avx512vl", "x86_64+avx2"))]
fn second_each(legs: &Legs, rates: &mut [f64]) {
    if legs.c == 0.0 {
        rates.iter_mut().for_each(|rate| *rate = legs.second_from_0(*rate));
    } else {
        rates.iter_mut().for_each(|rate| *rate = legs.second(*rate));
    }
}

/// Replaces each rate, which stands twice, by both integrals: side by side they take little longer than one.
#[multiversion::multiversion(targets("x86_64+avx512f+avx512dq+avx512vl", "x86_64+avx2"))]
fn second_both([one, other]: &[Legs; 2], ones: &mut [f64], others: &mut [f64]) {
    let pairs = ones.iter_mut().zip(others);
    if one.c == 0.0 && other.c == 0.0 {
        pairs.for_each(|(a, b)| (*a, *b) = (one.second_from_0(*a), other.second_from_0(*b)));
    } else {
        pairs.for_each(|(a, b)| (*a, *b) = (one.second(*a), other.second(*b)));
    }
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
        tau * if top { mean_exponential((sun + view) * tau).0 } else { first(sun * tau, view * tau) }
    }

    /// Of a way down, and of a way up, between two depths.
    fn legs(&self) -> [Legs; 2] {
        let Self { top, tau, sun, view } = *self;
        if top {
            [view, sun].map(|more| Legs { a: (sun + view) * tau, c: 0.0, more, tau })
        } else {
            [0.0, sun + view].map(|more| Legs { a: sun * tau, c: view * tau, more, tau })
        }
    }

    /// ∫∫ with a way down at each rate between two depths; takes the rates' place.
    pub(super) fn via_down(&self, rates: &mut [f64]) {
        second_each(&self.legs()[0], rates);
    }

    /// The same with a way up.
    pub(super) fn via_up(&self, rates: &mut [f64]) {
        second_each(&self.legs()[1], rates);
    }

    /// Both ways at each rate.
    pub(super) fn via(&self, rates: &[f64]) -> Vias {
        let mut vias = Vias { down: rates.to_vec(), up: rates.to_vec() };
        second_both(&self.legs(), &mut vias.down, &mut vias.up);
        vias
    }
}

/// Depth integrals of ways down and up between two depths.
pub(super) struct Vias {
    pub(super) down: Vec<f64>,
    pub(super) up: Vec<f64>,
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
        for x in [0.0, 0.1, 0.249_999_999] {
            let (below, above) = (second(0.0, x, CLOSE - 1e-13), second(0.0, x, CLOSE + 1e-13));
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
