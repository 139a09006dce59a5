//! Radiance against published intensities.

#![allow(clippy::unwrap_used, reason = "a test stops where it fails")]

mod common;

use common::published::coefficients;
use common::{hg, isotropic};
use std::sync::Arc;
use stratiform_optics::phase::Rayleigh;
use stratiform_quantities::SingleScatteringAlbedo;
use stratiform_reference_data::rows;
use stratiform_transport::solve::{RadianceOrder, RadianceSolver, Side, SolveMedium, View};

/// One intensity as listed.
#[derive(serde::Deserialize)]
struct Row {
    case: String,
    phase: String,
    tau: f64,
    omega: f64,
    mu0: f64,
    beam_flux: f64,
    side: String,
    mu: f64,
    phi_deg: f64,
    intensity: f64,
}

impl Row {
    fn medium(&self) -> SolveMedium {
        let omega = SingleScatteringAlbedo::new(self.omega).unwrap();
        match self.phase.split_once(':') {
            None if self.phase == "isotropic" => SolveMedium::full(isotropic(), omega),
            None => SolveMedium::full(Arc::new(Rayleigh), omega),
            Some(("hg", g)) => SolveMedium::from_moments(hg(g.parse().unwrap()).moments(33), omega).unwrap(),
            Some((_, file)) => SolveMedium::from_moments({let c=coefficients(file); if self.case.starts_with("4") {c[..33].to_vec()} else {c}}, omega).unwrap(),
        }
    }

    fn view(&self) -> View {
        let side = if self.side == "top" { Side::Top } else { Side::Bottom };
        View { side, mu: self.mu, phi_deg: self.phi_deg }
    }

    /// Intensity from πL/(μ0F0).
    fn intensity(&self, value: f64) -> f64 {
        value * self.mu0 * self.beam_flux / std::f64::consts::PI
    }
}

#[test]
fn dump() {
    for row in rows::<Row>("disort-intensities", "intensities.csv").unwrap() {
        let solver = RadianceSolver::new(row.medium(), 1e-5).unwrap();
        match solver.radiance(&[row.tau], &[row.mu0], &[row.view()]) {
            Ok(solved) => {
                let total = solved.estimate(0, 0, 0, RadianceOrder::Total);
                let (value, error) = (row.intensity(total.value), row.intensity(total.std_error));
                println!("{} {} mu {} phi {}: {:.6e} {:.6e} rel {:.1e} err {:.1e} N {}", row.case, row.side, row.mu, row.phi_deg, value, row.intensity, value/row.intensity-1.0, error, solved.streams());
            }
            Err(e) => println!("{} {} mu {}: {e}", row.case, row.side, row.mu),
        }
    }
}
