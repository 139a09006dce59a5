//! What a program reconstructs from its file by its own interpolation rule, against the table the file comes from.

use serde::Serialize;
use stratiform_optics::phase::{PhaseFunction, PhaseTable};

/// P below this, a thousandth of the mean, counts as this in relative errors.
const FLOOR: f64 = 1e-3;

/// Where the glory is, degrees.
const GLORY_DEG: f64 = 170.0;

/// The reconstructed phase function and its errors; all are for P with mean 1 over the sphere.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Reconstruction {
    /// ½∫P sinΘ dΘ before the program's own normalisation, if it has one.
    pub integral: f64,
    /// g.
    pub asymmetry: f64,
    /// g less the table's.
    pub asymmetry_error: f64,
    /// Relative error of P(0).
    pub peak_error: f64,
    /// Largest relative error over 170–180°.
    pub glory_error: f64,
    /// Largest relative error over all angles.
    pub largest_error: f64,
    /// Where that is, degrees.
    pub largest_error_deg: f64,
}

impl Reconstruction {
    /// The reconstruction `p` of Θ in radians, compared at the ends and inside every cell of `source`.
    pub(super) fn new(source: &PhaseTable, integral: f64, asymmetry: f64, p: impl Fn(f64) -> f64) -> Self {
        let error = |theta: f64| {
            let truth = source.at(theta);
            (p(theta) - truth) / truth.max(FLOOR)
        };
        let mut found = Self {
            integral,
            asymmetry,
            asymmetry_error: asymmetry - source.asymmetry(),
            peak_error: error(0.0),
            glory_error: 0.0,
            largest_error: 0.0,
            largest_error_deg: 0.0,
        };
        for theta in sample_angles(source) {
            let (size, degrees) = (error(theta).abs(), theta.to_degrees());
            if degrees >= GLORY_DEG {
                found.glory_error = found.glory_error.max(size);
            }
            if size > found.largest_error {
                (found.largest_error, found.largest_error_deg) = (size, degrees);
            }
        }
        found
    }
}

/// 0, π, and three angles in every cell.
fn sample_angles(source: &PhaseTable) -> impl Iterator<Item = f64> {
    let nodes = source.theta_rad();
    let inside = nodes
        .windows(2)
        .filter(|cell| cell[1] > cell[0])
        .flat_map(|cell| [0.25, 0.5, 0.75].map(|t| cell[0] + t * (cell[1] - cell[0])));
    std::iter::once(nodes[0]).chain(inside).chain(nodes.last().copied())
}
