//! The two tracers against each other, order by order.

mod common;

use common::{Family, beam, full, hg, isotropic, modified, request};
use stratiform_quantities::{Incidence, Order};
use stratiform_stats::Estimate;
use stratiform_transport::{Quantity, TraceMedium, Traced};

const ALPHA: f64 = 1e-3;
const TAU: [f64; 3] = [0.5, 3.0, 10.0];

fn half_space(medium: &TraceMedium, incidence: Incidence, photons: u64) -> Traced {
    common::half_space(medium, &request(&TAU, incidence, photons))
}

fn plain(medium: &TraceMedium, incidence: Incidence, photons: u64) -> Traced {
    common::plain(medium, &request(&TAU, incidence, photons))
}

/// False alarms: one seed in 1000.
#[test]
fn both_tracers_agree_in_every_order() {
    let media = [
        ("isotropic", full(isotropic(), 1.0)),
        ("hg", full(hg(0.85), 1.0)),
        ("absorbing hg", full(hg(0.85), 0.9)),
        ("modified", modified(hg(0.7), 0.95, 0.4)),
    ];
    let mut family = Family::default();
    for (name, medium) in &media {
        for incidence in [beam(1.0), beam(0.3), beam(0.0), Incidence::Diffuse] {
            let (fast, slow) = (half_space(medium, incidence, 40_000), plain(medium, incidence, 20_000));
            family.compare_all(&format!("{name} {incidence}"), &fast, &slow);
        }
    }
    family.assert(ALPHA);
}

/// The same comparison rejects a g that is 1 % wrong in one of the two.
#[test]
fn an_asymmetry_off_by_one_per_cent_is_rejected() {
    let mut family = Family::default();
    let fast = half_space(&full(hg(0.8415), 1.0), beam(1.0), 500_000);
    family.compare_all("hg", &fast, &plain(&full(hg(0.85), 1.0), beam(1.0), 300_000));
    assert!(!family.accepts(ALPHA), "{:?}", family.worst());
}

/// Variances and the covariance of two thicknesses, over runs with different seeds, against what the counts'
/// nesting makes them: a photon reflected by a thin slab is reflected by a thicker one. Each mean of 60 runs has
/// a relative deviation near 1.2 % (9 %/√60); 6 % is more than 4 of them.
#[test]
fn batch_covariances_are_those_of_nested_counts() {
    let (medium, photons) = (full(hg(0.85), 1.0), 10_000);
    let thin = (0, Quantity::Reflectance(Order::Total));
    let thick = (1, Quantity::Reflectance(Order::Total));
    let passed = (1, Quantity::Transmittance(Order::Total));
    let mut mean = [0.0; 3];
    let mut hits = [0; 2];
    let runs = 60;
    for seed in 0..runs {
        let mut request = request(&TAU, beam(0.5), photons);
        request.seed = seed;
        let traced = common::half_space(&medium, &request);
        let covariance = traced.covariance(&[thin, thick, passed]);
        mean[0] += covariance[0][0] / runs as f64;
        mean[1] += covariance[0][1] / runs as f64;
        mean[2] += covariance[1][1] / runs as f64;
        // R + T = 1 photon by photon.
        assert!((covariance[1][2] + covariance[1][1]).abs() < 1e-12 * covariance[1][1]);
        hits = [hits[0] + traced.hits(thin.0, thin.1), hits[1] + traced.hits(thick.0, thick.1)];
    }
    let [p, q] = hits.map(|hits| hits as f64 / (runs * photons) as f64);
    let exact = [p * (1.0 - p), p * (1.0 - q), q * (1.0 - q)].map(|product| product / photons as f64);
    for (mean, exact) in mean.iter().zip(exact) {
        assert!((mean / exact - 1.0).abs() < 0.06, "{mean:e} {exact:e}");
    }
}

/// A forward peak P_f at Θ = 0 exactly is no scattering at all: moving it into extinction changes no total.
#[test]
fn a_forward_delta_may_be_moved_into_extinction() {
    let (omega, forward) = (0.95, 0.4);
    let with_peak = full(std::sync::Arc::new(common::ForwardDelta { share: forward, rest: hg(0.7) }), omega);
    let without = modified(hg(0.7), omega, forward);
    let mut family = Family::default();
    let (a, b) = (half_space(&with_peak, beam(0.5), 200_000), half_space_again(&without, 200_000));
    for i in 0..TAU.len() {
        let total = |traced: &Traced| traced.estimate(i, Order::Total);
        let ((ra, ta), (rb, tb)) = (total(&a), total(&b));
        family.compare("R", ra, rb);
        family.compare("T", ta, tb);
        let absorbed: [Estimate; 2] = [a.absorptance(i), b.absorptance(i)];
        family.compare("absorbed", absorbed[0], absorbed[1]);
    }
    family.assert(ALPHA);
}

/// Another stream, so that the two runs are independent.
fn half_space_again(medium: &TraceMedium, photons: u64) -> Traced {
    let mut request = request(&TAU, beam(0.5), photons);
    request.stream = 1;
    common::half_space(medium, &request)
}
