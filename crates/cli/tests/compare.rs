//! Pictures against truths that are known: one that the renderer drew itself, and a traced one.
#![cfg(feature = "gpu")]
#![allow(clippy::unwrap_used, reason = "a test may stop where it fails")]

#[path = "../../gpu/tests/device/mod.rs"]
mod device;
#[path = "../../render/tests/worlds/mod.rs"]
mod worlds;

use clap::Parser;
use std::fs;
use std::path::Path;
use stratiform_artifact::AblationRow;
use stratiform_cli::compare::{Draw, Part, Subject, Truth, ablation, costs, pictures, rows};
use stratiform_cli::{Cli, CliError, run};
use stratiform_imaging::{Image, Tone};
use stratiform_pathtrace::{Request, Stop, trace};
use stratiform_render::{Contributions, Model, Settings};
use stratiform_world::{Contribution, World};

const SIZE: [usize; 2] = [16, 9];

fn world() -> World {
    worlds::world(worlds::hills(32, 300.0), worlds::below(SIZE), 0.05)
}

fn subject<'a>(world: &'a World, models: &'a [Model]) -> Subject<'a> {
    let settings = Settings { model: models[0], ..Settings::default() };
    Subject { name: "hills", world, settings, models, tone: Tone::at(1.0) }
}

/// What the renderer draws, said to be exact.
fn own(draw: &mut Draw, settings: &Settings) -> Truth {
    let zero = |image: &Image| image.map(|_| [0.0; 3]);
    let parts = Contribution::ALL.map(|part| {
        let contributions = Contributions::none().with(part);
        let image = draw.picture(&Settings { contributions, ..*settings }).unwrap();
        let error = zero(&image);
        (part, image, error)
    });
    let mean = draw.picture(settings).unwrap();
    let error = zero(&mean);
    Truth::new((mean, error), parts.to_vec(), "its own picture")
}

#[test]
fn its_own_picture_is_true_and_one_without_a_part_is_not() {
    let Some(gpu) = device::device() else { return };
    let world = world();
    let subject = subject(&world, &[Model::Angular]);
    let mut draw = Draw::new(&gpu, &world, &subject.settings, 2).unwrap();
    let truth = own(&mut draw, &subject.settings);
    let (rows, _) = rows(&subject, &truth, &mut draw).unwrap();
    assert_eq!(rows.len(), 4 * Part::of_model(Model::Angular).len());
    for row in &rows {
        assert!(row.worst == 0.0 && row.excess_rms == 0.0 && row.beyond_3_sigma == 0.0, "{row:?}");
    }
    let table = ablation(&subject, &truth, &mut draw, |_| ()).unwrap();
    let of = |change: &str| table.iter().find(|row| row.change == change).unwrap();
    assert_eq!((of(AblationRow::NOTHING).error, of(AblationRow::NOTHING).difference), (0.0, 0.0));
    for change in
        ["without multiple", "without sky", "radiosity passes 0", "fitted model", "vertical normals"]
    {
        let row = of(change);
        assert!(row.error > 1e-3 && row.rise == row.error && row.flip > 0.0, "{row:?}");
        // Against an exact truth that is the unchanged picture, the two are one.
        assert!((row.error - row.difference).abs() < 1e-9 * row.error, "{row:?}");
    }
}

#[test]
fn a_traced_truth_gives_rows_pictures_and_a_page() {
    let Some(gpu) = device::device() else { return };
    let world = world();
    let subject = subject(&world, &[Model::Fitted, Model::Angular]);
    let request = Request { stop: Stop::Samples(4), crop: None, seed: 1 };
    let truth = Truth::of(trace(&world, &request).unwrap(), 1);
    let mut draw = Draw::new(&gpu, &world, &subject.settings, 1).unwrap();
    let (rows, compared) = rows(&subject, &truth, &mut draw).unwrap();
    assert_eq!(rows.len(), 4 * (7 + 8));
    let all = |model: &str| {
        let found =
            rows.iter().find(|r| r.contribution == "all" && r.model == model && r.band == "luminance");
        found.unwrap()
    };
    // Both models are within a factor of two of the truth's mean here: a picture of something else is not.
    for model in ["fitted", "angular"] {
        let ratio = all(model).mean_picture / all(model).mean_truth;
        assert!((0.5..2.0).contains(&ratio), "{model}: {ratio}");
    }
    let dir = tempfile::tempdir().unwrap();
    let written = pictures(dir.path(), &subject, &compared).unwrap();
    for picture in &written {
        assert!(fs::read_to_string(dir.path().join(&picture.file)).unwrap().starts_with("<svg "));
        assert!(dir.path().join(&picture.file).with_extension("png").exists());
    }
    assert_eq!(written.iter().filter(|picture| picture.kind == "flip").count(), 2);
    assert_eq!(written.iter().filter(|picture| picture.kind == "truth").count(), 1 + 7 + 1);
}

#[test]
fn costs_are_of_every_size_and_pass() {
    let Some(gpu) = device::device() else { return };
    let world = world();
    let subject = subject(&world, &[Model::Fitted]);
    let rows = costs(&gpu, &subject, &[[16, 9], [32, 18]], |_| ()).unwrap();
    assert!(rows.iter().all(|row| row.ms >= 0.0 && row.ms.is_finite()));
    for passes in [Some(0), Some(8), None] {
        let sizes: Vec<u64> = rows
            .iter()
            .filter(|r| r.radiosity_passes == passes && r.pass == "picture")
            .map(|r| r.width)
            .collect();
        assert_eq!(sizes, [16, 32]);
    }
}

/// The command with a scene of the project.
fn command(out: &Path, more: &[&str]) -> Result<String, CliError> {
    let scene = concat!(env!("CARGO_MANIFEST_DIR"), "/../../fit-configs/scenes/stratocumulus.toml");
    let out = out.to_str().unwrap();
    let words = ["stratiform", "--quiet", "compare", scene, "--out", out, "--oversample", "1"];
    run(&Cli::try_parse_from(words.iter().chain(more)).unwrap())
}

#[test]
fn the_command_writes_everything_and_takes_its_own_truth_back() {
    if device::device().is_none() {
        return;
    }
    let dir = tempfile::tempdir().unwrap();
    let (a, b) = (dir.path().join("a"), dir.path().join("b"));
    let printed = command(&a, &["--size", "16x9", "--samples", "2", "--model", "fitted"]).unwrap();
    assert_eq!(printed, fs::read_to_string(a.join("comparison.csv")).unwrap());
    for name in ["comparison.html", "comparison.json", "truth.exr", "all-fitted-flip.svg", "all-truth.png"] {
        assert!(a.join(name).exists(), "{name}");
    }
    assert!(!a.join("ablation.csv").exists());
    let truth = a.join("truth.exr");
    let read = ["--truth", truth.to_str().unwrap(), "--model", "fitted"];
    assert_eq!(command(&b, &read).unwrap(), printed, "the truth that was written is the truth");
    // What does not fit is refused, and nothing is written.
    let none = dir.path().join("none");
    let error = command(&none, &[&read[..], &["--size", "32x18"]].concat()).err().unwrap().to_string();
    assert!(error.contains("32 x 18") && error.contains("16 x 9"), "{error}");
    fs::write(&truth, "no picture").unwrap();
    assert!(command(&none, &read).err().unwrap().to_string().contains("truth.exr"));
    assert!(!none.exists());
}
