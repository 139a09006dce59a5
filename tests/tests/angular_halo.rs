//! The halo of forward events against exact radiance: what the full medium has more than the modified one.

#![allow(clippy::unwrap_used, reason = "a test may stop where it fails")]

use std::sync::Arc;
use stratiform_cli::pipeline::reference::Media;
use stratiform_model::angular::halo::{Halo, Peak};
use stratiform_model::angular::{Angular, PhaseLookup, Sight};
use stratiform_optics::phase::{Halo as Events, HaloTable, PhaseFunction, PhaseTable, versine};
use stratiform_quantities::{Medium, Side};
use stratiform_tests::{accepted_cloud, paper_config};
use stratiform_transport::solve::{RadianceOrder, RadianceSolver, View};

struct Full(Arc<PhaseTable>);

impl PhaseLookup<f64> for Full {
    fn full(&self, v: f64) -> f64 {
        self.0.value(v)
    }

    fn wide(&self, _: f64) -> f64 {
        f64::NAN
    }

    fn wide_squared(&self, _: f64) -> f64 {
        f64::NAN
    }
}

const TAU: [f64; 3] = [0.3, 1.5, 5.0];

/// Degrees from the sun, below it or above, and how far the sum of halo and modified medium may be from the full medium's
/// radiance, as a share. At the edge of the halo wide scattering near θ_f is blurred by forward events, which the model neglects.
const OFF: [(f64, f64); 7] =
    [(-10.0, 0.02), (-6.0, 0.19), (-3.0, 0.06), (0.5, 0.015), (2.0, 0.025), (4.0, 0.13), (8.0, 0.025)];

fn view(theta_l: f64, off: f64) -> View {
    let theta = theta_l + off;
    let phi_deg = if theta < 0.0 { 180.0 } else { 0.0 };
    View { side: Side::Bottom, mu: libm::cos(theta.to_radians()), phi_deg }
}

#[test]
fn halo_and_modified_medium_make_the_full_mediums_aureole() {
    let config = paper_config();
    let (_, cloud) = accepted_cloud(&config);
    let media = Media::new(&config, &cloud).unwrap();
    let solvers = [Medium::Full, Medium::Modified]
        .map(|medium| RadianceSolver::new(media.get(medium).into(), 1e-3).unwrap());
    let events = Events::new(&cloud.phase, 5.0).unwrap();
    let table = HaloTable::of_cloud(&events).unwrap();
    let peak = Peak { forward_fraction: events.forward_fraction(), edge: versine(5_f64.to_radians()) };
    let phase = Full(Arc::new(cloud.phase.clone()));
    let mut needed = 0;
    for theta_l in [0.0_f64, 40.0, 70.0] {
        let mu_l = libm::cos(theta_l.to_radians());
        let views = OFF.map(|(off, _)| view(theta_l, off));
        let [full, modified] = solvers
            .each_ref()
            .map(|solver| solver.radiance_as_reached(RadianceOrder::Total, &TAU, &[mu_l], &views).unwrap());
        for (k, tau) in TAU.into_iter().enumerate() {
            for (i, (view, (off, bound))) in views.iter().zip(OFF).enumerate() {
                let [full, modified] =
                    [&full, &modified].map(|solved| solved.estimate(k, 0, i, RadianceOrder::Total).value);
                let sight = Sight::new(mu_l, view.mu, view.phi_deg, view.side).unwrap();
                let halo = Halo::new(&Angular::new(tau, sight).unwrap(), tau, peak);
                let (once, several) = (halo.once(&phase), halo.several(&|v, q| table.value(v, q)));
                let error = (once + several + modified) / full - 1.0;
                assert!(error.abs() < bound, "theta_l {theta_l} tau {tau} {off} degrees off: {error}");
                // Without the table of several events the bound would be broken.
                let without = (once + modified) / full - 1.0;
                needed += usize::from(without.abs() > bound);
            }
        }
    }
    assert!(needed > 20, "the comparison sees the events beyond the first: {needed}");
}
