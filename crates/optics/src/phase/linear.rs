//! Legendre moments χ_l = ½∫P·P_l sinΘ dΘ of a table, in closed form from its nodes.
//!
//! P is linear in Θ between nodes, so two integrations by parts leave, at each node, the jump of P times G_l and the change
//! of its slope times H_l, where G_l = ∫_0^Θ P_l sinΘ dΘ and H_l = ∫_0^Θ G_l dΘ. With Gegenbauer's C_n of index 3/2 and
//! f_l = sin²Θ C_{l-1}(cosΘ), G_l = f_l/(l(l+1)), and H_l = F_l/(l(l+1)) where F_l = ∫f_l:
//!
//! l f_{l+1} = (2l+1)μ f_l - (l+1) f_{l-1},   l(l+2) F_{l+1} = (l²-1) F_{l-1} + (2l+1) sinΘ f_l.
//!
//! The first is C's recurrence (Abramowitz & Stegun 22.7.3); the second integrates d(sinΘ f_l)/dΘ. In a forward peak all terms
//! are positive: nothing cancels. Beyond 90° the table is mirrored, P_l(-μ) = (-1)^l P_l(μ), so that the same
//! holds of a backward one. What rounding leaves is about 1e-16 times ∫|P''|Θ dΘ, the peak's height.

use super::PhaseTable;
use rayon::prelude::*;
use std::f64::consts::PI;

/// Nodes whose sums are added up side by side, and such groups.
const LANES: usize = 8;
const GROUPS: usize = 32;

/// What a node contributes: `jump` G_l + `bend` H_l.
#[derive(Clone, Copy, Debug, Default)]
struct Node {
    theta: f64,
    jump: f64,
    bend: f64,
}

/// χ_0 … χ_{count-1} of `table`.
pub(super) fn moments(table: &PhaseTable, count: usize) -> Vec<f64> {
    below(table, f64::INFINITY, count)
}

/// What Θ < `end` contributes to the moments of `table`.
pub(super) fn below(table: &PhaseTable, end: f64, count: usize) -> Vec<f64> {
    let mut moments = Moments::below(table, end);
    moments.first(count).to_vec()
}

/// Moments that can be continued.
pub(super) struct Moments {
    /// As many as were computed.
    moments: Vec<f64>,
    front: Vec<State>,
    back: Vec<State>,
}

impl Moments {
    pub(super) fn new(table: &PhaseTable) -> Self {
        Self::below(table, f64::INFINITY)
    }

    fn below(table: &PhaseTable, end: f64) -> Self {
        let [mut front, mut back] = [Vec::new(), Vec::new()];
        let (theta, p) = (table.theta_rad(), table.values());
        for (theta, p) in theta.array_windows::<2>().zip(p.array_windows::<2>()) {
            let [a, b] = theta.map(|theta| theta.min(end));
            if a == b {
                continue;
            }
            let slope = (p[1] - p[0]) / (theta[1] - theta[0]);
            let p_end = if b < theta[1] { p[0] + slope * (b - a) } else { p[1] };
            if a < 0.5 * PI {
                add_piece(&mut front, [(a, p[0]), (b, p_end)], slope);
            } else {
                add_piece(&mut back, [(PI - b, p_end), (PI - a, p[0])], -slope);
            }
        }
        let states = |nodes: &[Node]| nodes.chunks(GROUPS * LANES).map(State::new).collect();
        let moments = vec![table.cumulative_at(end.min(PI))];
        Self { moments, front: states(&front), back: states(&back) }
    }

    /// χ_0 … χ_{count-1}; those computed before are not computed again.
    pub(super) fn first(&mut self, count: usize) -> &[f64] {
        if count > self.moments.len() {
            let from = self.moments.len();
            // Orders come in pairs.
            let new = (count - from).next_multiple_of(2);
            let [front, back] = [&mut self.front, &mut self.back].map(|states| sums(states, from, new));
            let pairs = front.into_iter().zip(back).zip(from..);
            self.moments.extend(pairs.map(|((a, b), l)| if l % 2 == 0 { a + b } else { a - b }));
        }
        &self.moments[..count]
    }
}

