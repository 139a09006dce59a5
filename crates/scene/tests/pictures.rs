//! Scenes that are pictures: what is read, derived, and refused with which words.

#![allow(clippy::unwrap_used, reason = "a test may stop where it fails")]

use stratiform_quantities::Side;
use stratiform_scene::{Interval, PICTURES, Pattern, Rings, Scene, SkyModel, named};

const TEXT: &str = r#"schema = "stratiform/scene/1"
title = "A picture"
wavelengths_um = [0.65, 0.55, 0.45]

[camera]
position_m = [0.0, 0.0, 2.0]
azimuth_deg = 180.0
elevation_deg = 40.0

[sun]
theta_deg = 40
azimuth_deg = 180.0

[clouds]
tables = "../appendix-b"
cover = 0.5
thickness_m = { min = 0.0, max = 400.0 }

[droplets]
effective_radius_um = 7.0
effective_variance = 0.25
number_density_per_cm3 = 300.0

[ground]
albedo = 0.2
"#;

fn parse(text: &str) -> Result<Scene, String> {
    Scene::parse(text, "a.toml").map_err(|error| error.to_string())
}

fn refused(from: &str, to: &str) -> String {
    let changed = TEXT.replacen(from, to, 1);
    assert_ne!(changed, TEXT, "{from} is not there");
    parse(&changed).unwrap_err()
}

#[test]
fn named_pictures_are_sound_and_keep_every_key() {
    for name in PICTURES {
        let scene = named(name).unwrap();
        assert!(scene.camera.is_some() && scene.clouds.is_some(), "{name}");
        assert_eq!(scene, Scene::parse(&toml::to_string(&scene).unwrap(), name).unwrap());
    }
}

#[test]
fn one_number_stands_for_both_ends_and_defaults_are_the_papers() {
    let scene = parse(TEXT).unwrap();
    assert_eq!((scene.sun.theta_deg, scene.sun.angular_radius_deg), (Interval::at(40.0), 0.2666));
    let clouds = scene.clouds.as_ref().unwrap().pattern_keys().unwrap();
    assert_eq!((clouds.pattern, clouds.side, clouds.cover), (Pattern::Stratocumulus, 512, 0.5));
    assert_eq!((scene.sky.model, scene.sky.share), (SkyModel::Uniform, None));
    assert_eq!((scene.radiosity.side, scene.radiosity.rings), (16, Rings::LeastSquares));
    let without = parse(TEXT.split("[ground]").next().unwrap()).unwrap();
    assert_eq!(without.ground_or_default().mean_albedo(), Some(0.2));
}

#[test]
fn view_and_layer_follow_from_camera_and_clouds_unless_written() {
    let scene = parse(TEXT).unwrap();
    assert_eq!(scene.view.sides, [Side::Bottom]);
    assert!(
        (scene.view.theta_deg.min - 25.0).abs() < 0.1 && (75.0..87.0).contains(&scene.view.theta_deg.max)
    );
    assert_eq!(scene.view.azimuth_deg.min, 0.0);
    assert_eq!(scene.layer.thickness_m, Some(Interval { min: 4.0, max: 400.0 }));
    let written =
        "[layer]\noptical_thickness = 3.0\n[view]\ntheta_deg = 5.0\nazimuth_deg = 0.0\nsides = [\"top\"]\n";
    let scene = parse(&format!("{TEXT}{written}")).unwrap();
    assert_eq!((scene.view.theta_deg.max, scene.layer.optical_thickness), (5.0, Some(Interval::at(3.0))));
}

#[test]
fn a_scene_without_camera_must_say_its_view_and_layer() {
    let (camera, clouds) = (TEXT.find("[camera]").unwrap(), TEXT.find("[clouds]").unwrap());
    let (sun, droplets) = (TEXT.find("[sun]").unwrap(), TEXT.find("[droplets]").unwrap());
    let bare = format!("{}{}{}", &TEXT[..camera], &TEXT[sun..clouds], &TEXT[droplets..]);
    assert!(parse(&bare).unwrap_err().contains("view is missing"));
    let without_clouds = format!("{}{}", &TEXT[..clouds], &TEXT[droplets..]);
    assert_eq!(
        parse(&without_clouds).unwrap_err(),
        "a.toml:5: clouds is missing: a camera needs something to see"
    );
    assert!(
        refused("elevation_deg = 40.0", "elevation_deg = -40.0")
            .starts_with("a.toml:8: the camera does not look")
    );
}

