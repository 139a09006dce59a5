//! Every committed config is sound, and the committed emitted text is fresh.

#![allow(clippy::unwrap_used, reason = "a test may stop where it fails")]

use std::fs;
use std::path::PathBuf;
use stratiform_artifact::PhaseColour;
use stratiform_cli::config::Config;
use stratiform_cli::pipeline::{accepted, colour};
use stratiform_scene::Scene;
use stratiform_tests::root;

fn configs() -> Vec<PathBuf> {
    let entries = fs::read_dir(root().join("fit-configs")).unwrap().map(|entry| entry.unwrap().path());
    entries.filter(|path| path.extension().is_some_and(|e| e == "toml")).collect()
}

#[test]
fn every_config_loads() {
    assert!(!configs().is_empty());
    for path in configs() {
        Config::load(&path).unwrap_or_else(|error| panic!("{error}"));
    }
}

/// What is accepted was made from the settings that stand in the config now.
#[test]
fn accepted_parameters_belong_to_their_config() {
    for path in configs() {
        let config = Config::load(&path).unwrap();
        let accepted = accepted::read(&root().join("fit-configs").join(&config.codegen.accepted)).unwrap();
        let provenance = stratiform_cli::pipeline::provenance(&config);
        assert_eq!(
            accepted.parameters.provenance,
            provenance,
            "{}: reproduce it and accept the result",
            path.display()
        );
    }
}

/// So were the phase functions in colour, which the clouds that are drawn have.
#[test]
fn accepted_colours_belong_to_their_config() {
    let mut found = 0;
    for path in configs() {
        let config = Config::load(&path).unwrap();
        let file = root().join("fit-configs").join(&config.codegen.accepted).join(colour::FILE);
        if file.exists() {
            let table = PhaseColour::read(&file).unwrap();
            let hash = stratiform_cli::pipeline::provenance(&config).config_hash;
            assert_eq!((table.config_hash, table.wavelengths_um), (hash, config.colour.wavelengths_um));
            found += 1;
        }
    }
    assert!(found >= 2, "guard against checking nothing");
}

/// What a library stands below.
fn above(name: &str) -> &'static [&'static str] {
    match name {
        "stratiform_weights.wgsl" => &["stratiform.wgsl"],
        "stratiform_radiance.wgsl" | "stratiform_shade.wgsl" | "stratiform_halo.wgsl" => {
            &["stratiform.wgsl", "stratiform_weights.wgsl", "stratiform_phase.wgsl"]
        }
        "stratiform_family.wgsl" => &["stratiform.wgsl"],
        "stratiform_family_phase.wgsl" => &["stratiform_phase.wgsl"],
        _ => &[],
    }
}

#[test]
fn emitted_text_is_fresh_and_valid() {
    for path in configs() {
        let config = Config::load(&path).unwrap();
        let folder = root().join("fit-configs");
        let kept = folder.join(&config.codegen.accepted);
        let files = accepted::emitted(&config, &accepted::read(&kept).unwrap(), &kept).unwrap();
        if let Err(stale) = stratiform_codegen::check(&files, &folder.join(&config.codegen.output)) {
            let list: Vec<_> = stale.iter().map(ToString::to_string).collect();
            panic!("{}", list.join("\n"));
        }
        for name in files.names().filter(|name| name.ends_with(".wgsl")) {
            // The self-test is a part that stands before the model.
            let text = if name.contains("self_test") {
                stratiform_codegen::self_test_module(&files).unwrap()
            } else {
                let text = |name: &str| files.text(name).unwrap();
                above(name).iter().map(|name| text(name)).chain([text(name)]).collect()
            };
            let module = naga::front::wgsl::parse_str(&text).unwrap_or_else(|e| panic!("{name}: {e}"));
            let flags = naga::valid::ValidationFlags::all();
            naga::valid::Validator::new(flags, naga::valid::Capabilities::empty())
                .validate(&module)
                .unwrap_or_else(|error| panic!("{name}: {error}"));
        }
    }
}

/// Every committed scene is sound and goes by the name of its file.
#[test]
fn every_scene_loads_and_is_named() {
    let files = fs::read_dir(root().join("fit-configs/scenes")).unwrap().map(|entry| entry.unwrap().path());
    let mut names: Vec<_> = files
        .map(|path| {
            let scene = Scene::load(&path).unwrap_or_else(|error| panic!("{error}"));
            let name = path.file_stem().unwrap().to_str().unwrap().to_owned();
            assert_eq!(scene, stratiform_scene::named(&name).unwrap());
            name
        })
        .collect();
    let mut known = [stratiform_scene::NAMES, stratiform_scene::PICTURES].concat();
    names.sort();
    known.sort_unstable();
    assert_eq!(names, known);
}
