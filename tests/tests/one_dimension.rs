//! The one-dimensional model where it is exact: photons that can only go straight on or straight back.
//!
//! In a column where a collision turns the photon back with probability r and lets it go on with t = 1 - r, every formula of
//! appendix A is exact with κ_c H = τ. So photons tell which reading of T_2b is right.

#![allow(clippy::unwrap_used, reason = "a test may stop where it fails")]

use std::sync::Arc;
use stratiform_model::{Fluxes, Form, Parameters, Thickness, Values};
use stratiform_optics::phase::PhaseFunction;
use stratiform_quantities::{Incidence, Order, SingleScatteringAlbedo};
use stratiform_stats::{Estimate, family_threshold, z_score};
use stratiform_transport::{Control, Stop, TraceMedium, TraceRequest, trace_plain};

/// Forward with probability 1 - r, backward with r.
struct TwoDirections {
    r: f64,
}

impl PhaseFunction for TwoDirections {
    fn value(&self, _v: f64) -> f64 {
        0.0
    }

    fn cumulative(&self, v: f64) -> f64 {
        if v < 2.0 { 1.0 - self.r } else { 1.0 }
    }

    fn invert(&self, xi: f64) -> f64 {
        if xi < 1.0 - self.r { 0.0 } else { 2.0 }
    }

    fn asymmetry(&self) -> f64 {
        1.0 - 2.0 * self.r
    }

    fn moments(&self, count: usize) -> Vec<f64> {
        let sign = |l: usize| if l.is_multiple_of(2) { 1.0 } else { -1.0 };
        (0..count).map(|l| 1.0 - self.r + self.r * sign(l)).collect()
    }
}

const R: f64 = 0.4;
const TAU: [f64; 3] = [0.1, 0.3, 2.0];

fn model(form: Form, tau: f64) -> Fluxes<f64> {
    let values = Values { beta: 0.5, b: 1.0, c: 1.0, kappa_c: 1.0, t: 1.0 - R, r: R, kappa_s: 1.0 };
    let parameters = Parameters::new(&values, Incidence::beam(1.0).unwrap()).unwrap();
    parameters.fluxes(form, Thickness::new(tau).unwrap())
}

/// z of every flux of order 0, 1 and 2: photons less model.
fn deviations(form: Form) -> Vec<(&'static str, f64, f64)> {
    let medium = TraceMedium::full(Arc::new(TwoDirections { r: R }), SingleScatteringAlbedo::CONSERVATIVE);
    let request = TraceRequest {
        tau: TAU.to_vec(),
        incidence: Incidence::beam(1.0).unwrap(),
        stop: Stop::Photons(400_000),
        max_order: 2,
        seed: 3,
        stream: 0,
    };
    let traced = trace_plain(&medium, &request, Control::default()).unwrap();
    let mut all = Vec::new();
    for (k, tau) in TAU.into_iter().enumerate() {
        let fluxes = model(form, tau);
        let order = |n| traced.estimate(k, Order::Exactly(n));
        for (name, photons, model) in [
            ("t_0", order(0).1, fluxes.t_0),
            ("t_1", order(1).1, fluxes.t_1),
            ("t_2", order(2).1, fluxes.t_2),
            ("r_1", order(1).0, fluxes.r_1),
            ("r_2", order(2).0, fluxes.r_2),
        ] {
            all.push((name, tau, z_score(photons, Estimate { value: model, std_error: 0.0 })));
        }
    }
    all
}

/// False-alarm rate 1e-4 over the fifteen fluxes.
#[test]
fn photons_side_with_the_corrected_form() {
    let threshold = family_threshold(1e-4, 15).unwrap();
    for (name, tau, z) in deviations(Form::Corrected) {
        assert!(z.abs() < threshold, "{name} at tau {tau}: z = {z}");
    }
}

/// Only T_2b differs between the readings, and photons refuse the printed one at every thickness (the two meet at
/// τ = 1/2 alone).
#[test]
fn photons_refuse_the_printed_form_of_t_2() {
    let threshold = family_threshold(1e-4, 15).unwrap();
    for (name, tau, z) in deviations(Form::AsPrinted) {
        assert_eq!(z.abs() > threshold, name == "t_2", "{name} at tau {tau}: z = {z}");
    }
}
