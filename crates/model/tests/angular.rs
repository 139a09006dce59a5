//! The angular model's weights in both precisions against 60-digit values, and what must hold everywhere.
#![allow(
    clippy::unwrap_used,
    clippy::print_stdout,
    reason = "a test may stop where it fails, and says what it measured"
)]

use stratiform_model::angular::{Angular, Emission, PhaseLookup, Sight, as_printed};
use stratiform_model::{Form, Parameters, Real, Thickness, Values};
use stratiform_quantities::{CosZenith, Incidence, Side};

/// A row's numbers: x, μ_l, μ_v, then once and twice at the top, once and twice at the bottom.
fn rows(name: &str) -> Vec<Vec<f64>> {
    let rows: Vec<Vec<String>> = stratiform_reference_data::rows("high-precision-angular", name).unwrap();
    rows.iter().map(|row| row.iter().map(|field| field.parse().unwrap()).collect()).collect()
}

fn weights<F: Real>(x: f64, mu_l: f64, mu_v: f64, side: Side) -> (f64, f64) {
    let sight = Sight { mu_l: F::of(mu_l), mu_v: F::of(mu_v), v: F::of(1.0), side };
    let (one, two) = Angular::new(F::of(x), sight).unwrap().weights();
    (one.to_f64(), two.to_f64())
}

/// The largest error in units of the bound: (4 + 2m) ε relative, m the path whose exponential is a factor, and what the smallest
/// normal number leaves of it.
fn worst<F: Real>(epsilon: f64, tiny: f64) -> f64 {
    let mut worst = 0.0_f64;
    for row in rows("weights.csv") {
        let [x, mu_l, mu_v, exact @ ..] = &row[..] else { panic!("{row:?}") };
        for (side, exact) in Side::BOTH.into_iter().zip(exact.chunks(2)) {
            let (one, two) = weights::<F>(*x, *mu_l, *mu_v, side);
            let nearest = if side == Side::Top { 0.0 } else { x / mu_l.max(*mu_v) };
            let floor = tiny * (1.0 + nearest) * (x / (mu_v * mu_v)).max(1.0 / mu_v);
            for (value, exact) in [(one, exact[0]), (two, exact[1])] {
                let bound = epsilon * (4.0 + 2.0 * nearest) * exact + floor;
                let error = (value - exact).abs() / bound;
                assert!(error < 1.0, "{side} {row:?}: {value:e} against {exact:e}");
                worst = worst.max(error);
            }
        }
    }
    worst
}

#[test]
fn neither_precision_loses_anything() {
    let double = worst::<f64>(f64::EPSILON, f64::MIN_POSITIVE);
    let single = worst::<f32>(f64::from(f32::EPSILON), f64::from(f32::MIN_POSITIVE));
    println!("largest error over bound: {double:.2} in f64, {single:.2} in f32");
}

#[test]
fn the_weights_are_the_integrals_over_depth() {
    for row in rows("weights-by-quadrature.csv") {
        let (top, bottom) = (
            weights::<f64>(row[0], row[1], row[2], Side::Top),
            weights::<f64>(row[0], row[1], row[2], Side::Bottom),
        );
        for (value, exact) in [top.0, top.1, bottom.0, bottom.1].iter().zip(&row[3..]) {
            assert!((value / exact - 1.0).abs() < 1e-14, "{row:?}: {value}");
        }
    }
}

/// The bound is sharp: the printed quotient in single precision, near μ_l = μ_v, is far outside.
#[test]
fn the_printed_quotient_would_be_seen() {
    let row = rows("weights.csv").into_iter().find(|row| row[0] == 1.0 && row[1] > 0.7 && row[1] < 0.71);
    let row = row.unwrap();
    let (x, mu_l, mu_v) = (row[0] as f32, row[1] as f32, 0.7_f32);
    let naive = f64::from((libm::expf(-x / mu_v) - libm::expf(-x / mu_l)) / (mu_v - mu_l));
    let (exact, _) = weights::<f64>(row[0], row[1], f64::from(mu_v), Side::Bottom);
    assert!((naive / exact - 1.0).abs() > 100.0 * f64::from(f32::EPSILON), "{naive} {exact}");
}

/// Constant functions stand in for tables.
struct Even;

impl<F: Real> PhaseLookup<F> for Even {
    fn full(&self, _: F) -> F {
        F::of(1.0)
    }

    fn wide(&self, _: F) -> F {
        F::of(1.0)
    }

    fn wide_squared(&self, _: F) -> F {
        F::of(1.0)
    }
}

fn fluxes<F: Real>(mu_l: f64, h: f64) -> stratiform_model::Fluxes<F> {
    let values = Values { beta: 0.9961, b: 0.8, c: 0.02, kappa_c: 0.047, t: 0.75, r: 0.1, kappa_s: 0.0252 };
    let light = Incidence::Beam(CosZenith::new(mu_l).unwrap());
    Parameters::new(&values, light).unwrap().fluxes(Form::Corrected, Thickness::new(F::of(h)).unwrap())
}