#[test]
fn numbers_out_of_their_domain_are_refused_with_their_line() {
    assert_eq!(
        refused("theta_deg = 40", "theta_deg = 90"),
        "a.toml:11: sun.theta_deg = 90 is outside [0, 90)"
    );
    assert!(refused("theta_deg = 40", "theta_deg = nan").contains("sun.theta_deg = NaN"));
    assert_eq!(
        refused("0.0, 2.0]", "0.0, 0.0]"),
        "a.toml:6: camera.position_m.z = 0 is outside (0, 1000000]"
    );
    assert!(refused("0.0, 2.0]", "inf, 2.0]").contains("camera.position_m.y = inf"));
    assert!(
        refused("azimuth_deg = 180.0", "azimuth_deg = nan").starts_with("a.toml:7: camera.azimuth_deg = NaN")
    );
    assert!(refused("elevation_deg = 40.0", "elevation_deg = 91.0").contains("camera.elevation_deg = 91"));
    assert!(
        refused("elevation_deg = 40.0", "elevation_deg = 9.0\nwidth = 0")
            .starts_with("a.toml:9: camera.width = 0")
    );
    assert!(refused("cover = 0.5", "cover = 1.5").contains("clouds.cover = 1.5 is outside [0.01, 1]"));
    assert!(refused("cover = 0.5", "base_m = -5.0").contains("clouds.base_m = -5"));
    assert!(refused("cover = 0.5", "wind_m_per_s = [nan, 0.0]").contains("clouds.wind_m_per_s = NaN"));
    assert!(refused("max = 400.0", "max = nan").contains("clouds.thickness_m.max = NaN"));
    assert!(
        refused("albedo = 0.2", "albedo = [0.1, 1.2, 0.3]").starts_with("a.toml:25: ground.albedo = 1.2")
    );
    for (table, says) in [
        ("[sky]\nshare = nan", "sky.share = NaN"),
        ("[sky]\nmodel = \"clear\"\nturbidity = 0.5", "sky.turbidity = 0.5 is outside [1, 10]"),
        ("[sky]\nmodel = \"clear\"\nshare = 0.5", "sky.share means nothing in clear air"),
        ("[sky]\nturbidity = 3.0", "sky.turbidity means nothing in a uniform sky"),
        ("[sky]\nmodel = \"clearer\"", "clearer"),
        ("[picture]\nexposure_ev = inf", "picture.exposure_ev = inf"),
        ("[radiosity]\nside = 12", "radiosity.side = 12 is not a power of two"),
        ("[radiosity]\nerror = 0.0", "radiosity.error = 0"),
    ] {
        assert!(parse(&format!("{TEXT}{table}\n")).unwrap_err().contains(says), "{says}");
    }
}

#[test]
fn keys_that_are_misspelt_contradict_or_do_nothing_are_refused() {
    assert!(refused("elevation_deg", "elevaton_deg").starts_with("a.toml:8: unknown field"));
    assert!(refused("cover = 0.5", "covr = 0.5").starts_with("a.toml:16: unknown field"));
    assert!(refused("cover = 0.5", "file = \"a.png\"").contains("clouds.scale_m is missing"));
    let file = "file = \"a.png\"\nscale_m = 9.0";
    assert!(refused("cover = 0.5", file).contains("clouds.thickness_m means nothing beside a file"));
    assert!(refused("cover = 0.5", "scale_m = 9.0").contains("clouds.scale_m means nothing without a file"));
    assert!(
        refused("cover = 0.5", "cover = 0.5\npattern = \"flat\"")
            .starts_with("a.toml:16: clouds.cover means nothing")
    );
    assert!(refused("min = 0.0, max = 400.0", "min = 50.0, max = 400.0").contains("begin at 0"));
    assert!(refused("{ min = 0.0, max = 400.0 }", "400.0").contains("this pattern needs"));
    assert!(refused("albedo = 0.2", "albedo = \"dark\"").contains("a number or [red, green, blue]"));
    assert!(
        refused("albedo = 0.2", "albedo = 0.2\nimage = \"a.png\"")
            .contains("one of albedo, pattern and image")
    );
    assert!(
        refused("albedo = 0.2", "albedo = 0.2\nseed = 1")
            .contains("ground.seed means nothing without a pattern")
    );
    let message = refused("theta_deg = 40", "theta_deg = { min = 30.0, max = 40.0 }");
    assert_eq!(message, "a.toml:11: sun.theta_deg runs from 30 to 40: a picture needs one value");
    let message = refused("effective_radius_um = 7.0", "effective_radius_um = { min = 7.0, max = 9.0 }");
    assert!(message.contains("droplets.effective_radius_um runs from 7 to 9"));
}
