//! Checks of what every scene says: droplets, layer, sun, view.

use crate::fault::{Fault, check_interval, check_optional, listed_once};
use crate::{Droplets, Layer, Scene};
use stratiform_quantities::Range;

pub(crate) fn check(scene: &Scene) -> Result<(), Fault> {
    if scene.schema != Scene::SCHEMA {
        let message = format!("schema `{}` is not `{}`", scene.schema, Scene::SCHEMA);
        return Err(Fault::contents("schema", message));
    }
    check_layer(scene)?;
    check_droplets(&scene.droplets)?;
    let to_the_horizon = Range { max_included: false, ..Range::closed(0.0, 90.0) };
    check_interval("sun.theta_deg", &scene.sun.theta_deg, to_the_horizon)?;
    check_interval("view.theta_deg", &scene.view.theta_deg, to_the_horizon)?;
    check_interval("view.azimuth_deg", &scene.view.azimuth_deg, Range::closed(0.0, 180.0))?;
    for wavelength in &scene.wavelengths_um {
        Range::closed(0.2, 4.0).check("wavelengths_um", *wavelength)?;
    }
    listed_once("wavelengths_um", &scene.wavelengths_um)?;
    listed_once("view.sides", &scene.view.sides)?;
    if scene.visible.is_empty() { Ok(()) } else { listed_once("visible", &scene.visible) }
}

fn check_layer(scene: &Scene) -> Result<(), Fault> {
    let Layer { optical_thickness, thickness_m, extinction_convention } = &scene.layer;
    let up_to = |max: f64| Range { min_included: false, ..Range::closed(0.0, max) };
    match (optical_thickness, thickness_m) {
        (Some(tau), None) => check_interval("layer.optical_thickness", tau, up_to(1e4)),
        (None, Some(metres)) => {
            let missing = |key: &str| {
                let message = format!("{key} is missing: a thickness in metres needs it");
                Fault::contents("layer.thickness_m", message)
            };
            extinction_convention.ok_or_else(|| missing("layer.extinction_convention"))?;
            let number = scene.droplets.number_density_per_cm3;
            number.ok_or_else(|| missing("droplets.number_density_per_cm3"))?;
            check_interval("layer.thickness_m", metres, up_to(1e5))
        }
        _ => {
            let message = "layer needs one of optical_thickness and thickness_m, not both";
            Err(Fault::contents("layer.thickness_m", message))
        }
    }
}

fn check_droplets(droplets: &Droplets) -> Result<(), Fault> {
    let radius = &droplets.effective_radius_um;
    check_interval("droplets.effective_radius_um", radius, Range::closed(0.1, 100.0))?;
    // γ = 1/v_e - 2 must be positive.
    Range::open(0.0, 0.5).check("droplets.effective_variance", droplets.effective_variance)?;
    Range::open(0.0, 90.0).check("droplets.theta_f_deg", droplets.theta_f_deg)?;
    check_optional(
        "droplets.number_density_per_cm3",
        droplets.number_density_per_cm3,
        Range::closed(1e-6, 1e9),
    )
}
