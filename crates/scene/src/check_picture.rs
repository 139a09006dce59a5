//! Checks of what only a picture says: camera, clouds, ground, sky.

use crate::fault::{Fault, check_interval, check_optional};
use crate::{Camera, Clouds, Ground, GroundPattern, Interval, Pattern, Radiosity, Scene, Sky, SkyModel, Sun};
use stratiform_quantities::Range;

/// Positive, up to `max`.
fn up_to(max: f64) -> Range {
    Range { min_included: false, ..Range::closed(0.0, max) }
}

pub(crate) fn check(scene: &Scene) -> Result<(), Fault> {
    check_sun(&scene.sun)?;
    if let Some(camera) = &scene.camera {
        check_camera(camera)?;
    }
    if let Some(clouds) = &scene.clouds {
        check_clouds(clouds)?;
    }
    if let Some(ground) = &scene.ground {
        check_ground(ground)?;
    }
    check_sky(&scene.sky)?;
    Range::closed(-30.0, 30.0).check("picture.exposure_ev", scene.picture.exposure_ev)?;
    check_radiosity(&scene.radiosity)?;
    match (&scene.camera, &scene.clouds) {
        (Some(_), None) => {
            Err(Fault::contents("camera", "clouds is missing: a camera needs something to see"))
        }
        (None, Some(_)) => {
            Err(Fault::contents("clouds", "camera is missing: clouds need somebody to see them"))
        }
        (Some(_), Some(_)) => one_picture(scene),
        (None, None) => Ok(()),
    }
}

/// A picture has one sun and one kind of droplets.
fn one_picture(scene: &Scene) -> Result<(), Fault> {
    let singles = [
        ("sun.theta_deg", scene.sun.theta_deg),
        ("droplets.effective_radius_um", scene.droplets.effective_radius_um),
    ];
    match singles.iter().find(|(_, interval)| interval.min < interval.max) {
        Some((key, range)) => {
            let message =
                format!("{key} runs from {} to {}: a picture needs one value", range.min, range.max);
            Err(Fault::contents(key, message))
        }
        None => Ok(()),
    }
}

fn check_sun(sun: &Sun) -> Result<(), Fault> {
    Range::closed(-360.0, 360.0).check("sun.azimuth_deg", sun.azimuth_deg)?;
    up_to(10.0).check("sun.angular_radius_deg", sun.angular_radius_deg)?;
    each("sun.irradiance", sun.irradiance.as_ref().map_or(&[], |rgb| &rgb[..]), Range::closed(0.0, 100.0))
}

fn check_sky(sky: &Sky) -> Result<(), Fault> {
    check_optional("sky.share", sky.share, Range::closed(0.0, 10.0))?;
    check_optional("sky.turbidity", sky.turbidity, Range::closed(1.0, 10.0))?;
    match sky.model {
        SkyModel::Uniform => idle("sky", "in a uniform sky", &[("turbidity", sky.turbidity.is_some())]),
        SkyModel::Clear => idle("sky", "in clear air", &[("share", sky.share.is_some())]),
    }
}

fn check_camera(camera: &Camera) -> Result<(), Fault> {
    let [x, y, z] = camera.position_m;
    let plane = Range::closed(-1e9, 1e9);
    plane.check("camera.position_m.x", x)?;
    plane.check("camera.position_m.y", y)?;
    up_to(1e6).check("camera.position_m.z", z)?;
    Range::closed(-360.0, 360.0).check("camera.azimuth_deg", camera.azimuth_deg)?;
    Range::closed(-90.0, 90.0).check("camera.elevation_deg", camera.elevation_deg)?;
    Range::closed(0.01, 170.0).check("camera.field_of_view_deg", camera.field_of_view_deg)?;
    Range::closed(1.0, 16_384.0).check("camera.width", f64::from(camera.width))?;
    Range::closed(1.0, 16_384.0).check("camera.height", f64::from(camera.height))?;
    Ok(())
}

fn check_clouds(clouds: &Clouds) -> Result<(), Fault> {
    up_to(1e5).check("clouds.base_m", clouds.base_m)?;
    up_to(1e7).check("clouds.extent_m", clouds.extent_m)?;
    each("clouds.wind_m_per_s", &clouds.wind_m_per_s, Range::closed(-200.0, 200.0))?;
    check_optional("clouds.evolution_s", clouds.evolution_s, Range::closed(1.0, 1e7))?;
    check_optional("clouds.scale_m", clouds.scale_m, up_to(1e5))?;
    check_optional("clouds.side", clouds.side.map(f64::from), Range::closed(1.0, 8192.0))?;
    check_optional("clouds.cover", clouds.cover, Range::closed(0.01, 1.0))?;
    check_optional("clouds.cell_m", clouds.cell_m, up_to(clouds.extent_m))?;
    check_optional("clouds.octaves", clouds.octaves.map(f64::from), Range::closed(1.0, 16.0))?;
    if let Some(thickness) = &clouds.thickness_m {
        check_interval("clouds.thickness_m", thickness, Range::closed(0.0, 1e5))?;
        up_to(1e5).check("clouds.thickness_m.max", thickness.max)?;
    }
    source(clouds)
}

