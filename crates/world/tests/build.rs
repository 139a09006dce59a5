//! Worlds of scenes: what they hold, and what is refused.

#![allow(clippy::unwrap_used, reason = "a test may stop where it fails")]

use std::f64::consts::PI;
use std::path::Path;
use stratiform_scene::{PICTURES, Scene};
use stratiform_world::{Sky, World};

const SCENES: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../fit-configs/scenes");

fn text(name: &str) -> String {
    std::fs::read_to_string(format!("{SCENES}/{name}.toml")).unwrap()
}

fn built(text: &str) -> Result<World, String> {
    let scene = Scene::parse(text, "a.toml").map_err(|error| error.to_string())?;
    World::build(&scene, Path::new(SCENES), 0.0).map_err(|error| error.to_string())
}

/// The message for the default scene with `from` replaced by `to`.
fn refused(from: &str, to: &str) -> String {
    let whole = text("stratocumulus");
    let changed = whole.replacen(from, to, 1);
    assert_ne!(changed, whole, "{from} is not there");
    built(&changed).unwrap_err()
}

#[test]
fn every_picture_is_a_world() {
    for name in PICTURES {
        let world = built(&text(name)).unwrap_or_else(|error| panic!("{name}: {error}"));
        assert!(world.field.most() > 0.0 && world.field.most() <= 5000.0, "{name}");
        assert!((world.sun.direction.length() - 1.0).abs() < 1e-15);
    }
}

#[test]
fn the_default_is_the_papers() {
    let world = built(&text("stratocumulus")).unwrap();
    assert_eq!(
        (world.field.map().side(), world.field.map().extent_m(), world.base_m),
        (512, 16_000.0, 2000.0)
    );
    assert!(world.field.most() <= 500.0 && world.field.most() > 490.0);
    assert_eq!(world.ground.albedo.value(1.0, 2.0), [0.2; 3]);
    assert_eq!(world.sky, Sky::Uniform([0.25 / PI; 3]));
    assert!((world.material.extinction_per_m - 300e-6 * PI * 49.0).abs() < 1e-15);
    assert!((world.sun.direction.z - libm::cos(65.0 * PI / 180.0)).abs() < 1e-15);
}

#[test]
fn a_clear_sky_colours_the_sun_unless_the_scene_does() {
    let whole = text("stratocumulus");
    let clear = whole.replacen("model = \"uniform\"\nshare = 0.25", "model = \"clear\"\nturbidity = 3.0", 1);
    let world = built(&clear).unwrap();
    let Sky::Clear(sky) = &world.sky else { panic!("not clear") };
    assert_eq!((sky.air().turbidity, sky.air().altitude_m, sky.air().ground_albedo), (3.0, 2000.0, 0.2));
    assert!(
        world.sun.irradiance == sky.sun_irradiance() && world.sun.irradiance[0] > world.sun.irradiance[2]
    );
    let white = clear.replacen("[sun]", "[sun]\nirradiance = [1, 1, 1]", 1);
    assert_eq!(built(&white).unwrap().sun.irradiance, [1.0; 3]);
}

#[test]
fn a_camera_in_the_cloud_is_refused_and_one_between_bumps_is_not() {
    let at = |x: f64, y: f64, z: f64| {
        let position = format!("position_m = [{x:?}, {y:?}, {z:?}]");
        built(&text("stratocumulus").replacen("position_m = [0.0, 0.0, 4000.0]", &position, 1))
    };
    let field = built(&text("stratocumulus")).unwrap().field;
    let places: Vec<_> = (0..160).map(|i| (100.0 * f64::from(i), 50.0)).collect();
    let thick = places.iter().find(|(x, y)| field.thickness(*x, *y) > 200.0).unwrap();
    let clear = places.iter().find(|(x, y)| field.thickness(*x, *y) == 0.0).unwrap();
    let error = at(thick.0, thick.1, 2150.0).unwrap_err();
    assert!(
        error.contains("camera.position_m = [") && error.contains("2150] is inside the cloud"),
        "{error}"
    );
    assert!(at(thick.0, thick.1, 2600.0).is_ok() && at(clear.0, clear.1, 2150.0).is_ok());
    assert!(
        at(0.0, 0.0, -1.0)
            .unwrap_err()
            .starts_with("a.toml:8: camera.position_m.z = -1 is outside (0, 1000000]")
    );
    assert!(at(0.0, 0.0, 2e6).unwrap_err().contains("camera.position_m.z = 2000000"));
}

#[test]
fn tables_of_another_cloud_are_refused() {
    let error = refused("theta_f_deg = 5.0", "theta_f_deg = 4.0");
    assert!(
        error.contains("appendix-b") && error.contains("theta_f_deg is 4 in the scene and 5 in the folder"),
        "{error}"
    );
    let error = refused("number_density_per_cm3 = 300.0", "number_density_per_cm3 = 100.0");
    assert!(error.contains("number_density_per_cm3") && error.contains("0.04618"), "{error}");
    assert!(
        refused("single_scattering_albedo = 1.0", "single_scattering_albedo = 0.9999").contains("0.9999")
    );
    assert!(refused("../appendix-b", "../no-such").contains("no-such"));
}

#[test]
fn scenes_that_are_no_pictures_are_refused() {
    assert!(built(&text("thin-veil")).unwrap_err().contains("`Thin veil before the sun` is no picture"));
}
