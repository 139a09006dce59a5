//! How coarse a table is, told by the table alone.
//!
//! * The integral by two rules: trapezoids in cosΘ, and P linear in Θ. They agree for what is resolved.
//! * Every second row left out: the total variation between the table and its half. Linear interpolation errs as
//!   the square of the step, so that a quarter of it estimates the share of light that the table itself misplaces.
//! * The rows within the half-width of the forward peak.

use super::landmarks::Landmarks;
use stratiform_optics::phase::{Norm, PhaseTable};

/// Measures of coarseness.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sampling {
    /// Trapezoids in cosΘ over P linear in Θ.
    pub rules: f64,
    /// Estimated share of light that linear interpolation misplaces.
    pub misplaced: f64,
    /// Rows from 0° to the half-width, the first included.
    pub rows_in_peak: usize,
}

impl Sampling {
    /// Of a table.
    pub fn of(table: &PhaseTable) -> Self {
        let half_width = Landmarks::of(table).half_width_deg;
        Self {
            rules: trapezoids(table, 180.0),
            misplaced: 0.25 * half(table).map_or(1.0, |half| total_variation(table, &half)),
            rows_in_peak: table.theta_deg().iter().filter(|t| **t <= half_width).count(),
        }
    }
}

/// ½∫P dcosΘ from 0° to `up_to_deg` by trapezoids in cosΘ between the rows; the cell that holds `up_to_deg` ends there.
pub fn trapezoids(table: &PhaseTable, up_to_deg: f64) -> f64 {
    let (theta, p) = (table.theta_rad(), table.values());
    let end = up_to_deg.to_radians();
    let cells = (1..p.len()).filter(|i| theta[i - 1] < theta[*i]);
    cells.take_while(|i| theta[i - 1] < end).fold(0.0, |sum, i| {
        let (a, b) = (theta[i - 1], theta[i].min(end));
        // cos a - cos b
        let width = |a: f64, b: f64| 2.0 * libm::sin(0.5 * (a + b)) * libm::sin(0.5 * (b - a));
        let last = p[i - 1] + (p[i] - p[i - 1]) * width(a, b) / width(a, theta[i]);
        sum + 0.25 * width(a, b) * (p[i - 1] + last)
    })
}

/// The table without every second row; both ends stay.
fn half(table: &PhaseTable) -> Option<PhaseTable> {
    let last = table.values().len() - 1;
    let kept = |i: &usize| i.is_multiple_of(2) || *i == last;
    let take = |list: &[f64]| -> Vec<f64> { (0..=last).filter(kept).map(|i| list[i]).collect() };
    PhaseTable::new(take(table.theta_deg()), take(table.values()), Norm::Any).ok()
}

/// ½·mean|P-Q| over the sphere, both at the rows of `table`, linear between.
pub fn total_variation(table: &PhaseTable, other: &PhaseTable) -> f64 {
    let theta = table.theta_rad();
    (1..theta.len()).fold(0.0, |sum, i| {
        let (a, b) = (theta[i - 1], theta[i]);
        let share = libm::sin(0.5 * (a + b)) * libm::sin(0.5 * (b - a));
        let off = |t: f64| (table.at(t) - other.at(t)).abs();
        sum + 0.5 * share * (off(a) + 4.0 * off(0.5 * (a + b)) + off(b)) / 6.0
    })
}
