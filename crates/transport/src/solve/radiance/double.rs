//! Light scattered twice, with the full phase function.
//!
//! (ω²/16π μ0) ∫dΩ' P(Ω0·Ω') P(Ω'·Ω) κk'K(k'), k' = 1/|μ'|: the depth integral K is closed (`depth`) and
//! depends on Ω' only through μ', so that the product of phase functions is integrated over azimuth once and
//! serves every thickness and every scaled medium. Panels shrink towards sun and view direction in zenith
//! angle and azimuth down to the width of the peak, towards the horizon (a kink), and, where P jumps at θ_f,
//! end on the circles round both directions at which it does.
//!
//! In a scaled medium P'' = (P - fδ)/(1-f): the δ parts are closed forms too. The error is the
//! difference of Gauss rules.

use super::depth::Exit;
use super::elementary::sine_cosine;
use super::panels::{Break, Rule};
use super::phase::Phase;
use super::scaled::Scaled;
use super::single::exit;
use super::view::Geometry;
use crate::solve::matrix::dot;
use std::f64::consts::{FRAC_PI_2, PI};
use stratiform_quantities::Side;

/// Points per panel: a rule is held against the two before.
pub(super) const POINTS: [usize; 8] = [2, 3, 4, 6, 9, 14, 21, 32];

/// Widest panel of a phase function with a peak: a rainbow is resolved.
const WIDEST: f64 = PI / 9.0;

/// The same of one without.
const WIDEST_SMOOTH: f64 = PI / 4.0;

/// Half-widths below this make a peak.
const PEAK: f64 = 0.2;

/// Width of the panels at the horizon.
const HORIZON: f64 = 1e-2;

/// Sums side by side.
const LANES: usize = 8;

/// Panels at the edge of a hole in P, in units of θ_f.
const EDGE: f64 = 0.05;

/// The product of phase functions for one sun and view, by one rule: intermediate directions down and up.
#[derive(Clone, Debug)]
pub(super) struct Pairing {
    down: Nodes,
    up: Nodes,
}

/// Intermediate cosines: their rates 1/|μ'|, and ∫P·P over azimuth with the weight and the rate.
#[derive(Clone, Debug, Default)]
struct Nodes {
    rates: Vec<f64>,
    weights: Vec<f64>,
}

impl Nodes {
    fn push(&mut self, rate: f64, weight: f64) {
        self.rates.push(rate);
        self.weights.push(weight * rate);
    }

    /// Fills up a processor's lanes with nodes that weigh nothing.
    fn fill(&mut self) {
        let full = self.rates.len().next_multiple_of(LANES);
        self.rates.resize(full, 1.0);
        self.weights.resize(full, 0.0);
    }

    /// Σ weight · depth integral, which `via` puts in the place of rates.
    fn sum(&self, via: impl Fn(&mut [f64])) -> f64 {
        let mut integrals = self.rates.clone();
        via(&mut integrals);
        dot(&self.weights, &integrals)
    }
}

/// The zenith angle and azimuth of a peak.
#[derive(Clone, Copy)]
struct Peak {
    theta: f64,
    sine: f64,
    phi: f64,
    width: f64,
}

impl Peak {
    fn new(theta: f64, phi: f64, width: f64) -> Self {
        Self { theta, sine: libm::sin(theta), phi, width }
    }
}

impl Pairing {
    pub(super) fn new(phase: &Phase, geometry: &Geometry, points: usize) -> Self {
        let rule = Rule::new(points);
        let (sun, view) = (libm::acos(geometry.mu0), geometry.travel());
        let ends = [(sun, 0.0), (view, geometry.phi)];
        let mut peaks: Vec<Peak> =
            ends.iter().map(|&(theta, phi)| Peak::new(theta, phi, phase.peak)).collect();
        if let Some(width) = phase.back {
            peaks.extend(ends.iter().map(|&(theta, phi)| Peak::new(PI - theta, phi + PI, width)));
        }
        let (mut down, mut up, mut circle) = (Nodes::default(), Nodes::default(), Circle::default());
        let widest = widest(phase);
        rule.visit([0.0, PI], widest, &across(&peaks, phase.edge), |theta, weight| {
            let (sine, cosine) = libm::sincos(theta);
            let product = circle.around(phase, (rule, widest), &peaks, (theta, sine));
            let nodes = if cosine > 0.0 { &mut down } else { &mut up };
            nodes.push(1.0 / cosine.abs(), weight * sine * product);
        });
        down.fill();
        up.fill();
        Self { down, up }
    }

