//! What every method promises: inside its declared domain finite values that are not negative, in both precisions; outside a refusal.
#![allow(clippy::unwrap_used, reason = "a test may stop where it fails")]

mod common;

use common::cloud;
use stratiform_methods::{Cloud, FluxPoint, Method, MethodError, Point, Ready, all, by_name, knobs};
use stratiform_model::angular::Sight;
use stratiform_quantities::Side;

const TAU: [f64; 15] = [0.0, 1e-6, 1e-3, 0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 40.0, 100.0, 1e3, 1e4];
const MU: [f64; 8] = [1e-4, 1e-2, 0.1, 0.3, 0.5, 0.7, 0.95, 1.0];
const PHI: [f64; 3] = [0.0, 90.0, 180.0];

/// Points of the sweep that lie inside the domain of `method`.
fn points(method: &dyn Method) -> Vec<Point> {
    let mut points = Vec::new();
    for tau in TAU {
        for mu_l in MU {
            for mu_v in MU {
                for phi_deg in PHI {
                    points.extend(Side::BOTH.map(|side| Point { tau, mu_l, mu_v, phi_deg, side }));
                }
            }
        }
    }
    points.retain(|point| method.card().domain.check(point).is_ok());
    points
}

fn flux_points(method: &dyn Method) -> Vec<FluxPoint> {
    let all = TAU.iter().flat_map(|tau| MU.map(|mu_l| FluxPoint { tau: *tau, mu_l }));
    all.filter(|point| method.card().domain.check_flux(point).is_ok()).collect()
}

fn sound(value: f64, what: impl Fn() -> String) {
    assert!(value.is_finite() && value >= 0.0, "{}: {value}", what());
}

fn sweep(method: &dyn Method, cloud: &Cloud) {
    let name = &method.card().name;
    let ready = method.prepare(cloud).unwrap();
    if method.card().radiance {
        let points = points(method);
        for (point, value) in points.iter().zip(ready.radiances(&points).unwrap()) {
            sound(value.value, || format!("{name} {point:?}"));
            if let Some(single) = ready.single() {
                let sight = Sight::new(point.mu_l, point.mu_v, point.phi_deg, point.side).unwrap();
                let value = single.radiance(point.tau as f32, &sight.cast());
                sound(f64::from(value), || format!("{name} f32 {point:?}"));
            }
        }
    }
    if method.card().flux {
        fluxes(method, &*ready);
    }
}

fn fluxes(method: &dyn Method, ready: &dyn Ready) {
    let name = &method.card().name;
    let points = flux_points(method);
    for (point, pair) in points.iter().zip(ready.fluxes(&points).unwrap()) {
        for value in [pair.reflectance.value, pair.transmittance.value] {
            sound(value, || format!("{name} {point:?}"));
        }
        if let Some(single) = ready.single() {
            let (r, t) = single.fluxes(point.tau as f32, point.mu_l as f32);
            sound(f64::from(r), || format!("{name} f32 R {point:?}"));
            sound(f64::from(t), || format!("{name} f32 T {point:?}"));
        }
    }
}

/// Solvers and tracers have contracts of their own in `transport`; a few points of theirs are enough here.
fn is_formula(method: &dyn Method) -> bool {
    method.card().table_bytes.is_some()
}

#[test]
fn formulas_are_finite_and_not_negative_inside_their_domain() {
    for omega in [1.0, 0.999_999, 0.9, 0.5] {
        let cloud = cloud(omega);
        for method in all().iter().filter(|method| is_formula(&***method)) {
            if method.card().domain.omega.contains(omega) {
                sweep(&**method, &cloud);
            } else {
                assert!(
                    matches!(method.prepare(&cloud), Err(MethodError::Domain(_))),
                    "{}",
                    method.card().name
                );
            }
        }
    }
}

