//! What a shader's look-up makes of the texels: linear in the coordinate between neighbours.

use stratiform_quantities::angle_map;

/// The left texel of the cell that holds `theta_deg`, and the share of the right one.
pub(super) fn place(theta_deg: f64, texels: usize) -> (usize, f64) {
    let place = angle_map::coordinate(theta_deg) * (texels - 1) as f64;
    let cell = (place as usize).min(texels - 2);
    (cell, place - cell as f64)
}

/// The look-up of `values` (two or more) at Θ ∈ \[0°, 180°\].
pub fn look_up(values: &[f64], theta_deg: f64) -> f64 {
    let (cell, share) = place(theta_deg, values.len());
    values[cell] + (values[cell + 1] - values[cell]) * share
}