fn finite_everywhere<F: Real>() {
    let cosines = [1.0, 0.999_999_9, 0.5, 0.1, 0.01, 1e-4];
    let depths: Vec<f64> = (-18..=9).map(|k| libm::pow(10.0, 0.5 * f64::from(k))).chain([0.0]).collect();
    for (mu_l, mu_v) in [0.0].iter().chain(&cosines).flat_map(|l| cosines.iter().map(move |v| (*l, *v))) {
        for (x, side) in depths.iter().flat_map(|x| Side::BOTH.map(|side| (*x, side))) {
            let sight = Sight { mu_l: F::of(mu_l), mu_v: F::of(mu_v), v: F::of(0.3), side };
            let slab = Angular::new(F::of(x), sight).unwrap();
            let fluxes = fluxes(mu_l, (x / 0.0252).min(1e6));
            for emission in Emission::ALL {
                let orders = slab.orders(&Even, &fluxes, emission);
                let (one, two) = (orders.one.to_f64(), orders.two.to_f64());
                assert!(one >= 0.0 && one.is_finite(), "I1 {one} {side} x {x} {mu_l} {mu_v}");
                assert!(two >= 0.0 && two.is_finite(), "I2 {two} {side} x {x} {mu_l} {mu_v}");
                assert!(orders.total().to_f64().is_finite());
            }
            let printed = as_printed::orders(&slab, F::of(0.0252), &Even, &fluxes);
            assert!(printed.total().to_f64().is_finite(), "{side} x {x} {mu_l} {mu_v}");
        }
    }
}

#[test]
fn no_radiance_is_negative_or_not_a_number() {
    finite_everywhere::<f64>();
    finite_everywhere::<f32>();
}

/// πL/(μ_l F0) of light that goes once through or back is the same with sun and viewer exchanged.
#[test]
fn sun_and_viewer_may_be_exchanged() {
    for (a, b) in [(0.9, 0.2), (0.31, 0.3), (1e-3, 1.0)] {
        for (x, side) in [1e-3, 1.0, 30.0].into_iter().flat_map(|x| Side::BOTH.map(|side| (x, side))) {
            let (one, two) = (weights::<f64>(x, a, b, side), weights::<f64>(x, b, a, side));
            assert!((one.0 - two.0).abs() <= 1e-14 * one.0 && (one.1 - two.1).abs() <= 1e-14 * one.1);
        }
    }
}

#[test]
fn input_outside_the_domain_is_refused() {
    let sight = Sight { mu_l: 0.5, mu_v: 0.5, v: 1.0, side: Side::Top };
    assert!(Angular::new(1.0, sight).is_ok());
    assert!(Angular::new(0.0, Sight { mu_l: 0.0, ..sight }).is_ok());
    for x in [-1e-9, f64::NAN, f64::INFINITY] {
        assert!(Angular::new(x, sight).is_err(), "{x}");
    }
    for sight in [
        Sight { mu_l: -0.1, ..sight },
        Sight { mu_l: f64::NAN, ..sight },
        Sight { mu_v: 0.0, ..sight },
        Sight { mu_v: 1.1, ..sight },
        Sight { v: 2.1, ..sight },
        Sight { v: f64::NAN, ..sight },
    ] {
        assert!(Angular::new(1.0, sight).is_err(), "{sight:?}");
    }
}

/// The printed forms differ from the corrected ones by exactly what the paper gets wrong.
#[test]
fn the_printed_forms_are_off_by_their_slips() {
    let (kappa, four_pi) = (0.0252, 4.0 * std::f64::consts::PI);
    for side in Side::BOTH {
        let v = if side == Side::Top { 1.5 } else { 0.5 };
        let slab = Angular::new(0.7, Sight { mu_l: 0.6, mu_v: 0.4, v, side }).unwrap();
        let fluxes = fluxes(0.6, 0.7 / kappa);
        let (printed, corrected) = (
            as_printed::orders(&slab, kappa, &Even, &fluxes),
            slab.orders(&Even, &fluxes, Emission::Isotropic),
        );
        assert!((printed.one / (four_pi * kappa * corrected.one) - 1.0).abs() < 1e-14);
        assert!((printed.three_plus / corrected.three_plus - 0.5).abs() < 1e-14);
        let per_unit = as_printed::two_per_unit(&slab, &Even);
        assert!((printed.two / (four_pi * kappa * kappa * per_unit) - 1.0).abs() < 1e-14);
    }
    // Low sun seen against the light from above: cosΘ > 0, and the printed test takes it for transmitted light.
    let glint = Sight::new(0.2, 0.2, 0.0, Side::Top).unwrap();
    assert_eq!(as_printed::side(&glint), Side::Bottom);
    assert_eq!(as_printed::wide(3.0, 0.25, 0.1, 0.2), 4.0);
    assert_eq!(as_printed::wide(3.0, 0.25, 0.2, 0.2), 0.0);
}