#[test]
fn outside_is_refused() {
    let cloud = cloud(1.0);
    for method in all() {
        let ready = method.prepare(&cloud).unwrap();
        let inside = Point { tau: 5.0, mu_l: 0.5, mu_v: 0.5, phi_deg: 90.0, side: Side::Top };
        for point in [
            Point { tau: -1.0, ..inside },
            Point { tau: f64::NAN, ..inside },
            Point { tau: 1e7, ..inside },
            Point { mu_l: 0.0, ..inside },
            Point { mu_v: 1.1, ..inside },
            Point { phi_deg: 361.0, ..inside },
        ] {
            assert!(ready.radiances(&[point]).is_err(), "{} {point:?}", method.card().name);
        }
        for (tau, mu_l) in [(-1.0, 0.5), (f64::NAN, 0.5), (5.0, 0.0), (5.0, f64::NAN)] {
            assert!(ready.fluxes(&[FluxPoint { tau, mu_l }]).is_err(), "{}", method.card().name);
        }
    }
}

#[test]
fn names_lead_to_methods() {
    for method in all() {
        let name = &method.card().name;
        assert_eq!(&by_name(name).unwrap().card().name, name);
        let stem = name.split(':').next().unwrap();
        for value in knobs(stem).map_or(&[][..], |knob| knob.values) {
            assert!(by_name(&format!("{stem}:{value}")).is_ok());
        }
    }
    assert_eq!(by_name("octaves").unwrap().card().name, "octaves:8");
    let unknown = by_name("radiosity").map(|_| ()).unwrap_err().to_string();
    assert!(unknown.contains("radiosity") && unknown.contains("octaves"), "{unknown}");
    for name in
        ["octaves:", "octaves:x", "octaves:0", "octaves:1.5", "octaves:NaN", "single-hg:3", "single-mie:63"]
    {
        assert!(by_name(name).is_err(), "{name}");
    }
}

/// The models for a range of droplets serve all of it and nothing else; droplets without r_e have no table in the family.
#[test]
fn droplet_sizes_outside_the_range_are_refused() {
    let of = |r_eff_um| {
        let one = cloud(1.0);
        Cloud::new((**one.phase()).clone(), one.omega(), one.theta_f_deg(), r_eff_um).unwrap()
    };
    for name in ["fitted", "fitted-halo", "bouthors-family"] {
        let prepared = |radius| by_name(name).unwrap().prepare(&of(radius));
        assert!(prepared(Some(4.0)).is_ok() && prepared(Some(20.0)).is_ok(), "{name}");
        for radius in [3.99, 20.01] {
            assert!(matches!(prepared(Some(radius)), Err(MethodError::Domain(_))), "{name} {radius}");
        }
    }
    assert!(matches!(by_name("bouthors-family").unwrap().prepare(&of(None)), Err(MethodError::Domain(_))));
    assert!(by_name("bouthors-corrected").unwrap().prepare(&of(Some(8.0))).is_err());
}

/// Formulas whose two precisions evaluate the same functions: those without tables, and those on texels in both.
fn twins() -> Vec<Box<dyn Method>> {
    let mut twins = all();
    twins.retain(|method| method.card().table_bytes == Some(0) && method.card().radiance);
    let on_texels = ["single-mie:256", "bouthors-corrected:256", "bouthors-corrected-halo:256"];
    twins.extend(on_texels.map(|name| by_name(name).unwrap()));
    twins
}

/// The shader's arithmetic against double precision, relative to the value down to 1e-30, beyond which f32 has no digits. Exponents to
/// 70 cost 70 ε, the steepest phase function (1-g)^-1 ε, 2 - v near the glory as many digits as v has, on texels.
#[test]
fn both_precisions_agree() {
    let cloud = cloud(1.0);
    for method in twins() {
        let ready = method.prepare(&cloud).unwrap();
        let single = ready.single().unwrap();
        let points = points(&*method);
        for (point, value) in points.iter().zip(ready.radiances(&points).unwrap()) {
            let sight = Sight::new(point.mu_l, point.mu_v, point.phi_deg, point.side).unwrap();
            let off = f64::from(single.radiance(point.tau as f32, &sight.cast())) / value.value - 1.0;
            let bound = if method.card().table_bytes == Some(0) { 1e-4 } else { 2e-3 };
            assert!(value.value < 1e-30 || off.abs() < bound, "{} {point:?}: {off:e}", method.card().name);
        }
    }
}
