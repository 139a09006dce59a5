//! The piecewise linear function of μ on equidistant nodes that is closest to P in the mean square.
//!
//! With tents φ_j and step h it solves Σ_k ∫φ_jφ_k dμ p_k = ∫Pφ_j dμ, a tridiagonal system (h/6, 4h/6, h/6; 2h/6 at the
//! ends). 1 and μ are sums of tents: the integral and g are those of P whatever the step.
//!
//! Where the step is too coarse for a peak or a jump the fit swings below zero. It is the mean of P under each tent,
//! ∫Pφ_j/∫φ_j, plus what neighbours exchange, (p_j - p_{j+1})h/6; exchanges that would make a value negative are reduced
//! there (Zalesak 1979, J. Comput. Phys. 31, 335). The integral stays, g is off by what is reported.

use crate::sampled::Quadrature;
use crate::tridiagonal;
use stratiform_optics::phase::{PhaseTable, angle, versine};

/// Cells of the quadrature are no wider, degrees.
const WIDEST_DEG: f64 = 2.5;

/// The values at 1 - μ = 2j/(count - 1), j = 0 … count - 1 from forward to back; none is negative.
pub(super) fn fit(table: &PhaseTable, count: usize) -> Vec<f64> {
    // In units of the step.
    let mass: Vec<f64> = integrals(table, count).iter().map(|m| m * 0.5 * (count - 1) as f64).collect();
    let end = |j: usize| j == 0 || j == count - 1;
    let diagonal = (0..count).map(|j| if end(j) { 1.0 / 3.0 } else { 2.0 / 3.0 }).collect();
    let closest = tridiagonal::solve(diagonal, &vec![1.0 / 6.0; count - 1], mass.clone());
    let exchanged = exchange(&mass, &closest);
    let width = |j: usize| if end(j) { 0.5 } else { 1.0 };
    exchanged.iter().enumerate().map(|(j, mass)| (mass / width(j)).max(0.0)).collect()
}

/// `mass` after the exchanges between neighbours that lead to `closest`, as far as no mass becomes negative.
fn exchange(mass: &[f64], closest: &[f64]) -> Vec<f64> {
    let gains: Vec<f64> = closest.windows(2).map(|pair| (pair[0] - pair[1]) / 6.0).collect();
    let mut lost = vec![0.0; mass.len()];
    for (j, gain) in gains.iter().enumerate() {
        lost[if *gain > 0.0 { j + 1 } else { j }] += gain.abs();
    }
    let share = |j: usize| if lost[j] > mass[j] { mass[j] / lost[j] } else { 1.0 };
    let mut exchanged = mass.to_vec();
    for (j, gain) in gains.iter().enumerate() {
        let moved = gain * share(if *gain > 0.0 { j + 1 } else { j });
        exchanged[j] += moved;
        exchanged[j + 1] -= moved;
    }
    exchanged
}

/// ∫Pφ_j dμ.
fn integrals(table: &PhaseTable, count: usize) -> Vec<f64> {
    let last = (count - 1) as f64;
    let nodes = (0..count).map(|j| angle(2.0 * j as f64 / last).to_degrees());
    let between = (1..(180.0 / WIDEST_DEG) as usize).map(|i| WIDEST_DEG * i as f64);
    let mut mass = vec![0.0; count];
    for (theta_deg, weight) in Quadrature::between(table, nodes.chain(between)).points {
        let theta = theta_deg.to_radians();
        let place = 0.5 * versine(theta) * last;
        let j = (place as usize).min(count - 2);
        let part = 2.0 * weight * table.at(theta);
        let t = place - j as f64;
        mass[j] += (1.0 - t) * part;
        mass[j + 1] += t * part;
    }
    mass
}

#[cfg(test)]
mod tests {
    use super::*;
    use stratiform_optics::phase::Norm;

    fn linear(forward: f64, back: f64) -> PhaseTable {
        // Linear in μ: many nodes, because a table is linear in Θ between its own.
        let theta: Vec<f64> = (0..=3600).map(|i| 0.05 * f64::from(i)).collect();
        let p = theta.iter().map(|t| {
            let mu = libm::cos(t.to_radians());
            0.5 * (forward + back) + 0.5 * (forward - back) * mu
        });
        PhaseTable::new(theta.clone(), p.collect(), Norm::Strict).unwrap()
    }

    #[test]
    fn what_is_linear_is_met_at_every_node() {
        for count in [2, 3, 17, 400] {
            for (j, p) in fit(&linear(1.5, 0.5), count).iter().enumerate() {
                let expected = 1.5 - j as f64 / (count - 1) as f64;
                assert!((p - expected).abs() < 1e-6, "{count} {j}: {p} {expected}");
            }
        }
    }
}
