//! The chain on a small run, from either source: every file is there, nothing runs twice, and the bytes depend on the seed
//! alone.

#![allow(clippy::unwrap_used, reason = "a test may stop where it fails")]

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use stratiform_cli::config::{Config, Source};
use stratiform_cli::output::Talk;
use stratiform_cli::pipeline::{Target, run};
use stratiform_optics::droplets::DropletDistribution;
use stratiform_tests::paper_config;

/// The paper's cloud with few photons and a coarse quadrature.
fn small(source: Source) -> Config {
    let mut config = paper_config();
    config.transport.source = source;
    config.transport.photons = Some(2_000);
    config.transport.photons_between = Some(500);
    let convergence = config.convergence.as_mut().unwrap();
    convergence.plain_photons = vec![100, 300];
    convergence.half_space_photons = vec![100, 300];
    convergence.most_radii = 256;
    let plane = config.principal_plane.as_mut().unwrap();
    (plane.full_photons, plane.view_photons) = (5_000, 100);
    plane.scenes.truncate(1);
    config.transport.tolerance = 1e-4;
    config.optics.wavelengths_um = vec![0.55];
    config.colour.wavelengths_um = vec![0.45, 0.55, 0.65];
    config.optics.tolerance.asymmetry = 2e-3;
    config.optics.tolerance.forward_fraction = 2e-3;
    config.optics.tolerance.moments = 2e-3;
    config.optics.tolerance.phase_below_60_deg = 3e-2;
    config.optics.tolerance.phase_beyond_60_deg = 0.1;
    config
}

fn files(folder: &Path, under: &str, found: &mut BTreeMap<String, Vec<u8>>) {
    for entry in fs::read_dir(folder).unwrap().map(Result::unwrap) {
        let name = format!("{under}{}", entry.file_name().to_string_lossy());
        if entry.path().is_dir() {
            files(&entry.path(), &format!("{name}/"), found);
        } else {
            found.insert(name, fs::read(entry.path()).unwrap());
        }
    }
}

fn all(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    let mut found = BTreeMap::new();
    files(folder, "", &mut found);
    found
}

/// Files that hold wall times, or draw them.
fn is_timed(name: &str) -> bool {
    name == "manifest.json"
        || name.contains("convergence")
        || name.contains("quadrature")
        || name.contains("solver")
        || name == "report.html"
}

#[test]
fn tracing_leaves_every_file_once_and_the_same_bytes_twice() {
    let (config, first, once) = leaves_every_file_once_and_the_same_bytes_twice(Source::Trace);
    let mut changed = config.clone();
    changed.transport.seed = Some(1);
    run(&changed, first.path(), Target::Fit, Talk { quiet: true }).unwrap();
    let now = all(first.path());
    assert!(
        now["orders.csv"] != once["orders.csv"] && now["optics/optics.json"] == once["optics/optics.json"]
    );
}

/// The seed moves the witness only, and without photons and convergence nothing of theirs is left.
#[test]
fn solving_leaves_every_file_once_and_the_same_bytes_twice() {
    let (mut config, dir, once) = leaves_every_file_once_and_the_same_bytes_twice(Source::Solve);
    let talk = Talk { quiet: true };
    config.transport.seed = Some(1);
    run(&config, dir.path(), Target::Report, talk).unwrap();
    let now = all(dir.path());
    assert!(
        now["parameters.json"] == once["parameters.json"] && now["agreement.csv"] != once["agreement.csv"]
    );

    config.transport.photons = None;
    config.transport.seed = None;
    config.convergence = None;
    run(&config, dir.path(), Target::Report, talk).unwrap();
    let now = all(dir.path());
    for name in ["parameters.json", "orders.csv", "generated/stratiform.wgsl"] {
        assert!(now[name] == once[name], "{name} depends on photons");
    }
    for name in now.keys() {
        let of_photons = ["agreement", "witness", "convergence", "quadrature"];
        assert!(of_photons.iter().all(|word| !name.contains(word)), "{name} is left over");
    }
    let page = String::from_utf8_lossy(&now["report.html"]);
    assert!(page.contains("no file <code>convergence.csv</code>"));
}

type Files = BTreeMap<String, Vec<u8>>;

fn leaves_every_file_once_and_the_same_bytes_twice(source: Source) -> (Config, tempfile::TempDir, Files) {
    let (first, second) = (tempfile::tempdir().unwrap(), tempfile::tempdir().unwrap());
    let (config, talk) = (small(source), Talk { quiet: true });
    run(&config, first.path(), Target::Report, talk).unwrap();
    let once = all(first.path());
    for name in [
        "accepted/reference.csv",
        "accepted/phase_colour.csv",
        "agreement.csv",
        "agreement.json",
        "convergence.csv",
        "figures/principal-plane.csv",
        "generated/stratiform.wgsl",
        "manifest.json",
        "notes.json",
        "optics/optics.json",
        "orders.csv",
        "parameters.csv",
        "parameters.json",
        "report.html",
    ] {
        assert!(once.contains_key(name), "{name} is missing");
    }
    assert!(once.keys().filter(|name| name.starts_with("figures/")).count() >= 5);
    assert!(once.keys().all(|name| !name.contains("partial")));

    run(&config, first.path(), Target::Report, talk).unwrap();
    assert!(all(first.path()) == once, "an unchanged stage ran again");

    run(&config, second.path(), Target::Report, talk).unwrap();
    for (name, bytes) in all(second.path()).iter().filter(|(name, _)| !is_timed(name)) {
        assert!(*bytes == once[name], "{name} differs between two runs");
    }
    (config, first, once)
}

/// A cloud that nobody published a table for, of droplets of one size: nothing is compared, and the report is made.
#[test]
fn another_cloud_is_compared_with_nothing() {
    let dir = tempfile::tempdir().unwrap();
    let talk = Talk { quiet: true };
    let mut config = small(Source::Trace);
    config.transport.photons = Some(500);
    config.transport.photons_between = Some(100);
    config.fit.thickness_m.max = 50.0;
    config.published_table = None;
    config.optics.droplets = DropletDistribution::SingleSize { radius_um: 2.0 };
    run(&config, dir.path(), Target::Report, talk).unwrap();
    let files = all(dir.path());
    assert!(files.contains_key("report.html") && !files.contains_key("published.csv"));
    let page = String::from_utf8_lossy(&files["report.html"]);
    assert!(!page.contains("Bouthors, Neyret &amp; Lefebvre, Real-time"), "the published source is named");
    assert!(String::from_utf8_lossy(&files["curves.csv"]).lines().all(|line| !line.contains("published")));
}