/// Both ends (Θ, P) of a piece of slope `slope`; a node that two pieces share stands once.
fn add_piece(nodes: &mut Vec<Node>, [low, high]: [(f64, f64); 2], slope: f64) {
    let ends = [
        Node { theta: high.0, jump: high.1, bend: -slope },
        Node { theta: low.0, jump: -low.1, bend: slope },
    ];
    for end in ends {
        // Pieces come upwards in front and downwards behind: a neighbour's ends are the last.
        match nodes.iter_mut().rev().take(3).find(|node| node.theta == end.theta) {
            Some(node) => (node.jump, node.bend) = (node.jump + end.jump, node.bend + end.bend),
            None => nodes.push(end),
        }
    }
}

/// ½Σ over the nodes, for `count` orders from `from` on.
fn sums(states: &mut [State], from: usize, count: usize) -> Vec<f64> {
    let group = |state: &mut State| {
        let mut sums = vec![0.0; count];
        add_nodes(state, from, &mut sums);
        sums
    };
    let groups: Vec<Vec<f64>> = states.par_iter_mut().map(group).collect();
    groups.iter().fold(vec![0.0; count], |mut sum, group| {
        sum.iter_mut().zip(group).for_each(|(total, part)| *total += part);
        sum
    })
}

/// The functions at the nodes: f_l and F_l (`now`, `area`), and those of l-1, for the next l.
struct State {
    mu: [[f64; LANES]; GROUPS],
    sine: [[f64; LANES]; GROUPS],
    jump: [[f64; LANES]; GROUPS],
    bend: [[f64; LANES]; GROUPS],
    now: [[f64; LANES]; GROUPS],
    before: [[f64; LANES]; GROUPS],
    area: [[f64; LANES]; GROUPS],
    area_before: [[f64; LANES]; GROUPS],
}

impl State {
    /// At l = 1, where f = sin²Θ and F = (Θ - sinΘ cosΘ)/2; places without a node count nothing.
    fn new(nodes: &[Node]) -> Self {
        let zero = [[0.0; LANES]; GROUPS];
        let [mu, sine, jump, bend, now, before, area, area_before] = [zero; 8];
        let mut state = Self { mu, sine, jump, bend, now, before, area, area_before };
        for (i, node) in nodes.iter().enumerate() {
            let (g, l) = (i / LANES, i % LANES);
            let (sine, cosine) = libm::sincos(node.theta);
            (state.mu[g][l], state.sine[g][l]) = (cosine, sine);
            (state.jump[g][l], state.bend[g][l]) = (node.jump, node.bend);
            (state.now[g][l], state.area[g][l]) = (sine * sine, sine_squared_integral(node.theta));
        }
        state
    }
}

/// (x - sin x cos x)/2, by its series x³/3 - x⁵/15 + … where the difference would cancel.
fn sine_squared_integral(x: f64) -> f64 {
    if x > 0.3 {
        return 0.5 * (x - libm::sin(x) * libm::cos(x));
    }
    // With y = 2x this is (y - sin y)/4.
    let y2 = 4.0 * x * x;
    let terms = 1.0 / 6.0
        - y2 * (1.0 / 120.0
            - y2 * (1.0 / 5040.0
                - y2 * (1.0 / 362_880.0 - y2 * (1.0 / 39_916_800.0 - y2 / 6_227_020_800.0))));
    0.5 * x * y2 * terms
}

/// What the recurrences from l to l+1 multiply by.
struct Factors {
    up: f64,
    down: f64,
    kept: f64,
    gained: f64,
    /// ½/(l(l+1)).
    share: f64,
}

impl Factors {
    fn new(l: usize) -> Self {
        let l = l as f64;
        Self {
            up: (2.0 * l + 1.0) / l,
            down: (l + 1.0) / l,
            kept: (l * l - 1.0) / (l * (l + 2.0)),
            gained: (2.0 * l + 1.0) / (l * (l + 2.0)),
            share: 0.5 / (l * (l + 1.0)),
        }
    }
}

