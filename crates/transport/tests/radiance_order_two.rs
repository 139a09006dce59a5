//! The error stated for light scattered twice holds: against the same light at a hundredth of the tolerance.

#![allow(clippy::unwrap_used, reason = "a test may stop where it fails")]

use std::f64::consts::PI;
use std::path::Path;
use std::sync::Arc;
use stratiform_optics::phase::{Norm, PhaseTable};
use stratiform_quantities::{Side, SingleScatteringAlbedo};
use stratiform_transport::solve::{RadianceOrder, RadianceSolver, SolveMedium, View};

const TOLERANCE: f64 = 1e-3;
const TAU: [f64; 4] = [0.1, 1.0, 10.0, 100.0];

fn solver(tolerance: f64) -> RadianceSolver {
    let file = concat!(env!("CARGO_MANIFEST_DIR"), "/../../fit-configs/appendix-b/accepted/phase_full.csv");
    let cloud = Arc::new(PhaseTable::read(Path::new(file), Norm::Strict).unwrap());
    let medium = SolveMedium::full(cloud, SingleScatteringAlbedo::CONSERVATIVE);
    RadianceSolver::new(medium, tolerance).unwrap()
}

/// Scattered over sides and directions, up to 80° from the vertical.
fn view(n: u32) -> View {
    let [a, b] =
        [0.754_877_666_246_692_7, 0.569_840_290_998_053_2].map(|step| (0.5 + f64::from(n) * step).fract());
    let side = if n.is_multiple_of(2) { Side::Top } else { Side::Bottom };
    View { side, mu: libm::cos(a * 80.0 / 180.0 * PI), phi_deg: 180.0 * b }
}

#[test]
fn the_error_of_order_two_holds() {
    let (fine, coarse) = (solver(TOLERANCE / 100.0), solver(TOLERANCE));
    let mut compared = 0;
    for (i, theta) in [0.0, 30.0, 60.0, 80.0_f64].into_iter().enumerate() {
        let mu0 = libm::cos(theta.to_radians());
        for view in (0..4).map(|n| view(4 * i as u32 + n)) {
            let suns = [(mu0, vec![view])];
            // Where the total cannot be had so precisely there is nothing to compare with.
            let Ok(truth) = fine.radiance_of_suns(&TAU, &suns) else { continue };
            let found = coarse.radiance_of_suns(&TAU, &suns).unwrap();
            for t in 0..TAU.len() {
                let [found, truth] =
                    [&found, &truth].map(|solved| solved[0].estimate(t, 0, 0, RadianceOrder::Two));
                let off = (found.value - truth.value).abs();
                assert!(off <= found.std_error + truth.std_error, "{theta} {view:?} {t}: {off:e} {found:?}");
                compared += 1;
            }
        }
    }
    assert!(compared >= 50, "only {compared} points");
}