    /// Radiance of order 2, δ parts left out.
    pub(super) fn twice(&self, medium: &Scaled, phase: &Phase, tau: f64, geometry: &Geometry) -> f64 {
        let exit = exit(medium, tau, geometry);
        let pairs = self.down.sum(|rates| exit.via_down(rates)) + self.up.sum(|rates| exit.via_up(rates));
        let peaks = if medium.forward == 0.0 { 0.0 } else { forward(&exit, phase, geometry) };
        let scale = medium.albedo / (1.0 - medium.forward);
        scale * scale * exit.sun * exit.view * (pairs / (16.0 * PI) - 0.25 * medium.forward * peaks)
    }
}

/// Widest panel: two waves of a series, but no less than a quarter of what resolves a rainbow.
fn widest(phase: &Phase) -> f64 {
    let plain = if phase.peak < PEAK || phase.edge.is_some() { WIDEST } else { WIDEST_SMOOTH };
    phase.waves.map_or(plain, |wave| plain.min((2.0 * wave).max(0.25 * WIDEST)))
}

/// One of the two events forward: Ω' = Ω0 or Ω' = Ω.
fn forward(exit: &Exit, phase: &Phase, geometry: &Geometry) -> f64 {
    let [sun, view] = [exit.sun, exit.view].map(|rate| exit.via(&[rate]));
    let late = if geometry.side == Side::Top { view.up[0] } else { view.down[0] };
    phase.at(geometry.deflection()) * (exit.sun * sun.down[0] + exit.view * late)
}

/// Where panels in zenith angle end.
fn across(peaks: &[Peak], edge: Option<f64>) -> Vec<Break> {
    let mut breaks = vec![Break { at: FRAC_PI_2, least: HORIZON }];
    for peak in peaks {
        breaks.push(Break { at: peak.theta, least: peak.width });
        if let Some(edge) = edge {
            let least = EDGE * edge;
            breaks.extend([-edge, edge].map(|off| Break { at: peak.theta + off, least }));
        }
    }
    breaks
}

/// Directions of one zenith angle.
#[derive(Default)]
struct Circle {
    rings: Vec<Ring>,
    breaks: Vec<Break>,
    azimuths: Vec<f64>,
    weights: Vec<f64>,
    from_sun: Vec<f64>,
    to_view: Vec<f64>,
}

impl Circle {
    /// ∫P(Θ1)P(Θ2)dφ' at zenith angle `theta`, given with its sine.
    fn around(
        &mut self,
        phase: &Phase,
        (rule, widest): (Rule, f64),
        peaks: &[Peak],
        theta: (f64, f64),
    ) -> f64 {
        let view = peaks[1].phi;
        // Sun and view in one plane: both halves are alike.
        let symmetric = view == 0.0 || view == PI;
        let end = if symmetric { PI } else { 2.0 * PI };
        self.rings.clear();
        self.rings.extend(peaks.iter().map(|peak| Ring::new(peak, theta)));
        let widest = widest_around(widest, peaks, theta.1);
        self.break_around(phase, peaks, [-widest, end + widest]);
        self.azimuths.clear();
        self.weights.clear();
        rule.visit([0.0, end], widest, &self.breaks, |phi, weight| {
            self.azimuths.push(phi);
            self.weights.push(weight);
        });
        self.from_sun.resize(self.azimuths.len(), 0.0);
        self.to_view.resize(self.azimuths.len(), 0.0);
        let rings = [&self.rings[0], &self.rings[1]];
        deflections(&self.azimuths, rings, view, [&mut self.from_sun, &mut self.to_view]);
        phase.at_each(&mut self.from_sun);
        phase.at_each(&mut self.to_view);
        let sum = weighted_product(&self.weights, &self.from_sun, &self.to_view);
        if symmetric { 2.0 * sum } else { sum }
    }