/// A pattern or a file, and no key that the other, or this pattern, would need.
fn source(clouds: &Clouds) -> Result<(), Fault> {
    let varied = [
        ("seed", clouds.seed.is_some()),
        ("cover", clouds.cover.is_some()),
        ("cell_m", clouds.cell_m.is_some()),
        ("octaves", clouds.octaves.is_some()),
        ("evolution_s", clouds.evolution_s.is_some()),
    ];
    let shaped = [
        ("pattern", clouds.pattern.is_some()),
        ("thickness_m", clouds.thickness_m.is_some()),
        ("side", clouds.side.is_some()),
    ];
    let flat = clouds.pattern == Some(Pattern::Flat);
    match (&clouds.file, clouds.scale_m) {
        (Some(_), None) => Err(Fault::contents("clouds.file", "clouds.scale_m is missing: a file needs it")),
        (None, Some(_)) => {
            Err(Fault::contents("clouds.scale_m", "clouds.scale_m means nothing without a file"))
        }
        (Some(_), Some(_)) => idle("clouds", "beside a file", shaped.iter().chain(&varied)),
        (None, None) if flat => idle("clouds", "in a flat layer", &varied),
        (None, None) => varied_thickness(clouds),
    }
}

/// What varies needs a range, and gaps need clouds that end in nothing.
fn varied_thickness(clouds: &Clouds) -> Result<(), Fault> {
    let Some(Interval { min, max }) = clouds.thickness_m else { return Ok(()) };
    let key = "clouds.thickness_m";
    if min == max {
        return Err(Fault::contents(
            key,
            format!("{key} = {min}: this pattern needs {{ min = .., max = .. }}"),
        ));
    }
    match clouds.cover {
        Some(cover) if cover < 1.0 && min > 0.0 => {
            let message = format!("{key}.min = {min}: clouds that cover a share of {cover} begin at 0");
            Err(Fault::contents(key, message))
        }
        _ => Ok(()),
    }
}

/// Refuses the first key that is written although it changes nothing.
fn idle<'a>(
    table: &str,
    place: &str,
    keys: impl IntoIterator<Item = &'a (&'static str, bool)>,
) -> Result<(), Fault> {
    match keys.into_iter().find(|(_, written)| *written) {
        Some((key, _)) => {
            let key = format!("{table}.{key}");
            Err(Fault::contents(&key, format!("{key} means nothing {place}")))
        }
        None => Ok(()),
    }
}

fn check_ground(ground: &Ground) -> Result<(), Fault> {
    let share = Range::closed(0.0, 1.0);
    if let Some(albedo) = ground.albedo {
        each("ground.albedo", &albedo.rgb(), share)?;
    }
    for albedo in ground.albedos.iter().flatten() {
        each("ground.albedos", &albedo.rgb(), share)?;
    }
    check_optional("ground.extent_m", ground.extent_m, up_to(1e7))?;
    check_optional("ground.side", ground.side.map(f64::from), Range::closed(1.0, 8192.0))?;
    check_optional("ground.cell_m", ground.cell_m, up_to(1e7))?;
    let sources = [ground.albedo.is_some(), ground.pattern.is_some(), ground.image.is_some()];
    if sources.iter().filter(|given| **given).count() != 1 {
        return Err(Fault::contents("ground", "ground needs one of albedo, pattern and image"));
    }
    let of_patterns = [("albedos", ground.albedos.is_some()), ("side", ground.side.is_some())];
    let of_noise = [("cell_m", ground.cell_m.is_some()), ("seed", ground.seed.is_some())];
    match ground.pattern {
        None => idle("ground", "without a pattern", of_patterns.iter().chain(&of_noise)),
        Some(GroundPattern::WaterIce) => idle("ground", "with a straight edge", &of_noise),
        Some(GroundPattern::Checker) => idle("ground", "in a checker", &of_noise[1..]),
        Some(_) => Ok(()),
    }
}

fn check_radiosity(radiosity: &Radiosity) -> Result<(), Fault> {
    Range::closed(1.0, 1024.0).check("radiosity.side", f64::from(radiosity.side))?;
    if !radiosity.side.is_power_of_two() {
        let message = format!("radiosity.side = {} is not a power of two", radiosity.side);
        return Err(Fault::contents("radiosity.side", message));
    }
    let passes = radiosity.passes.map(f64::from);
    check_optional("radiosity.passes", passes, Range::closed(0.0, 64.0))?;
    Range::open(0.0, 1.0).check("radiosity.error", radiosity.error)?;
    Ok(())
}

fn each(key: &str, values: &[f64], range: Range) -> Result<(), Fault> {
    values.iter().try_for_each(|value| Ok(range.check(key, *value).map(drop)?))
}
