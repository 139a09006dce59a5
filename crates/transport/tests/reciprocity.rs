//! Light from Ω0 towards Ω is light from Ω towards Ω0: photons there and back, without a solver or a closed form.

#![allow(clippy::unwrap_used, reason = "a test may stop where it fails")]

mod common;

use common::{Family, full, hg, modified_cloud};
use stratiform_quantities::{Order, Side};
use stratiform_stats::Estimate;
use stratiform_transport::radiance::{RadianceRequest, trace_radiance};
use stratiform_transport::solve::View;
use stratiform_transport::{Control, TraceMedium};

/// πL/(μ0F0) of the orders 1 and 2, the tail and the total.
fn radiance(medium: &TraceMedium, mu0: f64, view: View, stream: u32) -> Vec<(Order, Estimate)> {
    let request = RadianceRequest { tau: 3.0, mu0, photons: 10_000, max_order: 2, seed: 1859, stream };
    let traced = trace_radiance(medium, &request, &[view], Control::default()).unwrap();
    Order::rows(2).skip(1).map(|order| (order, traced.estimate(0, order))).collect()
}

/// Both ways at three azimuths and both faces, each as `change` leaves it.
fn there_and_back(family: &mut Family, medium: &TraceMedium, change: impl Fn(f64, Estimate) -> Estimate) {
    let (high, low) = (0.9, 0.3);
    let places =
        [Side::Top, Side::Bottom].into_iter().flat_map(|side| [0.0, 70.0, 180.0].map(|phi| (side, phi)));
    for (stream, (side, phi_deg)) in (0..).step_by(2).zip(places) {
        let there = radiance(medium, high, View { side, mu: low, phi_deg }, stream);
        let back = radiance(medium, low, View { side, mu: high, phi_deg }, stream + 1);
        for ((order, there), (_, back)) in there.into_iter().zip(back) {
            family.compare(format!("{side:?} {phi_deg} {order}"), change(low, there), change(high, back));
        }
    }
}

/// False alarms: one seed in 1000.
#[test]
fn photons_are_reciprocal() {
    let mut family = Family::default();
    for medium in [full(hg(0.85), 0.95), modified_cloud()] {
        there_and_back(&mut family, &medium, |_, estimate| estimate);
    }
    family.assert(1e-3);
}

/// Radiance per area of the face instead of projected area.
#[test]
fn a_missing_cosine_is_rejected() {
    let mut family = Family::default();
    there_and_back(&mut family, &full(hg(0.85), 0.95), |mu, estimate| Estimate {
        value: mu * estimate.value,
        std_error: mu * estimate.std_error,
    });
    assert!(!family.accepts(1e-3), "{:?}", family.worst());
}
