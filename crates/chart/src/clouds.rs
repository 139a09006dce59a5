//! The clouds of a scene: a main one, and others at the ends of its ranges.

use crate::ChartError;
use std::path::Path;
use stratiform_methods::Cloud;
use stratiform_optics::droplets::DropletDistribution;
use stratiform_optics::ensemble::Ensemble;
use stratiform_optics::{OpticsConfig, OpticsError, compute, load_or_compute};
use stratiform_quantities::{ExtinctionConvention, SingleScatteringAlbedo};
use stratiform_scene::{Interval, Scene};

/// r_e of the main cloud where the scene allows it: that of Bouthors, Neyret & Lefebvre 2006.
const MAIN_RADIUS_UM: f64 = 7.0;

/// N0 where the scene does not say: it cancels out of all but metres.
const NUMBER_PER_CM3: f64 = 300.0;

/// A cloud, its place in the scene, and the range of its optical thickness.
pub struct SceneCloud {
    /// r_e.
    pub effective_radius_um: f64,
    /// λ.
    pub wavelength_um: f64,
    /// Ready for methods.
    pub cloud: Cloud,
    /// κH.
    pub tau: Interval,
}

/// r_e and λ of the scene's clouds, the main one first: all wavelengths at its radius, then other radii at its wavelength.
pub fn places(scene: &Scene) -> Vec<(f64, f64)> {
    let radii = scene.droplets.effective_radius_um;
    let main = if radii.contains(MAIN_RADIUS_UM) { MAIN_RADIUS_UM } else { (radii.min * radii.max).sqrt() };
    let mut waves = scene.wavelengths_um.clone();
    waves.sort_by(f64::total_cmp);
    let wave = waves[waves.len() / 2];
    let mut places = vec![(main, wave)];
    places.extend(scene.wavelengths_um.iter().filter(|other| **other != wave).map(|other| (main, *other)));
    for radius in [radii.min, (main * radii.max).sqrt(), radii.max] {
        if places.iter().all(|(known, _)| *known != radius) {
            places.push((radius, wave));
        }
    }
    places
}

/// The clouds at [`places`], or the main one alone.
///
/// # Errors
/// [`ChartError::Optics`] for droplets out of domain or a cache that cannot be used.
pub fn clouds(scene: &Scene, only_main: bool, cache: Option<&Path>) -> Result<Vec<SceneCloud>, ChartError> {
    let places = places(scene);
    let count = if only_main { 1 } else { places.len() };
    let main = places[0].0;
    let mut clouds: Vec<SceneCloud> = Vec::new();
    let mut at_main: Vec<Ensemble> = Vec::new();
    for &(radius, wavelength) in &places[..count] {
        let ensemble = if radius == main {
            if at_main.is_empty() {
                at_main = ensembles(scene, radius, scene.wavelengths_um.clone(), cache)?;
            }
            at_main.iter().find(|one| one.wavelength_um == wavelength).cloned()
        } else {
            ensembles(scene, radius, vec![wavelength], cache)?.pop()
        };
        let missing = || OpticsError::Config(format!("no optics at {wavelength} um"));
        clouds.push(scene_cloud(scene, radius, ensemble.ok_or_else(missing)?)?);
    }
    Ok(clouds)
}

fn ensembles(
    scene: &Scene,
    effective_radius_um: f64,
    wavelengths_um: Vec<f64>,
    cache: Option<&Path>,
) -> Result<Vec<Ensemble>, OpticsError> {
    let config = OpticsConfig {
        droplets: DropletDistribution::ModifiedGamma { gamma: scene.droplets.gamma(), effective_radius_um },
        number_density_per_cm3: scene.droplets.number_density_per_cm3.unwrap_or(NUMBER_PER_CM3),
        wavelengths_um,
        refractive_index: Default::default(),
        theta_f_deg: scene.droplets.theta_f_deg,
        tolerance: Default::default(),
    };
    match cache.map(|folder| load_or_compute(&config, folder)) {
        // A cache that cannot be read or written is no reason to stop.
        None | Some(Err(OpticsError::Artifact(_))) => compute(&config),
        Some(result) => result,
    }
}

fn scene_cloud(scene: &Scene, effective_radius_um: f64, one: Ensemble) -> Result<SceneCloud, ChartError> {
    let kappa = match scene.layer.extinction_convention {
        Some(ExtinctionConvention::Mie) => one.extinction.mie,
        _ => one.extinction.paper,
    };
    let in_metres = |metres: Interval| Interval { min: kappa * metres.min, max: kappa * metres.max };
    let tau = scene.layer.optical_thickness.or(scene.layer.thickness_m.map(in_metres));
    let tau = tau.ok_or_else(|| OpticsError::Config("the scene has no thickness".to_owned()))?;
    let omega = match scene.droplets.single_scattering_albedo {
        Some(omega) => omega,
        None => SingleScatteringAlbedo::new(one.single_scattering_albedo)?,
    };
    let wavelength_um = one.wavelength_um;
    let cloud = Cloud::new(one.phase, omega, scene.droplets.theta_f_deg, Some(effective_radius_um))?;
    Ok(SceneCloud { effective_radius_um, wavelength_um, cloud, tau })
}

#[cfg(test)]
mod tests {
    use super::*;
    use stratiform_scene::named;

    #[test]
    fn the_main_cloud_is_the_papers_and_the_others_reach_the_ends() {
        let places = places(&named("stratocumulus-above").unwrap());
        assert_eq!(places[..4], [(7.0, 0.55), (7.0, 0.65), (7.0, 0.45), (4.0, 0.55)]);
        assert!((places[4].0 - 11.832).abs() < 1e-3 && places[5] == (20.0, 0.55) && places.len() == 6);
    }
}
