//! What the solver of one slab says about a flat layer: nothing of the renderer or its tables is in it but the phase function.

use super::EffectError;
use glam::DVec3;
use std::f64::consts::PI;
use std::sync::Arc;
use stratiform_optics::phase::PhaseTable;
use stratiform_quantities::{Incidence, Side, SingleScatteringAlbedo};
use stratiform_transport::solve::{RadianceOrder, RadianceSolver, SolveMedium, Solver, View};
use stratiform_world::World;

/// A tenth of what pictures are held to.
const TOLERANCE: f64 = 5e-3;

fn medium(phase: &PhaseTable) -> Result<SolveMedium, EffectError> {
    Ok(SolveMedium::full(Arc::new(phase.clone()), SingleScatteringAlbedo::new(1.0)?))
}

/// Radiance of the sun's light from a layer of optical thickness `tau` along each ray, per irradiance normal to the beam.
///
/// # Errors
/// Those of the solver.
pub fn radiance(
    world: &World,
    phase: &PhaseTable,
    tau: f64,
    rays: &[DVec3],
) -> Result<Vec<f64>, EffectError> {
    let sun = world.sun.direction;
    let views: Vec<View> = rays.iter().map(|ray| view(*ray, sun)).collect();
    let solved = RadianceSolver::new(medium(phase)?, TOLERANCE)?.radiance(&[tau], &[sun.z], &views)?;
    let factor = |i: usize| solved.estimate(0, 0, i, RadianceOrder::Total).value;
    Ok((0..rays.len()).map(|i| factor(i) * sun.z / PI).collect())
}

/// How the light of a line of sight leaves the layer.
fn view(ray: DVec3, sun: DVec3) -> View {
    let (across, along) = (ray.x * sun.y - ray.y * sun.x, ray.x * sun.x + ray.y * sun.y);
    View {
        side: if ray.z < 0.0 { Side::Top } else { Side::Bottom },
        mu: ray.z.abs(),
        phi_deg: libm::atan2(across.abs(), along).to_degrees(),
    }
}

/// Reflected and transmitted shares of a layer's light: of a beam at each cosine to the vertical, then of diffuse light.
///
/// # Errors
/// Those of the solver.
pub fn shares(phase: &PhaseTable, tau: f64, cosines: &[f64]) -> Result<Vec<(f64, f64)>, EffectError> {
    let beams = cosines.iter().map(|mu| Incidence::beam(*mu));
    let incidence = beams.chain([Ok(Incidence::Diffuse)]).collect::<Result<Vec<_>, _>>()?;
    let solved = Solver::new(medium(phase)?, TOLERANCE)?.totals(&[tau], &incidence)?;
    let share = |i: usize| {
        let (reflected, transmitted) = solved.total(i, 0);
        (reflected.value, transmitted.value)
    };
    Ok((0..incidence.len()).map(share).collect())
}
