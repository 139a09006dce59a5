//! The phase table on the device: rows 0 and 1 as the generated text reads them (P, P_S convolved with itself, at the tables' wavelength),
//! 2 to 4 P in red, green and blue, 5 to 7 P_S convolved with itself. All on the generated text's angle map.

use crate::RenderError;
use crate::generated::{PHASE_COUNT, phase_rows};
use stratiform_optics::phase::PhaseTable;
use stratiform_quantities::angle_map::angle_deg;
use stratiform_world::Material;

/// All rows, one after the other.
///
/// # Errors
/// Those of the folder of generated files.
pub fn phase_table(material: &Material) -> Result<Vec<f32>, RenderError> {
    let [full, squared] = phase_rows(&material.generated)?;
    let coloured = material.colour.iter().chain(&material.colour_squared).map(on_angle_map);
    Ok([full, squared].into_iter().chain(coloured).flatten().map(|p| p as f32).collect())
}

/// A phase function at the equal steps of the angle map.
fn on_angle_map(phase: &PhaseTable) -> Vec<f64> {
    let at = |index| phase.at(angle_deg(index as f64 / (PHASE_COUNT - 1) as f64).to_radians());
    (0..PHASE_COUNT).map(at).collect()
}

/// 1 - P_f of each channel: the share of its scattering beyond θ_f.
pub fn kept(material: &Material) -> [f64; 3] {
    material.colour.each_ref().map(|phase| 1.0 - phase.cumulative_at(material.theta_f_deg.to_radians()))
}
