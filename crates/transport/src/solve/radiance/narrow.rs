//! Aureole and glory: light that only narrow events have turned, three times or more.
//!
//! Narrow is what the scaled medium's discrete ordinates do not hold: ε_l = (χ_l-f)/(1-f) for l ≥ L, 0 below, in a
//! forward part ε^f and a part ε^b of events by more than a right angle or so. Orders 1 and 2 of it are exact
//! elsewhere. Higher ones follow in the limit of small angles off the straight path (Goudsmit & Saunderson 1940):
//! - below, any number of forward events: moments τ'∫e^{-p}(e^{ap} - 1 - ap - (ap)²/2)/p ds, a = ω'ε_l, over paths p that run at
//!   the sun's slant for a part s of the slab and at the view's for the rest: p = (s/μ0 + (1-s)/μ)τ', one value if both are
//!   alike. ε_l tends to -f/(1-f), the forward δ, which is the unscattered beam's and is left out;
//! - above, one turn and any number of forward events on both ways: moments ω'ε^b_l ∫e^{-x}(e^{ax} - 1 - ax)dx, x = (1/μ+1/μ0)t
//!   from 0 to s = (1/μ+1/μ0)τ', a = ω'ε^f_l.
//!
//! It replaces IMS of Nakajima & Tanaka (1988) and vanishes as L grows: what it gets wrong shows up as a step between two
//! numbers of streams.

use super::panels::{Break, Rule};
use super::phase::Phase;
use super::scaled::Scaled;
use super::single::exit;
use super::view::Geometry;
use crate::solve::quadrature::legendre_row;
use std::f64::consts::PI;
use stratiform_quantities::Side;

/// Moments used.
pub(super) const MOMENTS: usize = 1024;

/// Last moments above this belong to a needle that they do not describe.
const NEEDLE: f64 = 1e-3;

/// Depth factors below this leave no light.
const DARK: f64 = 1e-30;

/// Relative difference below which two slants are one.
const ALIKE: f64 = 1e-9;

/// Paths longer than the shortest by this leave no light.
const LONGEST: f64 = 400.0;

/// Where events begin to count as turns, and where all do.
const TURN: (f64, f64) = (PI / 3.0, 2.0 * PI / 3.0);

/// Moments of a medium before scaling: all events, and turns.
#[derive(Clone, Debug)]
pub(super) struct Narrow {
    all: Vec<f64>,
    turns: Vec<f64>,
}

impl Narrow {
    pub(super) fn new(chi: Vec<f64>, phase: &Phase) -> Self {
        let known = chi.last().is_some_and(|last| last.abs() < NEEDLE);
        // Without moments worth the name there is nothing to correct.
        let all = if known { chi } else { Vec::new() };
        let mut turns = vec![0.0; all.len()];
        let mut row = vec![0.0; all.len()];
        Rule::new(12, PI / 180.0).visit(TURN.0, PI, &[], |theta, weight| {
            let (sine, cosine) = libm::sincos(theta);
            let share = smooth((theta - TURN.0) / (TURN.1 - TURN.0));
            let factor = 0.5 * weight * sine * share * phase.at(1.0 - cosine);
            legendre_row(cosine, &mut row);
            turns.iter_mut().zip(&row).for_each(|(sum, p)| *sum += factor * p);
        });
        Self { all, turns }
    }

    /// Orders 3 and above of narrow events, as πL/(μ0F0).
    pub(super) fn beyond_twice(&self, medium: &Scaled, tau: f64, geometry: &Geometry) -> f64 {
        let exit = exit(medium, tau, geometry);
        let depth = exit.once();
        if depth < DARK {
            return 0.0;
        }
        let path = exit.tau * (exit.sun + exit.view);
        let slant = Slant::new(exit.tau * exit.sun, exit.tau * exit.view);
        let moment: &dyn Fn(f64, f64) -> f64 = match geometry.side {
            Side::Top => &|all, turn| turn / path * turned(all - turn, path) * exit.tau,
            Side::Bottom => &|all, _| exit.tau * slant.beyond_second(all),
        };
        let scale = medium.albedo / (1.0 - medium.forward);
        let narrow = |all: f64, turn: f64| moment(scale * (all - medium.forward), scale * turn);
        let beam = narrow(0.0, 0.0);
        let resolved = medium.moments.len();
        let moments = self.all.iter().zip(&self.turns).enumerate();
        let moments =
            moments.map(|(l, (all, turn))| if l < resolved { -beam } else { narrow(*all, *turn) - beam });
        0.25 * exit.sun * exit.view * legendre_sum(moments, 1.0 - geometry.deflection())
    }
}

/// Paths between those of sun and view, with e^{-p}/p times their weight.
struct Slant {
    paths: Vec<(f64, f64)>,
}

impl Slant {
    fn new(sun: f64, view: f64) -> Self {
        let (least, most) = (sun.min(view), sun.max(view));
        let faded = |p: f64, weight: f64| (p, weight * libm::exp(-p) / p);
        let span = most - least;
        if span < ALIKE * least {
            return Self { paths: vec![faded(0.5 * (least + most), 1.0)] };
        }
        let mut paths = Vec::new();
        let shrink = [Break { at: least, least: 2.0 }];
        Rule::new(5, f64::INFINITY).visit(least, most.min(least + LONGEST), &shrink, |p, weight| {
            paths.push(faded(p, weight / span));
        });
        Self { paths }
    }

    /// ∫e^{-p}(e^{ap} - 1 - ap - (ap)²/2)/p ds, a ≤ 1.
    fn beyond_second(&self, a: f64) -> f64 {
        self.paths.iter().fold(0.0, |sum, &(p, weight)| sum + weight * beyond_second(a * p))
    }
}

/// 0 below 0, 1 above 1, with three continuous derivatives.
fn smooth(x: f64) -> f64 {
    let x = x.clamp(0.0, 1.0);
    x * x * x * x * (35.0 - x * (84.0 - x * (70.0 - 20.0 * x)))
}

/// ∫₀^s e^{-x}(e^{ax} - 1 - ax)dx.
fn turned(a: f64, s: f64) -> f64 {
    let through = |rate: f64| -libm::expm1(-rate * s) / rate;
    let rest = if s > 700.0 { 0.0 } else { s * libm::exp(-s) };
    through(1.0 - a) - through(1.0) * (1.0 + a) + a * rest
}

/// e^y - 1 - y - y²/2.
fn beyond_second(y: f64) -> f64 {
    if y.abs() < 0.1 {
        let term = y * y * y / 6.0;
        return term
            * (1.0 + y / 4.0 * (1.0 + y / 5.0 * (1.0 + y / 6.0 * (1.0 + y / 7.0 * (1.0 + y / 8.0)))));
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn turns_are_the_integral() {
        for (a, s) in [(0.3, 0.5), (-0.8, 4.0), (-0.2, 900.0), (1e-3, 2.0)] {
            let mut sum = 0.0;
            let f = |x: f64| libm::exp(-x) * (libm::exp(a * x) - 1.0 - a * x);
            Rule::new(12, 0.5).visit(0.0, f64::min(s, 60.0), &[], |x, weight| sum += weight * f(x));
            assert!((turned(a, s) - sum).abs() < 1e-13, "{a} {s}: {:e}", turned(a, s) - sum);
        }
    }

    #[test]
    fn both_forms_of_the_rest_meet() {
        for y in [-0.1, 0.1] {
            let (series, closed) = (beyond_second(0.999_999_999_9 * y), beyond_second(1.000_000_000_1 * y));
            assert!((series / closed - 1.0).abs() < 1e-9, "{y}");
        }
    }
}
