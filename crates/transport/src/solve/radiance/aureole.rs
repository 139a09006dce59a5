//! The aureole: light that only narrow events have turned, three times or more.
//!
//! Narrow is what the scaled medium's discrete ordinates do not hold: ε_l = (χ_l-f)/(1-f) for l ≥ 2n, 0 below. Orders 1
//! and 2 of it are exact elsewhere; in the limit of small angles all orders together are the moments e^y - 1 - y
//! - y²/2, y = ω'ε_lτ'/μ (Goudsmit & Saunderson 1940), on the depth factor of order 1. ε_l tends to ε_∞ =
//! -f/(1-f), the part of the forward δ, which is the unscattered beam's and is left out. It replaces IMS of Nakajima & Tanaka
//! (1988), and vanishes as n grows: what it gets wrong shows up as a step between two numbers of streams.

use super::scaled::Scaled;
use super::single::exit;
use super::view::{Geometry, Side};

/// Moments used.
pub(super) const MOMENTS: usize = 1024;

/// Last moments above this belong to a needle that they do not describe.
const NEEDLE: f64 = 1e-3;

/// Depth factors below this leave no light.
const DARK: f64 = 1e-30;

/// Orders 3 and above of narrow events, as πL/(μ0F0), for moments `chi` of the medium before scaling.
pub(super) fn aureole(medium: &Scaled, chi: &[f64], tau: f64, geometry: &Geometry) -> f64 {
    let exit = exit(medium, tau, geometry);
    let depth = exit.once();
    let known = chi.last().is_some_and(|last| last.abs() < NEEDLE);
    if geometry.side == Side::Top || depth < DARK || !known {
        return 0.0;
    }
    let path = 0.5 * exit.tau * (exit.sun + exit.view);
    let narrow = |chi: f64| beyond_second(medium.albedo * (chi - medium.forward) / (1.0 - medium.forward) * path);
    let (resolved, beam) = (medium.moments.len(), narrow(0.0));
    let moments = chi.iter().enumerate().map(|(l, chi)| if l < resolved { -beam } else { narrow(*chi) - beam });
    0.25 * exit.sun * exit.view * depth * legendre_sum(moments, 1.0 - geometry.deflection()) / path
}

/// e^y - 1 - y - y²/2.
fn beyond_second(y: f64) -> f64 {
    if y.abs() < 0.1 {
        let term = y * y * y / 6.0;
        return term * (1.0 + y / 4.0 * (1.0 + y / 5.0 * (1.0 + y / 6.0 * (1.0 + y / 7.0 * (1.0 + y / 8.0)))));
    }
    libm::expm1(y) - y - 0.5 * y * y
}

/// Σ(2l+1)a_l P_l(x).
fn legendre_sum(moments: impl Iterator<Item = f64>, x: f64) -> f64 {
    let (mut before, mut value, mut sum) = (0.0, 1.0, 0.0);
    for (l, moment) in moments.enumerate() {
        let (l, odd) = (l as f64, (2 * l + 1) as f64);
        sum += odd * moment * value;
        (before, value) = (value, (odd * x * value - l * before) / (l + 1.0));
    }
    sum
}
