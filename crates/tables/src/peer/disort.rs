//! DISORT's `PMOM`: Legendre moments as text, one a line.
//!
//! Convention of DISORT 1 to 4 and cdisort, checked with cdisort by nanodisort 0.3.0: χ_l = ½∫P P_l(μ) dμ, l = 0 first,
//! χ_0 = 1, without the factor 2l+1 (libRadtran's `pmom` and Eradiate's have it). Lines from `#` on are comments. What the
//! program reconstructs, without delta-M, is the truncated sum Σ(2l+1)χ_l P_l(μ): its g is exact, its peak too low, and
//! with too few moments it swings below zero.

use super::PeerFile;
use crate::TablesError;
use crate::card::Card;
use crate::sampled::Quadrature;
use stratiform_optics::phase::{PhaseFunction, PhaseTable};
use stratiform_quantities::Range;

/// Numbers of moments that are written.
pub const MOMENTS: Range = Range::closed(2.0, 32768.0);

/// χ_0 … χ_{count-1}.
///
/// # Errors
/// [`TablesError::Domain`] unless 2 ≤ `count` ≤ 32768.
pub fn pmom(table: &PhaseTable, count: usize) -> Result<PeerFile<String>, TablesError> {
    MOMENTS.check("moments of PMOM", count as f64)?;
    let mut chi = table.moments(count);
    chi[0] = 1.0;
    let lines: String = chi.iter().map(|chi| format!("{chi}\n")).collect();
    let content = format!(
        "# PMOM: Legendre moments chi_0, chi_1, ... without the factor 2l+1; {count} of them\n{lines}"
    );
    Ok(PeerFile { content, values: count, cards: vec![card(table, &chi)] })
}

/// A number of moments, a power of two from 128 to 8192, whose last eighth changes the sum at 0° and at 180° by less
/// than 1e-3 of P; 8192 if that is not enough.
pub fn moments_for(table: &PhaseTable) -> usize {
    let ends = [(1.0, table.at(0.0)), (-1.0, table.at(std::f64::consts::PI))];
    let enough = |count: usize| {
        let chi = table.moments(count);
        let tail = |sign: f64| {
            let terms = (count - count / 8..count).step_by(2);
            terms.fold(0.0, |sum, l| {
                sum + (2 * l + 1) as f64 * chi[l] + sign * (2 * l + 3) as f64 * chi[l + 1]
            })
        };
        ends.iter().all(|(sign, p)| tail(*sign).abs() < 1e-3 * p)
    };
    (7..13).map(|k| 1 << k).find(|count| enough(*count)).unwrap_or(1 << 13)
}

/// The sum rings everywhere: no angle is left out.
fn card(table: &PhaseTable, chi: &[f64]) -> Card {
    let steps = chi.len();
    let nodes = (0..=steps).map(|i| 180.0 * i as f64 / steps as f64);
    let quadrature = Quadrature::between(table, nodes);
    Card::of_look_up(table, &quadrature, |_| true, |theta_deg| sum(chi, libm::cos(theta_deg.to_radians())))
}

/// Σ(2l+1)χ_l P_l(μ).
fn sum(chi: &[f64], mu: f64) -> f64 {
    let (mut before, mut legendre, mut total) = (0.0, 1.0, 0.0);
    for (l, chi) in chi.iter().enumerate() {
        let l = l as f64;
        total += (2.0 * l + 1.0) * chi * legendre;
        (before, legendre) = (legendre, ((2.0 * l + 1.0) * mu * legendre - l * before) / (l + 1.0));
    }
    total
}
