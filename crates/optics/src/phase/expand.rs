//! A phase function from its Legendre moments: P = Σ(2l+1)χ_l P_l(cosΘ).
//!
//! The sum is tabulated at nodes refined until linear interpolation at every midpoint is off by less than 2e-5 of P
//! (and 2e-6 of 1). Sums negative beyond -1e-3 describe no phase function; smaller dips count as 0.

use super::table::Norm;
use super::{PhaseTable, legendre};
use crate::OpticsError;
use stratiform_quantities::Range;

/// Sums below this are refused.
const LOWEST: f64 = -1e-3;

impl PhaseTable {
    /// The table of Σ(2l+1)χ_l P_l.
    ///
    /// # Errors
    /// [`OpticsError::Domain`] unless χ_0 = 1 and |χ_l| ≤ 1; [`OpticsError::NegativeSum`] for a negative sum.
    pub fn from_moments(moments: &[f64]) -> Result<Self, OpticsError> {
        check(moments)?;
        let degrees = refined_nodes(moments);
        let theta: Vec<f64> = degrees.iter().map(|t| t.to_radians()).collect();
        let p = not_negative(&degrees, legendre::sum(moments, &theta))?;
        Self::new(degrees, p, Norm::Strict)
    }
}

fn check(moments: &[f64]) -> Result<(), OpticsError> {
    Range::closed(1.0, 1.0).check("moment chi_0", moments.first().copied().unwrap_or(f64::NAN))?;
    for (l, chi) in moments.iter().enumerate() {
        Range::closed(-1.0, 1.0).check(&format!("moment chi_{l}"), *chi)?;
    }
    Ok(())
}

/// `p`, with dips to -1e-3 set to 0.
pub(super) fn not_negative(theta_deg: &[f64], mut p: Vec<f64>) -> Result<Vec<f64>, OpticsError> {
    let lowest = p.iter().zip(theta_deg).min_by(|a, b| a.0.total_cmp(b.0));
    if let Some((value, theta)) = lowest.filter(|(value, _)| **value < LOWEST) {
        return Err(OpticsError::NegativeSum { value: *value, theta_deg: *theta });
    }
    p.iter_mut().for_each(|value| *value = value.max(0.0));
    Ok(p)
}

/// Degrees from 0 to 180, halved where the sum is not linear between neighbours.
fn refined_nodes(moments: &[f64]) -> Vec<f64> {
    const DEEPEST: usize = 14;
    let cells = 4 * moments.len().clamp(16, 4096);
    let at = |degrees: &[f64]| -> Vec<(f64, f64)> {
        let theta: Vec<f64> = degrees.iter().map(|t| t.to_radians()).collect();
        degrees.iter().copied().zip(legendre::sum(moments, &theta)).collect()
    };
    let start: Vec<f64> = (0..=cells).map(|i| 180.0 * i as f64 / cells as f64).collect();
    let mut nodes = at(&start);
    let mut open: Vec<[(f64, f64); 2]> = nodes.windows(2).map(|pair| [pair[0], pair[1]]).collect();
    for _ in 0..DEEPEST {
        let middles: Vec<f64> = open.iter().map(|[a, b]| 0.5 * (a.0 + b.0)).collect();
        let middles = at(&middles);
        let bent = open
            .iter()
            .zip(&middles)
            .filter(|([a, b], m)| (0.5 * (a.1 + b.1) - m.1).abs() > 2e-5 * m.1.abs() + 2e-6);
        open = bent.flat_map(|([a, b], m)| [[*a, *m], [*m, *b]]).collect();
        nodes.extend(&middles);
        if open.is_empty() {
            break;
        }
    }
    let mut degrees: Vec<f64> = nodes.into_iter().map(|(theta, _)| theta).collect();
    degrees.sort_by(f64::total_cmp);
    degrees
}
