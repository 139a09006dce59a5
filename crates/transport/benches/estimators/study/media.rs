//! The two conservative media of the study.

use std::path::Path;
use std::sync::Arc;
use stratiform_optics::phase::{HenyeyGreenstein, Modified, Norm, PhaseFunction, PhaseTable};
use stratiform_quantities::{Asymmetry, SingleScatteringAlbedo};
use stratiform_transport::TraceMedium;

/// Henyey–Greenstein, g = 0.85.
pub fn henyey_greenstein() -> TraceMedium {
    medium(Arc::new(HenyeyGreenstein::new(Asymmetry::new(0.85).unwrap())))
}

/// The paper's cloud at 0.55 µm without its scattering below 5°, by its own extinction.
pub fn cloud() -> TraceMedium {
    let file = concat!(env!("CARGO_MANIFEST_DIR"), "/../../fit-configs/appendix-b/accepted/phase_full.csv");
    let phase = PhaseTable::read(Path::new(file), Norm::Strict).unwrap();
    medium(Arc::new(Modified::new(Arc::new(phase), 5.0).unwrap()))
}

fn medium(phase: Arc<dyn PhaseFunction>) -> TraceMedium {
    TraceMedium::full(phase, SingleScatteringAlbedo::CONSERVATIVE)
}
