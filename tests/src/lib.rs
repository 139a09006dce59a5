//! What holds between the crates. The tests themselves are in `tests/`; here is what they share.

pub mod effects;
pub mod languages;

use std::fs;
use std::path::{Path, PathBuf};
use stratiform_artifact::ParametersDocument;
use stratiform_cli::config::Config;
use stratiform_cli::pipeline::accepted;
use stratiform_cli::pipeline::optics::Cloud;
use stratiform_cli::pipeline::photons::{self, Wanted};
use stratiform_cli::pipeline::reference::{Media, Plan};
use stratiform_fit::Reference;
use stratiform_optics::phase::{Norm, PhaseTable};
use stratiform_quantities::SingleScatteringAlbedo;

/// The root of the repository.
pub fn root() -> PathBuf {
    PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/.."))
}

/// Every source file in `folder`, in no order; what is built or generated left out.
///
/// # Panics
/// If a folder cannot be read: a test then fails.
#[expect(clippy::expect_used, reason = "for tests only")]
pub fn sources(folder: &Path) -> Vec<PathBuf> {
    let mut found = Vec::new();
    for entry in fs::read_dir(folder).expect("a folder that can be read") {
        let path = entry.expect("an entry that can be read").path();
        let name = path.file_name().and_then(|name| name.to_str());
        if path.is_dir() {
            if !matches!(name, Some("target" | ".git" | "out" | "generated")) {
                found.extend(sources(&path));
            }
        } else if path.extension().is_some_and(|e| e == "rs" || e == "wgsl" || e == "py") {
            found.push(path);
        }
    }
    found
}

/// The paper's config.
///
/// # Panics
/// If it cannot be read: a test then fails.
#[expect(clippy::expect_used, reason = "for tests only")]
pub fn paper_config() -> Config {
    Config::load(&root().join("fit-configs/appendix-b.toml")).expect("the config loads")
}

/// The committed parameters of the paper's cloud, and the cloud itself from the committed phase function, so that no test
/// computes Mie theory again.
///
/// # Panics
/// If a committed file is missing or damaged: a test then fails.
#[expect(clippy::expect_used, reason = "for tests only")]
pub fn accepted_cloud(config: &Config) -> (ParametersDocument, Cloud) {
    let folder = root().join("fit-configs").join(&config.codegen.accepted);
    let parameters = accepted::read(&folder).expect("the accepted artifacts").parameters;
    let medium = &parameters.medium;
    let cloud = Cloud {
        phase: PhaseTable::read(&folder.join("phase_full.csv"), Norm::Strict)
            .expect("the accepted phase function"),
        omega: SingleScatteringAlbedo::new(medium.single_scattering_albedo).expect("the accepted albedo"),
        extinction_per_m: medium.extinction_per_m,
        asymmetry: medium.asymmetry,
        forward_fraction: medium.forward_fraction,
    };
    (parameters, cloud)
}

/// A fresh Monte Carlo reference of every row of the table.
///
/// # Panics
/// If a trace fails: a test then fails.
#[expect(clippy::expect_used, reason = "for tests only")]
pub fn fresh_reference(config: &Config, cloud: &Cloud, photons: u64, seed: u64) -> Vec<Reference> {
    let plan = Plan::nodes(config, cloud, photons, seed);
    let media = Media::new(config, cloud).expect("the media");
    let traced = photons::trace(config, &media, &plan, Wanted::Fitted, &|_| ()).expect("the trace");
    traced.into_iter().map(|traced| traced.reference).collect()
}
