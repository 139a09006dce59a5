//! Radiance against a small Monte Carlo of its own: directions in three dimensions, local estimate at every event.

#![allow(clippy::unwrap_used, reason = "a test stops where it fails")]

mod common;

use common::{Family, full, hg, modified_cloud};
use glam::DVec3;
use rand::{Rng, RngExt, SeedableRng};
use rand_pcg::Pcg64;
use stratiform_quantities::Side;
use stratiform_stats::Estimate;
use stratiform_transport::TraceMedium;
use stratiform_transport::solve::{RadianceOrder, RadianceSolver, SolveMedium, View};

/// A slab lit along its sun's direction; z points down.
struct Scene<'a> {
    medium: &'a TraceMedium,
    /// Of the medium traced.
    tau: f64,
    mu0: f64,
    views: &'a [View],
}

/// Direction of travel at cosine `mu` to the downward normal.
fn direction(mu: f64, phi_deg: f64) -> DVec3 {
    let sine = (1.0 - mu * mu).sqrt();
    let phi = phi_deg.to_radians();
    DVec3::new(sine * libm::cos(phi), sine * libm::sin(phi), mu)
}

/// `along`, turned by Θ with 1 - cosΘ = `v` about a random azimuth.
fn turned(along: DVec3, v: f64, random: &mut impl Rng) -> DVec3 {
    let (first, second) = along.any_orthonormal_pair();
    let azimuth = 2.0 * std::f64::consts::PI * random.random::<f64>();
    let sine = (v * (2.0 - v)).max(0.0).sqrt();
    let across = first * libm::cos(azimuth) + second * libm::sin(azimuth);
    (along * (1.0 - v) + across * sine).normalize()
}

impl Scene<'_> {
    /// Adds one photon's contributions to every view: order 1, order 2, total.
    fn trace(&self, random: &mut impl Rng, scores: &mut [[f64; 3]]) {
        let phase = self.medium.table().phase();
        let (mut along, mut depth, mut order) = (direction(self.mu0, 0.0), 0.0, 0);
        loop {
            depth -= along.z * libm::log1p(-random.random::<f64>());
            if !(0.0..=self.tau).contains(&depth) || random.random::<f64>() >= self.medium.albedo() {
                return;
            }
            for (view, score) in self.views.iter().zip(&mut *scores) {
                let (sign, way) =
                    if view.side == Side::Top { (-1.0, depth) } else { (1.0, self.tau - depth) };
                let cosine = along.dot(direction(sign * view.mu, view.phi_deg));
                let value = 0.25 * phase.value(1.0 - cosine) * libm::exp(-way / view.mu) / view.mu;
                score[2] += value;
                if order < 2 {
                    score[order] += value;
                }
            }
            along = turned(along, phase.invert(random.random()), random);
            order += 1;
        }
    }

    /// Means over photons with their standard errors.
    fn estimates(&self, photons: u32, seed: u64) -> Vec<[Estimate; 3]> {
        let mut random = Pcg64::seed_from_u64(seed);
        let mut sums = vec![[[0.0; 2]; 3]; self.views.len()];
        for _ in 0..photons {
            let mut scores = vec![[0.0; 3]; self.views.len()];
            self.trace(&mut random, &mut scores);
            for (sum, score) in sums.iter_mut().flatten().zip(scores.iter().flatten()) {
                *sum = [sum[0] + score, sum[1] + score * score];
            }
        }
        let n = f64::from(photons);
        let estimate = |[sum, square]: [f64; 2]| {
            let value = sum / n;
            Estimate { value, std_error: ((square / n - value * value) / (n - 1.0)).sqrt() }
        };
        sums.into_iter().map(|row| row.map(estimate)).collect()
    }
}

/// Every view and order of one slab, photons against the solver of `solved`.
fn compare(family: &mut Family, name: &str, scene: &Scene, solved: &TraceMedium, photons: u32) {
    let solver = RadianceSolver::new(SolveMedium::from(solved), 1e-3).unwrap();
    let tau = scene.tau / scene.medium.extinction();
    let exact = solver.radiance(&[tau], &[scene.mu0], scene.views).unwrap();
    for (v, row) in scene.estimates(photons, 2_006).iter().enumerate() {
        for (order, traced) in RadianceOrder::ALL.into_iter().zip(row) {
            family.compare(format!("{name}, view {v}, {order:?}"), *traced, exact.estimate(0, 0, v, order));
        }
    }
}

const VIEWS: [View; 6] = [
    View { side: Side::Top, mu: 0.6, phi_deg: 180.0 },
    View { side: Side::Top, mu: 0.9, phi_deg: 50.0 },
    View { side: Side::Top, mu: 0.2, phi_deg: 0.0 },
    View { side: Side::Bottom, mu: 0.6, phi_deg: 20.0 },
    View { side: Side::Bottom, mu: 0.3, phi_deg: 130.0 },
    View { side: Side::Bottom, mu: 1.0, phi_deg: 0.0 },
];

/// Henyey–Greenstein with and without absorption, and the cloud's modified medium. False alarms: one seed in 1000.
#[test]
fn photons_agree() {
    let mut family = Family::default();
    let (bright, dark) = (full(hg(0.75), 1.0), full(hg(0.5), 0.9));
    let cloud = modified_cloud();
    for (name, medium, tau) in
        [("hg 0.75", &bright, 2.0), ("hg 0.5", &dark, 1.0), ("modified cloud", &cloud, 1.5)]
    {
        compare(&mut family, name, &Scene { medium, tau, mu0: 0.6, views: &VIEWS }, medium, 60_000);
    }
    family.assert(1e-3);
}

/// The comparison rejects g off by 0.02.
#[test]
fn a_planted_asymmetry_is_rejected() {
    let mut family = Family::default();
    let scene = Scene { medium: &full(hg(0.75), 1.0), tau: 2.0, mu0: 0.6, views: &VIEWS };
    compare(&mut family, "planted", &scene, &full(hg(0.73), 1.0), 60_000);
    assert!(!family.accepts(1e-3));
}
