//! What a shader's look-up makes of the texels: linear in the coordinate between neighbours.

use stratiform_quantities::angle_map::place;

/// The look-up of `values` (two or more) at Θ ∈ \[0°, 180°\].
pub fn look_up(values: &[f64], theta_deg: f64) -> f64 {
    let (cell, share) = place(theta_deg, values.len());
    values[cell] + (values[cell + 1] - values[cell]) * share
}
