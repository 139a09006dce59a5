//! Solvers and tracers behind the trait against the solver itself, and look-ups against the tables.
#![allow(clippy::unwrap_used, reason = "a test may stop where it fails")]

mod common;

use common::cloud;
use stratiform_methods::{Exact, FluxPoint, Point, Texels, by_name};
use stratiform_model::angular::PhaseLookup;
use stratiform_optics::phase::versine;
use stratiform_quantities::{Incidence, Side};
use stratiform_transport::solve::{RadianceOrder, RadianceSolver, SolveMedium, Solver, View};

fn medium() -> SolveMedium {
    let cloud = cloud(1.0);
    SolveMedium::full(cloud.phase().clone(), cloud.omega())
}

/// Points of no grid come back in their order: two slabs, three views.
#[test]
fn the_solver_with_streams_is_the_solver() {
    let ready = by_name("solver:24").unwrap().prepare(&cloud(1.0)).unwrap();
    let point = |tau, mu_v, phi_deg, side| Point { tau, mu_l: 0.6, mu_v, phi_deg, side };
    let points = [
        point(2.0, 0.8, 30.0, Side::Top),
        point(20.0, 0.4, 150.0, Side::Bottom),
        point(20.0, 0.8, 30.0, Side::Top),
    ];
    let solver = RadianceSolver::new(medium(), 1e-3).unwrap();
    for (point, value) in points.iter().zip(ready.radiances(&points).unwrap()) {
        let view = View { side: point.side, mu: point.mu_v, phi_deg: point.phi_deg };
        let truth = solver.radiance(&[point.tau], &[point.mu_l], &[view]).unwrap();
        let truth = truth.estimate(0, 0, 0, RadianceOrder::Total).value;
        assert!((value.value - truth).abs() < 2e-3, "{point:?}: {value:?} {truth}");
    }
}

/// Orders 1 and 2 of the radiance, and 60 orders of a thin slab's fluxes, which are all but 1e-6.
#[test]
fn successive_orders_add_up() {
    let cloud = cloud(1.0);
    let point = Point { tau: 1.0, mu_l: 0.6, mu_v: 0.8, phi_deg: 30.0, side: Side::Top };
    let of =
        |name: &str| by_name(name).unwrap().prepare(&cloud).unwrap().radiances(&[point]).unwrap()[0].value;
    assert!((of("orders:1") / of("single-mie") - 1.0).abs() < 1e-10);
    assert!(of("orders:2") > of("orders:1"));
    assert!(by_name("orders:3").unwrap().prepare(&cloud).unwrap().radiances(&[point]).is_err());
    let thin = FluxPoint { tau: 0.5, mu_l: 0.6 };
    let found = by_name("orders:60").unwrap().prepare(&cloud).unwrap().fluxes(&[thin]).unwrap()[0];
    let (r, t) = Solver::new(medium(), 1e-5)
        .unwrap()
        .totals(&[0.5], &[Incidence::beam(0.6).unwrap()])
        .unwrap()
        .total(0, 0);
    assert!((found.reflectance.value - r.value).abs() < 2e-4);
    assert!((found.transmittance.value - t.value).abs() < 2e-4);
}

/// Four tracers, fixed seed, within 4.5 standard errors: 8 comparisons, false alarm 5e-5.
#[test]
fn photons_agree_with_the_solver() {
    let beam = Incidence::beam(0.6).unwrap();
    let (r, _) = Solver::new(medium(), 1e-5).unwrap().totals(&[8.0], &[beam]).unwrap().total(0, 0);
    for name in ["monte-carlo", "half-space", "half-space-modified", "monte-carlo-modified"] {
        let ready = by_name(&format!("{name}:20000")).unwrap().prepare(&cloud(1.0)).unwrap();
        let found = ready.fluxes(&[FluxPoint { tau: 8.0, mu_l: 0.6 }]).unwrap()[0].reflectance;
        // The modified medium's own R differs by 1e-3.
        let allowed = 4.5 * found.std_error + if name.ends_with("modified") { 1e-3 } else { 0.0 };
        assert!((found.value - r.value).abs() < allowed, "{name}: {found:?} {r:?}");
    }
}

/// Radiance by photons through the modified medium, which has no spikes: 4.5 standard errors, false alarm 2e-5 for three views.
#[test]
fn radiance_by_photons_agrees_with_the_solver() {
    let cloud = cloud(1.0);
    let ready = by_name("monte-carlo-modified:20000").unwrap().prepare(&cloud).unwrap();
    let point = |mu_v, phi_deg, side| Point { tau: 8.0, mu_l: 0.6, mu_v, phi_deg, side };
    let points = [point(0.8, 30.0, Side::Top), point(0.5, 120.0, Side::Top), point(0.9, 90.0, Side::Bottom)];
    let views = points.map(|p| View { side: p.side, mu: p.mu_v, phi_deg: p.phi_deg });
    let solved = RadianceSolver::new(medium(), 1e-3).unwrap().radiance(&[8.0], &[0.6], &views).unwrap();
    for (i, found) in ready.radiances(&points).unwrap().iter().enumerate() {
        let truth = solved.estimate(0, 0, i, RadianceOrder::Total).value;
        // Forward events moved into the beam change these radiances by less than 1 %.
        assert!((found.value - truth).abs() < 4.5 * found.std_error + 0.01 * truth, "{found:?} {truth}");
    }
}

/// 1024 texels hold P and P_S² at angles that are no texels; f32 adds 2e-5 but at the peak's side.
#[test]
fn texels_are_near_the_tables() {
    let cloud = cloud(1.0);
    let exact = Exact::twice(&cloud).unwrap();
    let (double, single) =
        (Texels::<f64>::twice(&cloud, 1024).unwrap(), Texels::<f32>::twice(&cloud, 1024).unwrap());
    for theta in [0.5_f64, 2.0, 6.0, 20.0, 60.0, 90.0, 120.0, 139.0, 160.0, 178.3, 180.0] {
        let v = versine(theta.to_radians());
        for (found, twin, expected) in [
            (double.full(v), single.full(v as f32), exact.full(v)),
            (double.wide(v), single.wide(v as f32), exact.wide(v)),
            (double.wide_squared(v), single.wide_squared(v as f32), exact.wide_squared(v)),
        ] {
            assert!((found - expected).abs() <= 0.02 * expected, "{theta}: {found} {expected}");
            assert!((f64::from(twin) - found).abs() <= 1e-4 * found, "{theta}: {twin} {found}");
        }
    }
}