    /// Where panels in azimuth end, between `first` and `last`.
    fn break_around(&mut self, phase: &Phase, peaks: &[Peak], [first, last]: [f64; 2]) {
        let Self { rings, breaks, .. } = self;
        breaks.clear();
        for (peak, ring) in peaks.iter().zip(rings) {
            let mut near = |phi: f64, least: f64| {
                let turns = [-2.0 * PI, 0.0, 2.0 * PI].map(|turn| Break { at: phi + turn, least });
                breaks.extend(turns.into_iter().filter(|turn| turn.at >= first && turn.at <= last));
            };
            near(peak.phi, peak.width.max(ring.distance) / ring.radius.sqrt());
            if let Some(phi) = phase.edge.and_then(|edge| ring.crossing(edge)) {
                near(peak.phi + phi, f64::INFINITY);
                near(peak.phi - phi, f64::INFINITY);
            }
        }
    }
}

/// 1 - cosΘ from the first ring's direction, at azimuth 0, and from the second's, at `view`.
#[multiversion::multiversion(targets("x86_64+avx512f+avx512dq+avx512vl", "x86_64+avx2"))]
fn deflections(azimuths: &[f64], rings: [&Ring; 2], view: f64, found: [&mut [f64]; 2]) {
    let (view_sine, view_cosine) = libm::sincos(0.5 * view);
    let [from_sun, to_view] = found;
    for ((phi, from_sun), to_view) in azimuths.iter().zip(from_sun).zip(to_view) {
        let (sine, cosine) = sine_cosine(0.5 * phi);
        *from_sun = rings[0].deflection(sine);
        *to_view = rings[1].deflection(sine * view_cosine - cosine * view_sine);
    }
}

/// Σ abc in lanes.
#[multiversion::multiversion(targets("x86_64+avx512f+avx512dq+avx512vl", "x86_64+avx2"))]
fn weighted_product(a: &[f64], b: &[f64], c: &[f64]) -> f64 {
    let mut lanes = [0.0; LANES];
    for ((a, b), c) in a.chunks(LANES).zip(b.chunks(LANES)).zip(c.chunks(LANES)) {
        for (lane, ((a, b), c)) in lanes.iter_mut().zip(a.iter().zip(b).zip(c)) {
            *lane += a * b * c;
        }
    }
    lanes.iter().sum()
}

/// A circle of zenith angle θ' as seen from a direction of zenith angle θ.
struct Ring {
    /// 2 sin²((θ-θ')/2).
    across: f64,
    /// sinθ sinθ'.
    radius: f64,
    /// |θ-θ'|.
    distance: f64,
}

impl Ring {
    /// The circle of `theta` and its sine, from a peak's direction.
    fn new(peak: &Peak, (theta, sine): (f64, f64)) -> Self {
        let off = peak.theta - theta;
        let half = libm::sin(0.5 * off);
        let radius = (peak.sine * sine).max(0.0);
        Self { across: 2.0 * half * half, radius, distance: off.abs() }
    }

    /// 1 - cosΘ at an azimuth whose half has this sine.
    #[inline(always)]
    fn deflection(&self, half_sine: f64) -> f64 {
        let v = self.across + 2.0 * self.radius * half_sine * half_sine;
        if v > 2.0 { 2.0 } else { v }
    }

    /// The azimuth at which Θ is `edge`.
    fn crossing(&self, edge: f64) -> Option<f64> {
        let half = libm::sin(0.5 * edge);
        let square = (half * half - 0.5 * self.across) / self.radius;
        (square > 0.0 && square < 1.0).then(|| 2.0 * libm::asin(square.sqrt()))
    }
}

/// Widest panel in azimuth: Θ changes by less than it, by the sine of either zenith angle.
fn widest_around(widest: f64, peaks: &[Peak], sine: f64) -> f64 {
    let farthest = peaks.iter().fold(0.0, |most, peak| f64::max(most, peak.sine));
    (widest / sine.min(farthest)).min(WIDEST_SMOOTH).max(widest)
}
