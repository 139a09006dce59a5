//! Radiance by photons, at views and in bins, against the solver, closed forms and the flux tracer.

#![allow(clippy::unwrap_used, reason = "a test may stop where it fails")]

mod common;

use common::{Family, beam, cloud, exact, full, hg, isotropic, modified_cloud, plain, request};
use stratiform_optics::phase::versine;
use stratiform_quantities::{Order, Side};
use stratiform_stats::Estimate;
use stratiform_transport::radiance::{
    AngularBins, BinRadiance, RadianceRequest, ViewRadiance, trace_radiance, trace_radiance_bins,
};
use stratiform_transport::solve::{RadianceOrder, RadianceSolver, SolveMedium, View};
use stratiform_transport::{Control, TraceMedium, TransportError};

const fn view(side: Side, mu: f64, phi_deg: f64) -> View {
    View { side, mu, phi_deg }
}

const VIEWS: [View; 6] = [
    view(Side::Top, 0.6, 180.0),
    view(Side::Top, 0.9, 50.0),
    view(Side::Top, 0.2, 0.0),
    view(Side::Bottom, 0.6, 20.0),
    view(Side::Bottom, 0.3, 130.0),
    view(Side::Bottom, 1.0, 0.0),
];

/// (τ, μ0) of the comparisons.
const SLABS: [(f64, f64); 3] = [(0.3, 0.9), (2.0, 0.6), (6.0, 0.2)];

fn scene((tau, mu0): (f64, f64), photons: u64, stream: u32) -> RadianceRequest {
    RadianceRequest { tau, mu0, photons, max_order: 2, seed: 2_006, stream }
}

fn at_views(medium: &TraceMedium, request: &RadianceRequest) -> ViewRadiance {
    trace_radiance(medium, request, &VIEWS, Control::default()).unwrap()
}

fn in_bins(medium: &TraceMedium, request: &RadianceRequest, bins: &AngularBins) -> BinRadiance {
    trace_radiance_bins(medium, request, bins, Control::default()).unwrap()
}

/// Every view and order of every slab, as `change` leaves the estimate, against the solver.
fn against_solver(
    family: &mut Family,
    name: &str,
    medium: &TraceMedium,
    photons: u64,
    change: impl Fn(&View, Estimate) -> Estimate,
) {
    let solver = RadianceSolver::new(SolveMedium::from(medium), 1e-3).unwrap();
    for (stream, slab) in (0..).zip(SLABS) {
        let traced = at_views(medium, &scene(slab, photons, stream));
        let solved = solver.radiance(&[slab.0], &[slab.1], &VIEWS).unwrap();
        for (v, view) in VIEWS.iter().enumerate() {
            for order in RadianceOrder::ALL {
                let estimate = change(view, traced.estimate(v, order.into()));
                family.compare(
                    format!("{name}, {slab:?}, {view:?}, {order:?}"),
                    estimate,
                    solved.estimate(0, 0, v, order),
                );
            }
        }
    }
}

/// Isotropic and Henyey–Greenstein media, absorption, and the cloud's modified medium. False alarms: one seed in 1000.
#[test]
fn views_agree_with_the_solver() {
    let mut family = Family::default();
    let media = [
        ("isotropic", full(isotropic(), 1.0)),
        ("hg 0.85", full(hg(0.85), 1.0)),
        ("hg 0.5, absorbing", full(hg(0.5), 0.9)),
        ("modified cloud", modified_cloud()),
    ];
    for (name, medium) in &media {
        against_solver(&mut family, name, medium, 60_000, |_, estimate| estimate);
    }
    family.assert(1e-3);
}

