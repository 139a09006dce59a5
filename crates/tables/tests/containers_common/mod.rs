//! The sets that the containers' tests write.

#![allow(dead_code, reason = "each test file uses its part")]

use std::path::Path;
use std::sync::OnceLock;
use stratiform_artifact::{ParametersDocument, Provenance, read_json};
use stratiform_optics::phase::{HenyeyGreenstein, Norm, PhaseFunction, PhaseTable};
use stratiform_quantities::Asymmetry;
use stratiform_tables::parameters::ParameterTexels;
use stratiform_tables::set::{About, Channel, ChannelMedium, PhaseSet};

/// The accepted artifacts of the paper's cloud.
pub const ACCEPTED: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../fit-configs/appendix-b/accepted");

/// P of the paper's cloud at 0.55 µm.
pub fn cloud() -> PhaseTable {
    PhaseTable::read(&Path::new(ACCEPTED).join("phase_full.csv"), Norm::Strict).unwrap()
}

/// A Henyey–Greenstein function at 1001 angles that crowd at both ends.
pub fn henyey_greenstein(g: f64) -> PhaseTable {
    let hg = HenyeyGreenstein::new(Asymmetry::new(g).unwrap());
    let theta: Vec<f64> = (0..=1000)
        .map(|i| {
            let x = f64::from(i) / 1000.0;
            180.0 * x * x * (3.0 - 2.0 * x)
        })
        .collect();
    let p = theta.iter().map(|degrees| {
        let sine = libm::sin(0.5 * degrees.to_radians());
        hg.value(2.0 * sine * sine)
    });
    PhaseTable::new(theta.clone(), p.collect(), Norm::Strict).unwrap()
}

fn medium(wavelength_um: f64) -> ChannelMedium {
    ChannelMedium {
        wavelength_um,
        refractive_index: [1.333, 0.0],
        single_scattering_albedo: 1.0,
        extinction_paper_per_m: 0.0462,
        extinction_mie_per_m: 0.0368,
        asymmetry: 0.853,
        forward_fraction: 0.455,
    }
}

/// Tables under the wavelengths 0.65, 0.55, 0.5325, 0.45, 0.4 µm, as many as there are.
pub fn set(tables: Vec<PhaseTable>) -> PhaseSet {
    let wavelengths = [0.65, 0.55, 0.5325, 0.45, 0.4];
    let about = About {
        title: "Wolke über der Stadt, r_e = 7 µm, 雲 ☁ 🌈".to_owned(),
        droplets: "modified gamma".to_owned(),
        effective_radius_um: 7.0,
        effective_variance: 0.25,
        number_density_per_cm3: 300.0,
        theta_f_deg: 5.0,
        medium: wavelengths.iter().take(tables.len()).map(|um| medium(*um)).collect(),
        provenance: Provenance::new("0".repeat(32), None, "a test"),
    };
    let channels = wavelengths.into_iter().map(Channel::WavelengthUm);
    PhaseSet::new(channels.zip(tables).collect(), about).unwrap()
}

/// The paper's cloud and two smooth functions.
pub fn three() -> &'static PhaseSet {
    static SET: OnceLock<PhaseSet> = OnceLock::new();
    SET.get_or_init(|| set(vec![cloud(), henyey_greenstein(0.85), henyey_greenstein(0.5)]))
}

/// The accepted parameters.
pub fn parameters() -> ParameterTexels {
    let document: ParametersDocument = read_json(&Path::new(ACCEPTED).join("parameters.json")).unwrap();
    ParameterTexels::new(&document).unwrap()
}
