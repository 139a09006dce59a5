//! ½∫ f sinΘ dΘ of what is smooth between the nodes of a table and the texels of its sampling.

use super::theta_deg;
use stratiform_optics::phase::{PhaseTable, gauss_legendre};

/// Points of Gauss and Legendre's rule in each cell.
const POINTS: usize = 4;

/// Points and weights between the nodes of a table and the texels, both included as borders.
pub(crate) struct Quadrature {
    /// Θ in degrees, and ½ sinΘ dΘ.
    pub(crate) points: Vec<(f64, f64)>,
    /// The borders themselves, degrees, rising.
    pub(crate) borders: Vec<f64>,
}

impl Quadrature {
    /// The rule for `table` and its sampling with `texels` values.
    pub(crate) fn new(table: &PhaseTable, texels: usize) -> Self {
        Self::between(table, (0..texels).map(|i| theta_deg(i, texels)))
    }

    /// The rule for `table` and something that is smooth between `nodes`, degrees.
    pub(crate) fn between(table: &PhaseTable, nodes: impl Iterator<Item = f64>) -> Self {
        let mut borders = table.theta_deg().to_vec();
        borders.extend(nodes);
        borders.sort_by(f64::total_cmp);
        borders.dedup();
        let rule = gauss_legendre(POINTS);
        let points = borders.windows(2).flat_map(|cell| {
            let (middle, half) = (0.5 * (cell[0] + cell[1]), 0.5 * (cell[1] - cell[0]));
            rule.iter().map(move |(at, weight)| {
                let theta = middle + half * at;
                (theta, 0.5 * weight * half.to_radians() * libm::sin(theta.to_radians()))
            })
        });
        Self { points: points.collect(), borders }
    }

    /// ½∫ f sinΘ dΘ, `f` of Θ in degrees.
    pub(crate) fn integral(&self, f: impl Fn(f64) -> f64) -> f64 {
        self.points.iter().fold(0.0, |sum, &(theta_deg, weight)| sum + weight * f(theta_deg))
    }
}