/// The orders from `l` on, two by two, so that the functions of one take the places of those before it.
#[multiversion::multiversion(targets("x86_64+avx512f+avx512dq+avx512vl", "x86_64+avx2"))]
fn add_nodes(state: &mut State, mut l: usize, sums: &mut [f64]) {
    for pair in sums.as_chunks_mut::<2>().0 {
        let (first, second) = (Factors::new(l), Factors::new(l + 1));
        let mut totals = [[0.0; LANES]; 2];
        for g in 0..GROUPS {
            let (mu, sine, jump, bend) = (&state.mu[g], &state.sine[g], &state.jump[g], &state.bend[g]);
            let (mut now, mut area) = (state.now[g], state.area[g]);
            let (mut before, mut area_before) = (state.before[g], state.area_before[g]);
            for i in 0..LANES {
                totals[0][i] += jump[i] * now[i] + bend[i] * area[i];
                before[i] = first.up * mu[i] * now[i] - first.down * before[i];
                area_before[i] = first.kept * area_before[i] + first.gained * sine[i] * now[i];
                totals[1][i] += jump[i] * before[i] + bend[i] * area_before[i];
                now[i] = second.up * mu[i] * before[i] - second.down * now[i];
                area[i] = second.kept * area[i] + second.gained * sine[i] * before[i];
            }
            (state.now[g], state.area[g]) = (now, area);
            (state.before[g], state.area_before[g]) = (before, area_before);
        }
        *pair = [(first, totals[0]), (second, totals[1])]
            .map(|(factors, totals)| factors.share * totals.iter().fold(0.0, |sum, total| sum + total));
        l += 2;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::phase::gauss::gauss_legendre;
    use crate::phase::{HenyeyGreenstein, Norm, PhaseFunction};
    use stratiform_quantities::Asymmetry;

    /// 48 Gauss points in every 1/40 of a radian, P_l by its recurrence.
    fn by_quadrature(table: &PhaseTable, count: usize) -> Vec<f64> {
        let rule = gauss_legendre(48);
        let mut sums = vec![0.0; count];
        for ends in table.theta_rad().array_windows::<2>().filter(|[a, b]| b > a) {
            let pieces = (40.0 * (ends[1] - ends[0])).ceil();
            let half = 0.5 * (ends[1] - ends[0]) / pieces;
            for piece in 0..pieces as usize {
                for (node, weight) in &rule {
                    let theta = ends[0] + half * ((2 * piece + 1) as f64 + node);
                    let (mu, share) =
                        (libm::cos(theta), 0.5 * weight * half * table.at(theta) * libm::sin(theta));
                    let (mut before, mut now) = (0.0, 1.0);
                    for (l, sum) in sums.iter_mut().enumerate() {
                        *sum += share * now;
                        let l = l as f64;
                        (before, now) = (now, ((2.0 * l + 1.0) * mu * now - l * before) / (l + 1.0));
                    }
                }
            }
        }
        sums
    }

    /// A forward peak 1e-3 wide with a jump, the same backwards, and both.
    #[test]
    fn the_closed_form_is_the_integral() {
        let hg = HenyeyGreenstein::new(Asymmetry::new(0.999).unwrap());
        let theta: Vec<f64> = (0..=700).map(|i| 180.0 * libm::pow(f64::from(i) / 700.0, 3.0)).collect();
        let value = |t: f64| {
            let sine = libm::sin(0.5 * t.to_radians());
            hg.value(2.0 * sine * sine)
        };
        let forward: Vec<(f64, f64)> = theta.iter().map(|t| (*t, value(*t))).collect();
        let backward: Vec<(f64, f64)> = forward.iter().rev().map(|(t, p)| (180.0 - t, *p)).collect();
        let both = backward.iter().map(|(t, p)| (*t, p + value(*t))).collect();
        let jump =
            [(0.0, 1.0), (30.0, 1.5), (30.0, 0.0), (90.0, 0.2), (120.0, 0.5), (120.0, 2.0), (180.0, 0.0)]
                .to_vec();
        for rows in [forward, backward, both, jump] {
            let (theta, p) = rows.into_iter().unzip();
            let table = PhaseTable::new(theta, p, Norm::Any).unwrap();
            let (found, expected) = (moments(&table, 400), by_quadrature(&table, 400));
            let off = found.iter().zip(&expected).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            assert!(off < 1e-12, "{off:e}");
        }
    }

    /// P = 2 - 2Θ/π: χ_1 = ½∫P sinΘ cosΘ dΘ = 1/4.
    #[test]
    fn a_line_is_a_closed_form() {
        let table = PhaseTable::new(vec![0.0, 180.0], vec![2.0, 0.0], Norm::Any).unwrap();
        assert!((moments(&table, 2)[1] - 0.25).abs() < 1e-15);
    }

    #[test]
    fn both_forms_of_the_first_area_meet() {
        for x in [0.3_f64.next_down(), 0.3, 0.25] {
            let form = 0.5 * (x - libm::sin(x) * libm::cos(x));
            assert!((sine_squared_integral(x) / form - 1.0).abs() < 1e-13, "{x}");
        }
    }
}