/// The comparison rejects a factor 1.01, and a missing 1/μ.
#[test]
fn planted_errors_are_rejected() {
    let medium = full(isotropic(), 1.0);
    let scaled = |factor: f64, e: Estimate| Estimate {
        value: factor * e.value,
        std_error: factor.abs() * e.std_error,
    };
    let mut family = Family::default();
    against_solver(&mut family, "1 %", &medium, 200_000, |_, estimate| scaled(1.01, estimate));
    assert!(!family.accepts(1e-3), "{:?}", family.worst());
    let mut family = Family::default();
    against_solver(&mut family, "no 1/mu", &medium, 1_000, |view, estimate| scaled(view.mu, estimate));
    assert!(!family.accepts(1e-3), "{:?}", family.worst());
    let mut family = Family::default();
    let wrong = full(hg(0.73), 1.0);
    let solver = RadianceSolver::new(SolveMedium::from(&full(hg(0.75), 1.0)), 1e-3).unwrap();
    let solved = solver.radiance(&[2.0], &[0.6], &VIEWS).unwrap();
    let traced = at_views(&wrong, &scene((2.0, 0.6), 60_000, 0));
    (0..VIEWS.len()).for_each(|v| {
        let total = RadianceOrder::Total;
        family.compare("g", traced.estimate(v, total.into()), solved.estimate(0, 0, v, total));
    });
    assert!(!family.accepts(1e-3), "{:?}", family.worst());
}

/// ωP/(4(μ+μ0))·(1-e^{-τ(1/μ+1/μ0)}) above and ωP/4·(e^{-τ/μ}-e^{-τ/μ0})/(μ-μ0) below (Chandrasekhar 1950, ch. 7 §45.3),
/// in the full medium of the cloud too, glory included: order 1 has no spikes. False alarms: one seed in 1000.
#[test]
fn order_one_is_the_closed_form() {
    let mut family = Family::default();
    let (tau, mu0) = (1.3, 0.6);
    for (stream, phase) in (0..).zip([isotropic(), hg(0.85), cloud()]) {
        let medium = full(phase.clone(), 0.8);
        let traced = at_views(&medium, &scene((tau, mu0), 40_000, stream));
        for (v, view) in VIEWS.iter().enumerate().filter(|(_, view)| view.mu != mu0 || view.side == Side::Top)
        {
            let sines = ((1.0 - view.mu * view.mu) * (1.0 - mu0 * mu0)).sqrt();
            let along = if view.side == Side::Top { -view.mu } else { view.mu };
            let cosine = along * mu0 + sines * libm::cos(view.phi_deg.to_radians());
            let mu = view.mu;
            let slab = match view.side {
                Side::Top => -libm::expm1(-tau * (1.0 / mu + 1.0 / mu0)) / (mu + mu0),
                Side::Bottom => (libm::exp(-tau / mu) - libm::exp(-tau / mu0)) / (mu - mu0),
            };
            let closed = exact(0.25 * 0.8 * phase.value(1.0 - cosine) * slab);
            family.compare(format!("{stream}, {view:?}"), traced.estimate(v, Order::Exactly(1)), closed);
            assert!(traced.is_settled(v, Order::Exactly(1)), "{stream}, {view:?}");
        }
    }
    family.assert(1e-3);
}

/// A spike not yet met is not taken for certainty: few photons in the cloud's full medium do not settle, and their
/// errors say so; the modified medium does settle.
#[test]
fn spikes_are_told() {
    let slab = (4.6, 0.34);
    let (sharp, smooth) = (full(cloud(), 1.0), modified_cloud());
    let total = Order::Total;
    let few = at_views(&sharp, &scene(slab, 2_000, 0));
    let share = sharp.table().phase().value(versine(0.0)) / 4.0 / 2_003.0;
    for (v, view) in VIEWS.iter().enumerate() {
        assert!(!few.is_settled(v, total), "{view:?}");
        assert!(few.estimate(v, total).std_error >= share, "{view:?}");
    }
    let solver = RadianceSolver::new(SolveMedium::from(&sharp), 1e-3).unwrap();
    let solved = solver.radiance(&[slab.0], &[slab.1], &VIEWS).unwrap();
    let mut family = Family::default();
    for v in 0..VIEWS.len() {
        family.compare("few", few.estimate(v, total), solved.estimate(0, 0, v, RadianceOrder::Total));
    }
    family.assert(1e-3);
    let settled = at_views(&smooth, &scene(slab, 20_000, 0));
    for v in 0..VIEWS.len() {
        assert!(settled.is_settled(v, total) && settled.largest_share(v, total) < 0.01);
    }
}

