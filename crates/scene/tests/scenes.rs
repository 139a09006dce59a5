//! What is read, and what is refused with which words.

#![allow(clippy::unwrap_used, reason = "a test may stop where it fails")]

use stratiform_scene::{Effect, NAMES, Scene, SceneError, find, named};

fn text() -> String {
    std::fs::read_to_string(concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/../../fit-configs/scenes/thick-overcast.toml"
    ))
    .unwrap()
}

/// The message for the scene with `from` replaced by `to`.
fn refused(from: &str, to: &str) -> String {
    let changed = text().replace(from, to);
    assert_ne!(changed, text(), "{from} is not there");
    Scene::parse(&changed, "a.toml").unwrap_err().to_string()
}

#[test]
fn named_scenes_are_sound_and_keep_every_key() {
    for name in NAMES {
        let scene = named(name).unwrap();
        let again = Scene::parse(&toml::to_string(&scene).unwrap(), name).unwrap();
        assert_eq!(scene, again);
    }
    assert!(named("glory-view").unwrap().visible.contains(&Effect::Glory));
    assert!(matches!(find("no-such"), Err(SceneError::Unknown { .. })));
}

#[test]
fn ranges_that_are_empty_inverted_or_no_numbers_are_refused_with_their_line() {
    let sun = "theta_deg = { min = 10.0, max = 75.0 }";
    assert_eq!(
        refused(sun, "theta_deg = { min = 75.0, max = 10.0 }"),
        "a.toml:20: sun.theta_deg = { min = 75, max = 10 } is inverted: max must not lie below min"
    );
    assert_eq!(
        refused(sun, "theta_deg = { min = nan, max = 10.0 }"),
        "a.toml:20: sun.theta_deg.min = NaN is outside [0, 90)"
    );
    assert_eq!(
        refused(sun, "theta_deg = { min = 10.0, max = 90.0 }"),
        "a.toml:20: sun.theta_deg.max = 90 is outside [0, 90)"
    );
    assert_eq!(refused("[\"top\", \"bottom\"]", "[]"), "a.toml:25: view.sides is empty: list at least one");
    assert!(refused("[0.65, 0.55, 0.45]", "[0.65, 0.65]").contains("lists 0.65 twice"));
    assert!(
        refused("effective_variance = 0.25", "effective_variance = inf")
            .contains("effective_variance = inf is outside (0, 0.5)")
    );
}

#[test]
fn the_ground_has_an_albedo_or_is_left_out() {
    assert_eq!(named("thick-overcast").unwrap().ground, None);
    let with = |albedo: &str| Scene::parse(&format!("{}\n[ground]\nalbedo = {albedo}\n", text()), "a.toml");
    assert_eq!(with("0.8").unwrap().ground.unwrap().mean_albedo(), Some(0.8));
    for albedo in ["-0.1", "1.1", "nan"] {
        assert!(with(albedo).unwrap_err().to_string().contains("ground.albedo"), "{albedo}");
    }
}

#[test]
fn keys_that_are_misspelt_missing_or_contradict_are_refused() {
    assert!(refused("azimuth_deg", "azimut_deg").starts_with("a.toml:24: unknown field"));
    assert!(refused("scene/1", "scene/2").starts_with("a.toml:2: schema"));
    assert!(
        refused("extinction_convention = \"paper\"", "").contains("layer.extinction_convention is missing")
    );
    assert!(refused("number_density_per_cm3 = 300.0", "").contains("number_density_per_cm3 is missing"));
    assert!(
        refused("[layer]", "[layer]\noptical_thickness = { min = 1, max = 2 }")
            .contains("one of optical_thickness and thickness_m")
    );
    assert!(refused("\"top\", \"bottom\"", "\"left\"").contains("left"));
    assert!(refused("single_scattering_albedo = 1.0", "single_scattering_albedo = 1.5").contains("1.5"));
}
