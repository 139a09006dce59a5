//! The card of what a program reconstructs from its file by its own interpolation rule.

use crate::card::{Card, jumps_deg};
use crate::sampled::Quadrature;
use stratiform_optics::phase::{PhaseTable, angle};

/// The card of `p` of Θ in radians, smooth between `nodes_deg` (ascending); relative errors leave out the cell of a
/// jump of the table and the cells beside it.
pub(super) fn card(table: &PhaseTable, nodes_deg: &[f64], p: impl Fn(f64) -> f64) -> Card {
    let last = nodes_deg.len() - 1;
    let ramp = |jump: f64| {
        let right = nodes_deg.partition_point(|node| *node < jump);
        [nodes_deg[right.saturating_sub(2).min(last)], nodes_deg[(right + 1).min(last)]]
    };
    let ramps: Vec<[f64; 2]> = jumps_deg(table).map(ramp).collect();
    let smooth = |theta_deg: f64| ramps.iter().all(|[from, to]| theta_deg < *from || theta_deg > *to);
    let quadrature = Quadrature::between(table, nodes_deg.iter().copied());
    Card::of_look_up(table, &quadrature, smooth, |theta_deg| p(theta_deg.to_radians()))
}

/// Θ of μ, degrees.
pub(super) fn degrees(mu: f64) -> f64 {
    angle(1.0 - mu).to_degrees()
}