fn hemisphere() -> AngularBins {
    let mu = (0..=8).map(|k| f64::from(k) / 8.0).collect();
    AngularBins::new(mu, vec![0.0, 10.0, 45.0, 90.0, 135.0, 170.0, 180.0]).unwrap()
}

/// Σ hits over all bins are the photons of each order that the flux tracer would count; none is lost.
/// Against that tracer's own photons; false alarms: one seed in 1000.
#[test]
fn bins_integrate_to_reflectance_and_transmittance() {
    let medium = full(hg(0.85), 0.95);
    let (tau, mu0, photons) = (2.0, 0.6, 200_000);
    let bins = hemisphere();
    let binned = in_bins(&medium, &scene((tau, mu0), photons, 0), &bins);
    let fluxes = plain(&medium, &request(&[tau], beam(mu0), photons));
    let mut family = Family::default();
    for order in [Order::Exactly(1), Order::Exactly(2), Order::Tail] {
        let (r, t) = fluxes.estimate(0, order);
        for (side, flux) in [(Side::Top, r), (Side::Bottom, t)] {
            let hits = all(&bins).map(|(m, p)| binned.hits(side, m, p, order)).sum();
            family.compare(format!("{side:?} {order}"), Estimate::from_hits(hits, photons), flux);
        }
    }
    family.assert(1e-3);
    for (m, p) in all(&bins) {
        for side in [Side::Top, Side::Bottom] {
            let hits = |order| binned.hits(side, m, p, order);
            assert_eq!(
                hits(Order::Total),
                hits(Order::Exactly(1)) + hits(Order::Exactly(2)) + hits(Order::Tail)
            );
        }
    }
}

fn all(bins: &AngularBins) -> impl Iterator<Item = (usize, usize)> + use<> {
    let (mus, phis) = bins.shape();
    (0..mus).flat_map(move |m| (0..phis).map(move |p| (m, p)))
}

/// Narrow bins of the cloud's full medium against the solver at their middle; what the radiance's curvature over a bin
/// changes is allowed for as an error of 2 %. False alarms: one seed in 1000.
#[test]
fn bins_agree_with_the_solver_in_the_full_medium() {
    let medium = full(cloud(), 1.0);
    let bins =
        AngularBins::new(vec![0.1, 0.14, 0.4, 0.44, 0.8, 0.84], vec![0.0, 8.0, 86.0, 94.0, 172.0, 180.0])
            .unwrap();
    let binned = in_bins(&medium, &scene((4.6, 0.34), 500_000, 0), &bins);
    let solver = RadianceSolver::new(SolveMedium::from(&medium), 1e-3).unwrap();
    let mut family = Family::default();
    for m in [0, 2, 4] {
        for (p, phi_deg) in [(0, 4.0), (2, 90.0)] {
            let mu = [0.12, 0.0, 0.42, 0.0, 0.82][m];
            let solved = solver.radiance(&[4.6], &[0.34], &[view(Side::Top, mu, phi_deg)]).unwrap();
            let solved = solved.estimate(0, 0, 0, RadianceOrder::Total);
            let solved = Estimate { std_error: solved.std_error + 0.02 * solved.value, ..solved };
            family.compare(
                format!("{mu}, {phi_deg}"),
                binned.estimate(Side::Top, m, p, Order::Total),
                solved,
            );
        }
    }
    family.assert(1e-3);
}

