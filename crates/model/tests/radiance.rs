//! Laws that the radiance model keeps whatever its coefficients are.

#![allow(clippy::unwrap_used, reason = "a test may stop where it fails")]

use stratiform_model::angular::{PhaseLookup, Sight};
use stratiform_model::radiance::{Coefficients, POWERS, Slab, TERMS};
use stratiform_quantities::Side;

/// P_S = 1.
struct Even;

impl PhaseLookup<f64> for Even {
    fn full(&self, _: f64) -> f64 {
        1.0
    }

    fn wide(&self, _: f64) -> f64 {
        1.0
    }

    fn wide_squared(&self, _: f64) -> f64 {
        1.0
    }
}

impl PhaseLookup<f32> for Even {
    fn full(&self, _: f32) -> f32 {
        1.0
    }

    fn wide(&self, _: f32) -> f32 {
        1.0
    }

    fn wide_squared(&self, _: f32) -> f32 {
        1.0
    }
}

/// Coefficients of the size that fits give, of both signs.
fn cloud() -> Coefficients<f64> {
    let face = |start: f64| -> [[f64; TERMS]; POWERS] {
        std::array::from_fn(|j| {
            std::array::from_fn(|k| {
                let n = (16 * j + k) as f64;
                4.0 * (2.0 * (start + n * 0.618_033_988_75).fract() - 1.0)
            })
        })
    };
    Coefficients { similarity: 0.147, kept: 0.545, top: face(0.1), bottom: face(0.7) }
}

fn sights() -> Vec<Sight<f64>> {
    let cosines = [1e-4, 0.01, 0.3, 0.7, 1.0];
    let mut all = Vec::new();
    for mu_l in cosines.into_iter().chain([0.0]) {
        for mu_v in cosines {
            for phi in [0.0, 77.0, 180.0] {
                all.extend(Side::BOTH.map(|side| Sight::new(mu_l, mu_v, phi, side).unwrap()));
            }
        }
    }
    all
}

#[test]
fn nothing_is_negative_or_infinite_anywhere_in_the_domain() {
    let (double, single) = (cloud(), cloud().cast::<f32>());
    for sight in sights() {
        for tau in [0.0, 1e-30, 1e-6, 1e-3, 1.0, 50.0, 1e4, 1e6] {
            let value = Slab::new(&double, tau, sight).unwrap().radiance(&Even);
            let in_single = Slab::new(&single, tau as f32, sight.cast()).unwrap().radiance(&Even);
            assert!(value.is_finite() && value >= 0.0, "{tau} {sight:?}: {value}");
            assert!(in_single.is_finite() && in_single >= 0.0, "{tau} {sight:?}: {in_single}");
            assert!(
                (f64::from(in_single) - value).abs() <= 2e-4 * value + 1e-30,
                "{tau} {sight:?}: {in_single} {value}"
            );
        }
    }
}

#[test]
fn sun_and_view_can_be_exchanged() {
    let cloud = cloud();
    for sight in sights().into_iter().filter(|sight| sight.mu_l > 0.0) {
        let other = Sight { mu_l: sight.mu_v, mu_v: sight.mu_l, ..sight };
        for tau in [0.1, 3.0, 100.0] {
            let [a, b] = [sight, other].map(|sight| Slab::new(&cloud, tau, sight).unwrap().radiance(&Even));
            assert!((a / b - 1.0).abs() < 1e-13, "{tau} {sight:?}: {a} {b}");
        }
    }
}

/// M falls like τ² in thin slabs; in thick ones it stays at the top and falls like 1/τ at the bottom.
#[test]
fn thin_and_thick_limits_are_those_of_theory() {
    let cloud = cloud();
    let more = |tau, side| Slab::new(&cloud, tau, Sight::new(0.6, 0.8, 50.0, side).unwrap()).unwrap().more();
    for side in Side::BOTH {
        let slope = libm::log10(more(1e-5, side) / more(1e-6, side));
        assert!((slope - 2.0).abs() < 1e-3, "{slope}");
    }
    assert!((more(1e6, Side::Top) / more(1e5, Side::Top) - 1.0).abs() < 1e-2);
    assert!((more(1e6, Side::Bottom) / more(1e5, Side::Bottom) / 0.1 - 1.0).abs() < 1e-2);
}

#[test]
fn what_lies_outside_is_refused() {
    let cloud = cloud();
    let sight = Sight::new(0.5, 0.5, 0.0, Side::Top).unwrap();
    for tau in [-1.0, 2e6, f64::NAN] {
        assert!(Slab::new(&cloud, tau, sight).is_err());
    }
    for wrong in [Sight { mu_v: 0.0, ..sight }, Sight { mu_l: 1.1, ..sight }, Sight { v: f64::NAN, ..sight }]
    {
        assert!(Slab::new(&cloud, 1.0, wrong).is_err());
    }
    assert!(Coefficients { similarity: 0.0, ..cloud.clone() }.check().is_err());
    let mut planted = cloud;
    planted.bottom[3][7] = f64::NAN;
    assert!(planted.check().is_err());
}
