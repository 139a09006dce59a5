//! The exponential integral E_3(x) = ∫_1^∞ e^{-xs}/s³ ds: 2 E_3(τ) is the unscattered share of hemispheric light.
//!
//! Abramowitz & Stegun 1964: for x < 1 the recurrence 5.1.14 on the series 5.1.11 of E_1, beyond it the
//! continued fraction 5.1.22 (even part), evaluated from its far end. Relative error a few ε.

use crate::{Real, brackets::rise};

const EULER_GAMMA: f64 = 0.577_215_664_901_532_9;

/// E_3(x) for x ≥ 0.
pub fn exponential_integral_e3<F: Real>(x: F) -> F {
    let (one, half) = (F::of(1.0), F::of(0.5));
    if x < one { half * ((one - x) * (-x).exp() + square_times_e1(x)) } else { far(x) }
}

/// 1 - 2 E_3(x), the share of hemispheric light that is extinguished, without cancellation at small x.
pub(crate) fn diffuse_rise<F: Real>(x: F) -> F {
    let (one, two) = (F::of(1.0), F::of(2.0));
    if x < one { rise(x) + (x * (-x).exp() - square_times_e1(x)) } else { one - two * far(x) }
}

/// x² E_1(x) for 0 ≤ x ≤ 1.
fn square_times_e1<F: Real>(x: F) -> F {
    if x <= F::of(0.0) {
        return F::of(0.0);
    }
    // Σ_{k≥1} -(-x)^k/(k k!), from its far end: term k is -x (k-1)/k² times term k-1.
    let sum = (2..=F::E1_TERMS).rev().fold(F::of(1.0), |sum, k| {
        let k = f64::from(k);
        F::of(1.0) - x * F::of((k - 1.0) / (k * k)) * sum
    });
    x * x * (x * sum - F::of(EULER_GAMMA) - x.ln())
}

/// E_3(x) for x ≥ 1: e^{-x}/(x+3 - 1·3/(x+5 - 2·4/(x+7 - …))).
fn far<F: Real>(x: F) -> F {
    let start = x + F::of(f64::from(2 * F::E3_DEPTH + 3));
    let fraction = (1..=F::E3_DEPTH).rev().fold(start, |below, k| {
        let k = f64::from(k);
        x + F::of(2.0 * k + 1.0) - F::of(k * (k + 2.0)) / below
    });
    (-x).exp() / fraction
}