#[test]
fn threads_change_no_bit() {
    let medium = modified_cloud();
    let request = scene((3.0, 0.5), 20_000, 1);
    let with = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| (at_views(&medium, &request), in_bins(&medium, &request, &hemisphere())))
    };
    let (one, two) = (with(1), with(2));
    assert_eq!(one, two);
    let bits = |radiance: &ViewRadiance| {
        let rows = radiance.orders().flat_map(|order| (0..VIEWS.len()).map(move |v| (v, order)));
        let bits = |(v, order)| {
            let e = radiance.estimate(v, order);
            (e.value.to_bits(), e.std_error.to_bits())
        };
        rows.map(bits).collect::<Vec<_>>()
    };
    assert_eq!(bits(&one.0), bits(&two.0));
}

/// μ and -φ are mirror images; nothing is scored at φ that is not at -φ.
#[test]
fn mirror_images_are_equal() {
    let medium = full(hg(0.85), 1.0);
    let request = scene((2.0, 0.6), 5_000, 0);
    let views = [50.0, -50.0, 310.0, 180.0, -180.0].map(|phi_deg| view(Side::Top, 0.4, phi_deg));
    let traced = trace_radiance(&medium, &request, &views, Control::default()).unwrap();
    let total = |v| traced.estimate(v, Order::Total);
    assert_eq!((total(0), total(0), total(3)), (total(1), total(2), total(4)));
}

#[test]
fn limits_are_ordinary_values() {
    let medium = full(isotropic(), 1.0);
    let nothing = at_views(&medium, &scene((0.0, 0.6), 100, 0));
    assert_eq!(nothing.estimate(0, Order::Total).value, 0.0);
    let grazing = at_views(&medium, &scene((2.0, 0.0), 20_000, 0));
    // μ0 → 0: half of the first collisions' light starts upwards from the surface itself, P/(4μ) of it.
    let first = grazing.estimate(0, Order::Exactly(1));
    assert!((first.value - 0.25 / 0.6).abs() < 1e-12, "{first:?}");
    let binned = in_bins(&medium, &scene((0.0, 0.0), 100, 0), &hemisphere());
    assert_eq!(binned.hits(Side::Bottom, 0, 0, Order::Total), 0);
}

#[test]
fn nonsense_is_refused() {
    let medium = full(isotropic(), 1.0);
    let good = scene((2.0, 0.6), 100, 0);
    let trace = |request, views: &[View]| trace_radiance(&medium, &request, views, Control::default());
    let bad = [
        RadianceRequest { tau: -1.0, ..good },
        RadianceRequest { tau: f64::NAN, ..good },
        RadianceRequest { mu0: 1.1, ..good },
        RadianceRequest { mu0: f64::NAN, ..good },
        RadianceRequest { photons: 1, ..good },
    ];
    for request in bad {
        assert!(matches!(trace(request, &VIEWS), Err(TransportError::Domain(_))), "{request:?}");
        let binned = trace_radiance_bins(&medium, &request, &hemisphere(), Control::default());
        assert!(matches!(binned, Err(TransportError::Domain(_))), "{request:?}");
    }
    let many = RadianceRequest { max_order: u32::MAX, ..good };
    assert!(matches!(trace(many, &VIEWS), Err(TransportError::TooManyCells { .. })));
    assert_eq!(trace(good, &[]), Err(TransportError::NoView));
    for view in [view(Side::Top, 0.0, 0.0), view(Side::Top, 1.5, 0.0), view(Side::Top, 0.5, f64::NAN)] {
        assert!(matches!(trace(good, &[view]), Err(TransportError::Domain(_))), "{view:?}");
    }
    let bins = |mu: &[f64], phi: &[f64]| AngularBins::new(mu.to_vec(), phi.to_vec());
    assert!(matches!(bins(&[0.0, 1.1], &[0.0, 180.0]), Err(TransportError::Domain(_))));
    assert!(matches!(bins(&[0.0, f64::NAN], &[0.0, 180.0]), Err(TransportError::Domain(_))));
    let message = bins(&[0.0, 1.0], &[90.0, 10.0]).unwrap_err().to_string();
    assert!(message.contains("90 is followed by 10"), "{message}");
    assert!(matches!(bins(&[0.5], &[0.0, 180.0]), Err(TransportError::Edges { at: None, .. })));
}
