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

use super::elementary::{exponentials, mean_exponential};
use super::interpolant::Interpolant;
use super::panels::{Break, Rule};
use super::phase::Phase;
use super::scaled::Scaled;
use super::single::exit;
use super::view::Geometry;
use crate::solve::matrix::dot;
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
        Rule::new(12).visit([TURN.0, PI], PI / 180.0, &[], |theta, weight| {
            let (sine, cosine) = libm::sincos(theta);
            let share = smooth((theta - TURN.0) / (TURN.1 - TURN.0));
            let factor = 0.5 * weight * sine * share * phase.at(1.0 - cosine);
            legendre_row(cosine, &mut row);
            turns.iter_mut().zip(&row).for_each(|(sum, p)| *sum += factor * p);
        });
        Self { all, turns }
    }

    /// (2l+1)P_l between sun and view, for every moment: what [`beyond_twice`](Self::beyond_twice) asks for.
    pub(super) fn waves(&self, geometry: &Geometry) -> Vec<f64> {
        let mut row = vec![0.0; self.all.len()];
        legendre_row(1.0 - geometry.deflection(), &mut row);
        row.iter_mut().enumerate().for_each(|(l, p)| *p *= (2 * l + 1) as f64);
        row
    }

    /// Orders 3 and above of narrow events, as πL/(μ0F0).
    pub(super) fn beyond_twice(&self, medium: &Scaled, tau: f64, geometry: &Geometry, waves: &[f64]) -> f64 {
        let exit = exit(medium, tau, geometry);
        let resolved = medium.moments.len();
        if exit.once() < DARK || self.all.len() <= resolved {
            return 0.0;
        }
        let scale = medium.albedo / (1.0 - medium.forward);
        // The last is the unscattered beam's.
        let narrow = |chi: &[f64], less: f64| -> Vec<f64> {
            let mut moments = Vec::with_capacity(chi.len() - resolved + 1);
            moments.extend(chi[resolved..].iter().map(|chi| scale * (chi - less)));
            moments.push(-scale * less);
            moments
        };
        let mut moments = narrow(&self.all, medium.forward);
        match geometry.side {
            Side::Top => {
                let path = exit.tau * (exit.sun + exit.view);
                turned_each(&mut moments, &narrow(&self.turns, 0.0), path);
                moments.iter_mut().for_each(|moment| *moment *= exit.tau / path);
            }
            Side::Bottom => {
                Slant::new(exit.tau * exit.sun, exit.tau * exit.view).beyond_second(&mut moments);
                moments.iter_mut().for_each(|moment| *moment *= exit.tau);
            }
        }
        let beam = moments.pop().unwrap_or_default();
        let (low, high) = waves.split_at(resolved);
        moments.iter_mut().for_each(|moment| *moment -= beam);
        0.25 * exit.sun * exit.view * (dot(high, &moments) - beam * low.iter().sum::<f64>())
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
        Rule::new(5).visit([least, most.min(least + LONGEST)], f64::INFINITY, &shrink, |p, weight| {
            paths.push(faded(p, weight / span));
        });
        Self { paths }
    }

    /// ∫e^{-p}(e^{ap} - 1 - ap - (ap)²/2)/p ds for each a ≤ 1; takes their place. With paths of any length its singularity is at 1.
    fn beyond_second(&self, a: &mut [f64]) {
        match Interpolant::new(a, 1.0) {
            Some(interpolant) => interpolant.evaluate(&self.integrals(&interpolant.points()), a),
            None => a.copy_from_slice(&self.integrals(a)),
        }
    }

    fn integrals(&self, a: &[f64]) -> Vec<f64> {
        let mut sums = vec![0.0; a.len()];
        self.paths.iter().for_each(|&(p, weight)| add_beyond_second(&mut sums, weight, a, p));
        sums
    }
}

#[multiversion::multiversion(targets("x86_64+avx512f+avx512dq+avx512vl", "x86_64+avx2"))]
fn add_beyond_second(sums: &mut [f64], weight: f64, a: &[f64], p: f64) {
    for (sum, a) in sums.iter_mut().zip(a) {
        *sum += weight * beyond_second(a * p);
    }
}

/// 0 below 0, 1 above 1, with three continuous derivatives.
fn smooth(x: f64) -> f64 {
    let x = x.clamp(0.0, 1.0);
    x * x * x * x * (35.0 - x * (84.0 - x * (70.0 - 20.0 * x)))
}

/// t∫₀^s e^{-x}(e^{ax} - 1 - ax)dx with a = `all` - t, for each moment; takes the place of `all`.
#[multiversion::multiversion(targets("x86_64+avx512f+avx512dq+avx512vl", "x86_64+avx2"))]
fn turned_each(all: &mut [f64], turns: &[f64], s: f64) {
    for (all, turn) in all.iter_mut().zip(turns) {
        *all = turn * turned(*all - turn, s);
    }
}

/// ∫₀^s e^{-x}(e^{ax} - 1 - ax)dx.
#[inline(always)]
fn turned(a: f64, s: f64) -> f64 {
    let through = |rate: f64| s * mean_exponential(rate * s).0;
    let (straight, faded) = exponentials(-s);
    through(1.0 - a) + faded * (1.0 + a) + a * s * straight
}

/// e^y - 1 - y - y²/2.
#[inline(always)]
fn beyond_second(y: f64) -> f64 {
    let term = y * y * y / 6.0;
    let close =
        term * (1.0 + y / 4.0 * (1.0 + y / 5.0 * (1.0 + y / 6.0 * (1.0 + y / 7.0 * (1.0 + y / 8.0)))));
    if y.abs() < 0.1 { close } else { exponentials(y).1 - y - 0.5 * y * y }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn turns_are_the_integral() {
        for (a, s) in [(0.3, 0.5), (-0.8, 4.0), (-0.2, 900.0), (1e-3, 2.0)] {
            let mut sum = 0.0;
            let f = |x: f64| libm::exp(-x) * (libm::exp(a * x) - 1.0 - a * x);
            Rule::new(12).visit([0.0, f64::min(s, 60.0)], 0.5, &[], |x, weight| sum += weight * f(x));
            assert!((turned(a, s) - sum).abs() < 1e-13, "{a} {s}: {:e}", turned(a, s) - sum);
        }
    }

    /// As many moments as a cloud's aureole has, and the few that are integrated one by one.
    #[test]
    fn interpolated_moments_are_the_integrals() {
        let a: Vec<f64> = (0..200).map(|l| -1.2 + 1.2 * libm::exp(-0.03 * f64::from(l))).collect();
        for (sun, view) in [(0.2, 0.9), (3.0, 3.0), (5.0, 90.0), (30.0, 31.0)] {
            let slant = Slant::new(sun, view);
            let (mut found, expected) = (a.clone(), slant.integrals(&a));
            slant.beyond_second(&mut found);
            let off = found.iter().zip(&expected).fold(0.0_f64, |off, (f, e)| off.max((f - e).abs()));
            assert!(off > 0.0 && off < 1e-15, "{sun} {view}: {off:e}");
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
