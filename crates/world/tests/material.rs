//! A material read from folders, whole and damaged.
#![allow(clippy::unwrap_used, reason = "a test may stop where it fails")]

use std::path::{Path, PathBuf};
use stratiform_optics::phase::PhaseFunction;
use stratiform_world::Material;

fn committed(name: &str) -> PathBuf {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../../fit-configs")).join(name)
}

/// The medium of the paper's cloud: N0 π r_e² = 300e6 π (7e-6)².
#[test]
fn the_papers_cloud_loads() {
    let material = Material::load(&committed("appendix-b")).unwrap();
    let kappa = 300e6 * std::f64::consts::PI * 49e-12;
    assert!((material.extinction_per_m / kappa - 1.0).abs() < 1e-12);
    let share = material.phase.forward_fraction(material.theta_f_deg).unwrap();
    assert!((share - material.forward_fraction).abs() < 1e-6, "{share}");
    assert!((material.phase.asymmetry() - material.asymmetry).abs() < 1e-4);
}
