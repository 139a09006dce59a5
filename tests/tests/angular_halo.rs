//! The halo of forward events against exact radiance: what the full medium has more than the modified one.

#![allow(
    clippy::unwrap_used,
    clippy::print_stdout,
    reason = "a test may stop where it fails, and says what it measured"
)]

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

/// Θ in degrees, above or below the sun.
const OFF: [f64; 7] = [-10.0, -6.0, -3.0, 0.5, 2.0, 4.0, 8.0];

#[test]
fn print_all() {
    let config = paper_config();
    let (_, cloud) = accepted_cloud(&config);
    let media = Media::new(&config, &cloud).unwrap();
    let solver = |medium| RadianceSolver::new(media.get(medium).into(), 1e-3).unwrap();
    let (full, modified) = (solver(Medium::Full), solver(Medium::Modified));
    let events = Events::new(&cloud.phase, 5.0).unwrap();
    let table = HaloTable::of_cloud(&events).unwrap();
    let peak = Peak { forward_fraction: events.forward_fraction(), edge: versine(5_f64.to_radians()) };
    let phase = Full(Arc::new(cloud.phase.clone()));
    for theta_l in [0.0_f64, 40.0, 70.0] {
        let mu_l = (theta_l.to_radians()).cos();
        let views: Vec<View> = OFF
            .iter()
            .map(|off| {
                let theta = theta_l + off;
                View {
                    side: Side::Bottom,
                    mu: theta.to_radians().cos(),
                    phi_deg: if theta < 0.0 { 180.0 } else { 0.0 },
                }
            })
            .collect();
        let solve = |solver: &RadianceSolver| {
            solver.radiance_as_reached(RadianceOrder::Total, &TAU, &[mu_l], &views).unwrap()
        };
        let (all, wide) = (solve(&full), solve(&modified));
        for (k, tau) in TAU.iter().enumerate() {
            for (i, view) in views.iter().enumerate() {
                let a = all.estimate(k, 0, i, RadianceOrder::Total);
                let w = wide.estimate(k, 0, i, RadianceOrder::Total);
                let sight = Sight::new(mu_l, view.mu, view.phi_deg, view.side).unwrap();
                let slab = Angular::new(*tau, sight).unwrap();
                let halo = Halo::new(&slab, *tau, peak);
                let once = halo.once(&phase);
                let several = halo.several(&|v, q| table.value(v, q));
                let exact_shape = halo.several(&|v: f64, q| {
                    events.several(q, &[stratiform_optics::phase::angle(v)]).unwrap()[0]
                });
                println!(
                    "theta_l {theta_l} tau {tau} off {}: truth {:.4} (+-{:.4} {:.4}) of all {:.4}; once {once:.4} several {several:.4} (exact shape {exact_shape:.4}); ratio {:.3}",
                    OFF[i],
                    a.value - w.value,
                    a.std_error,
                    w.std_error,
                    a.value,
                    (once + several) / (a.value - w.value)
                );
            }
        }
    }
}
