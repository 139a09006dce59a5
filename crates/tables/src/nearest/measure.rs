//! How far an analytic phase function Q is from a table P.
//!
//! Distances are sums over [`CELLS`] cells of the sphere, equal steps of the project's angle map (360°/n² wide at both
//! ends), each with its exact solid angle and the values at its middle. Shares of light are closed forms.

use super::{Blend, BlendPhase};
use crate::TablesError;
use crate::diagnosis::landmarks::Landmarks;
use stratiform_optics::phase::{PhaseFunction, PhaseTable, versine};
use stratiform_quantities::angle_map::angle_deg;

/// Cells of the sphere.
const CELLS: usize = 1024;

/// P at the middle of every cell.
pub(super) struct Sphere {
    /// v = 1 - cosΘ at the middle, share of the sphere, P.
    cells: Vec<[f64; 3]>,
}

impl Sphere {
    pub(super) fn new(table: &PhaseTable) -> Self {
        let theta = |half_steps: usize| angle_deg(half_steps as f64 / (2 * CELLS) as f64);
        let cell = |i: usize| {
            let middle = theta(2 * i + 1);
            // cos a - cos b = 2 sin((a+b)/2) sin((b-a)/2), half of it the share of the sphere.
            let (a, b) = (theta(2 * i).to_radians(), theta(2 * i + 2).to_radians());
            let share = libm::sin(0.5 * (a + b)) * libm::sin(0.5 * (b - a));
            [versine(middle.to_radians()), share, table.at(middle.to_radians())]
        };
        Self { cells: (0..CELLS).map(cell).collect() }
    }

    /// ½·mean|P-Q|: the share of light sent into a wrong direction.
    pub(super) fn total_variation(&self, phase: &BlendPhase) -> f64 {
        self.cells.iter().fold(0.0, |sum, [v, share, p]| sum + 0.5 * share * (p - phase.value(*v)).abs())
    }

    /// √mean ln²(Q/P). Where P is 0 there is no ratio, and the cell does not count.
    pub(super) fn log_rms(&self, phase: &BlendPhase) -> f64 {
        let (sum, sphere) = self.cells.iter().filter(|[_, _, p]| *p > 0.0).fold(
            (0.0, 0.0),
            |(sum, sphere), [v, share, p]| {
                let ratio = libm::log(phase.value(*v) / p);
                (sum + share * ratio * ratio, sphere + share)
            },
        );
        (sum / sphere).sqrt()
    }
}

/// The error of an approximation Q of P.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Measured {
    /// ½·mean|P-Q| over the sphere.
    pub total_variation: f64,
    /// √mean ln²(Q/P) over the sphere.
    pub log_rms: f64,
    /// g of Q, and less g of P.
    pub asymmetry: [f64; 2],
    /// P_f of Q, and less P_f of P.
    pub forward_fraction: [f64; 2],
    /// Share beyond 90° of Q, and less that of P.
    pub backward_fraction: [f64; 2],
    /// Q/P at 0°, unless P is 0 there.
    pub forward_ratio: Option<f64>,
    /// Q/P at the fogbow, where P has one.
    pub fogbow_ratio: Option<f64>,
    /// Q/P at 180°, in the middle of the glory, unless P is 0 there.
    pub glory_ratio: Option<f64>,
}

/// Measures `blend` against `table`.
///
/// # Errors
/// [`TablesError`] if a parameter or `theta_f_deg` is out of domain.
pub fn measure(table: &PhaseTable, blend: Blend, theta_f_deg: f64) -> Result<Measured, TablesError> {
    let phase = blend.phase()?;
    let sphere = Sphere::new(table);
    let with_error = |found: f64, truth: f64| [found, found - truth];
    let ratio = |theta_deg: f64| {
        let p = table.at(theta_deg.to_radians());
        (p > 0.0).then(|| phase.value(versine(theta_deg.to_radians())) / p)
    };
    let forward = phase.cumulative(versine(theta_f_deg.to_radians()));
    Ok(Measured {
        total_variation: sphere.total_variation(&phase),
        log_rms: sphere.log_rms(&phase),
        asymmetry: with_error(phase.asymmetry(), table.asymmetry()),
        forward_fraction: with_error(forward, table.forward_fraction(theta_f_deg)?),
        backward_fraction: with_error(1.0 - phase.cumulative(1.0), 1.0 - table.cumulative(1.0)),
        forward_ratio: ratio(0.0),
        fogbow_ratio: Landmarks::of(table).fogbow.and_then(|bow| ratio(bow.theta_deg)),
        glory_ratio: ratio(180.0),
    })
}
