//! Phase functions that are piecewise linear in μ = cosΘ, as programs tabulate them.
//!
//! Equidistant in μ: the least-squares fit to P ([`tents`](super::tents)), whose integral is that of P. Irregular: the
//! table's own nodes, halved until P at the middle (in Θ) of every cell is right to 3e-5, with cosines that are
//! different in f32.

use super::{tents, worth};
use crate::card::Card;
use stratiform_optics::phase::{PhaseTable, versine};

/// Relative error of the irregular form inside a cell.
const REFINEMENT: f64 = 3e-5;

/// P at ascending μ from -1 to 1, linear between.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct OverCosine {
    pub(super) mu: Vec<f64>,
    pub(super) p: Vec<f64>,
}

impl OverCosine {
    /// `count` ≥ 2 nodes at equal steps of μ.
    pub(super) fn equidistant(table: &PhaseTable, count: usize) -> Self {
        let step = 2.0 / (count - 1) as f64;
        let mut p = tents::fit(table, count);
        p.reverse();
        Self { mu: (0..count).map(|i| -1.0 + i as f64 * step).collect(), p }
    }

    /// The table's own nodes, refined; the integral is 1.
    pub(super) fn irregular(table: &PhaseTable) -> Self {
        let mut nodes: Vec<Node> = Vec::new();
        for (theta, p) in refined(table) {
            place(&mut nodes, theta, p);
        }
        let back = table.values()[table.values().len() - 1];
        if let Some(last) = nodes.last_mut().filter(|last| last.mu == -1.0) {
            last.p = back;
        }
        nodes.reverse();
        let mut over = Self {
            mu: nodes.iter().map(|node| f64::from(node.mu)).collect(),
            p: nodes.iter().map(|node| node.p).collect(),
        };
        let integral = over.integral();
        over.p.iter_mut().for_each(|p| *p /= integral);
        over
    }

    /// P at Θ in radians.
    pub(super) fn at(&self, theta: f64) -> f64 {
        let mu = libm::cos(theta);
        let right = self.mu.partition_point(|node| *node < mu).clamp(1, self.mu.len() - 1);
        let t = (mu - self.mu[right - 1]) / (self.mu[right] - self.mu[right - 1]);
        self.p[right - 1] + t * (self.p[right] - self.p[right - 1])
    }

    /// ½∫P dμ.
    pub(super) fn integral(&self) -> f64 {
        self.cells().fold(0.0, |sum, ([a, b], [pa, pb])| sum + 0.25 * (b - a) * (pa + pb))
    }

    fn cells(&self) -> impl Iterator<Item = ([f64; 2], [f64; 2])> {
        (1..self.mu.len()).map(|i| ([self.mu[i - 1], self.mu[i]], [self.p[i - 1], self.p[i]]))
    }

    /// The card of this against the table it comes from.
    pub(super) fn card(&self, table: &PhaseTable) -> Card {
        let nodes: Vec<f64> = self.mu.iter().rev().map(|mu| worth::degrees(*mu)).collect();
        worth::card(table, &nodes, |theta| self.at(theta))
    }
}

/// Θ in radians and P, both values where the table jumps; cells are halved until they are linear in μ.
fn refined(table: &PhaseTable) -> Vec<(f64, f64)> {
    let nodes: Vec<(f64, f64)> =
        table.theta_rad().iter().copied().zip(table.values().iter().copied()).collect();
    let mut all = vec![nodes[0]];
    for pair in nodes.windows(2) {
        halve(&mut all, pair[0], pair[1], 24);
    }
    all
}

/// Appends the nodes of (`left`, `right`\].
fn halve(all: &mut Vec<(f64, f64)>, left: (f64, f64), right: (f64, f64), depth: usize) {
    let middle = (0.5 * (left.0 + right.0), 0.5 * (left.1 + right.1));
    let v = [left.0, middle.0, right.0].map(versine);
    let linear = left.1 + (right.1 - left.1) * (v[1] - v[0]) / (v[2] - v[0]);
    if depth == 0 || v[2] <= v[0] || (linear - middle.1).abs() <= REFINEMENT * middle.1 {
        all.push(right);
        return;
    }
    halve(all, left, middle, depth - 1);
    halve(all, middle, right, depth - 1);
}

/// A node of the irregular form.
struct Node {
    theta: f64,
    mu: f32,
    p: f64,
}

/// Appends a node at the next smaller cosine that f32 can hold; the second value of a jump goes one step further.
fn place(nodes: &mut Vec<Node>, theta: f64, p: f64) {
    let mu = (1.0 - versine(theta)) as f32;
    match nodes.last() {
        None => nodes.push(Node { theta, mu, p }),
        Some(last) if last.theta == theta => {
            let mu = last.mu.next_down();
            nodes.push(Node { theta, mu, p });
        }
        Some(last) if mu < last.mu => nodes.push(Node { theta, mu, p }),
        Some(_) => {}
    }
}
