//! Media of tests and benchmarks.

#![allow(clippy::unwrap_used, dead_code, reason = "a test may stop where it fails, and uses what it needs")]

use std::sync::{Arc, OnceLock};
use stratiform_optics::droplets::DropletDistribution;
use stratiform_optics::ensemble::{EnsembleSpec, QuadratureTolerance, ensemble};
use stratiform_optics::phase::{HenyeyGreenstein, Modified, PhaseFunction};
use stratiform_optics::water::WaterTable;
use stratiform_quantities::{Asymmetry, SingleScatteringAlbedo};
use stratiform_transport::TraceMedium;

fn albedo(omega: f64) -> SingleScatteringAlbedo {
    SingleScatteringAlbedo::new(omega).unwrap()
}

/// A Henyey-Greenstein medium.
pub fn hg(g: f64, omega: f64) -> TraceMedium {
    TraceMedium::full(Arc::new(HenyeyGreenstein::new(Asymmetry::new(g).unwrap())), albedo(omega))
}

/// The paper's cloud at 0.55 µm: γ = 2, r_e = 7 µm; computed once.
fn droplets() -> Arc<dyn PhaseFunction> {
    static CLOUD: OnceLock<Arc<dyn PhaseFunction>> = OnceLock::new();
    CLOUD.get_or_init(computed).clone()
}

fn computed() -> Arc<dyn PhaseFunction> {
    let spec = EnsembleSpec {
        droplets: &DropletDistribution::ModifiedGamma { gamma: 2.0, effective_radius_um: 7.0 }
            .resolve()
            .unwrap(),
        number_density_per_cm3: 300.0,
        wavelength_um: 0.55,
        refractive_index: WaterTable::HaleQuerry1973.at(0.55).unwrap(),
        theta_f_deg: 5.0,
        tolerance: QuadratureTolerance::default(),
    };
    Arc::new(ensemble(&spec).unwrap().phase)
}

/// The cloud as it is.
pub fn cloud(omega: f64) -> TraceMedium {
    TraceMedium::full(droplets(), albedo(omega))
}

/// The cloud whose scattering within 5° counts as none.
pub fn cut_cloud(omega: f64) -> TraceMedium {
    let cut = Modified::new(droplets(), 5.0).unwrap();
    let forward = cut.forward_fraction();
    TraceMedium::modified(Arc::new(cut), albedo(omega), forward).unwrap()
}
