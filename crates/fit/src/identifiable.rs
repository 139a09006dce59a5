//! Whether the totals determine c, and what stands in where they do not.
//!
//! T_ms depends on c only through (1-b)(1 - e^{-cτ}). c is not identifiable if either
//! * its standard error from the reference's covariance exceeds c/2, or
//! * with c halved and b adapted the curve changes by less, in the root mean square over the grid, than the
//!   fit misses the data by: what the form fails to follow anyhow could have chosen another c. This
//!   happens round the angle where b passes 1; on its way there the best c runs off to one side and comes back
//!   from the other.

use crate::matrix::{dot, norm};
use crate::{FitError, Reference};
use stratiform_quantities::Incidence;
use stratiform_stats::Estimate;

/// A fitted curve of T_ms.
pub(crate) struct Curve<'a> {
    pub tau: &'a [f64],
    pub beta: f64,
    pub b: f64,
    pub c: f64,
}

impl Curve<'_> {
    /// How far c is from identifiable: not above 1, from its standard error (absent on a bound) and the row's
    /// misfit.
    pub fn doubt(&self, std_error: Option<f64>, residuals: &[f64]) -> f64 {
        let change = self.change_of_halved_c();
        let by_misfit = if change > 0.0 { norm(residuals) / change } else { f64::INFINITY };
        by_misfit.max(std_error.unwrap_or(0.0) / (0.5 * self.c))
    }

    /// Norm of the change with half of c and the b that changes the curve least.
    fn change_of_halved_c(&self) -> f64 {
        let slope = (1.0 - self.beta) / self.beta;
        // The curve is base - (1-b)·shape(c) with these two.
        let shape = |c: f64| -> Vec<f64> {
            self.tau.iter().map(|tau| -libm::expm1(-c * tau) / (1.0 + slope * tau)).collect()
        };
        let (own, halved) = (shape(self.c), shape(0.5 * self.c));
        let factor = dot(&own, &halved) / dot(&halved, &halved);
        let change: Vec<f64> =
            own.iter().zip(&halved).map(|(o, h)| (1.0 - self.b) * (o - factor * h)).collect();
        norm(&change)
    }
}

/// For each angle without c, the value to hold it at: log c interpolated over μ_l between the nearest angles
/// that have one, the nearest one's beyond them, and the middle of the bounds where none has. Diffuse light
/// has no neighbours: its c stays free.
pub(crate) fn interpolated(
    references: &[Reference],
    c: &[Option<Estimate>],
    [lower, upper]: [f64; 2],
) -> Result<Vec<Option<Estimate>>, FitError> {
    let mut cosines = Vec::with_capacity(references.len());
    for reference in references {
        cosines.push(match reference.light()? {
            Incidence::Beam(mu) => Some(mu.get()),
            Incidence::Diffuse => None,
        });
    }
    let node = |(mu, c): (&Option<f64>, &Option<Estimate>)| {
        let (mu, c) = ((*mu)?, (*c)?);
        Some((mu, Estimate { value: libm::log(c.value), std_error: c.std_error / c.value }))
    };
    let nodes: Vec<(f64, Estimate)> = cosines.iter().zip(c).filter_map(node).collect();
    let middle = Estimate { value: 0.5 * libm::log(lower * upper), std_error: 0.0 };
    let held = |mu: f64| {
        let log = between(&nodes, mu).unwrap_or(middle);
        let value = libm::exp(log.value).clamp(lower, upper);
        Estimate { value, std_error: log.std_error * value }
    };
    Ok(cosines.iter().zip(c).map(|(mu, c)| if c.is_none() { mu.map(held) } else { None }).collect())
}

/// Linear interpolation between the nearest nodes (in any order) on either side, whose errors are taken as
/// independent.
fn between(nodes: &[(f64, Estimate)], mu: f64) -> Option<Estimate> {
    let below = nodes.iter().filter(|n| n.0 <= mu).max_by(|a, b| a.0.total_cmp(&b.0));
    let above = nodes.iter().filter(|n| n.0 >= mu).min_by(|a, b| a.0.total_cmp(&b.0));
    match (below, above) {
        (Some(a), Some(b)) if b.0 > a.0 => {
            let share = (mu - a.0) / (b.0 - a.0);
            let (a, b) = (a.1, b.1);
            Some(Estimate {
                value: a.value + (b.value - a.value) * share,
                std_error: libm::hypot((1.0 - share) * a.std_error, share * b.std_error),
            })
        }
        (a, b) => a.or(b).map(|node| node.1),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn c_is_judged_by_noise_and_misfit() {
        let tau: Vec<f64> = (1..20).map(|k| 0.3 * f64::from(k)).collect();
        let doubt =
            |b, c, error, misfit: f64| Curve { tau: &tau, beta: 0.9, b, c }.doubt(error, &[misfit; 19]);
        assert!(doubt(0.5, 1.0, Some(0.1), 1e-3) < 1.0);
        assert!(doubt(0.5, 1.0, Some(0.6), 1e-3) > 1.0, "noise");
        assert!(doubt(0.5, 1.0, Some(0.1), 0.1) > 1.0, "misfit");
        assert!(doubt(0.99, 1.0, None, 1e-3) > 1.0, "b near 1");
        assert_eq!(doubt(1.0, 1.0, None, 0.0), f64::INFINITY, "b = 1");
        // (1-b)c alone counts in the limit of small c.
        assert!(doubt(0.5, 1e-4, None, 1e-6) > 1.0, "c too small to bend the curve");
    }

    #[test]
    fn gaps_are_filled_between_neighbours() {
        let of = |value: f64, std_error: f64| Estimate { value, std_error };
        let nodes = [(1.0, of(0.0, 0.6)), (0.5, of(1.0, 0.8)), (0.0, of(5.0, 0.0))];
        assert_eq!(between(&nodes, 0.75), Some(of(0.5, 0.5)));
        assert_eq!(between(&nodes[..2], 0.1), Some(of(1.0, 0.8)));
        assert_eq!(between(&nodes, 0.5), Some(of(1.0, 0.8)));
        assert_eq!(between(&[], 0.5), None);
    }
}
