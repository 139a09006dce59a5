//! The weights from plane to plane against closed forms, against light summed texel by texel, and against themselves planted wrong.

#![allow(
    clippy::unwrap_used,
    clippy::print_stdout,
    reason = "a test may stop where it fails, and says what it measured"
)]

mod radiosity_common;
mod radiosity_truth;

use radiosity_common::{BASE_M, EXTENT_M, uniform, waves};
use radiosity_truth::{FINER, RULES, by_rule, error, irradiance};
use std::f64::consts::FRAC_1_SQRT_2;
use stratiform_render::RingRule;
use stratiform_render::radiosity::{Weights, form_factor, side_for};

#[test]
fn form_factors_have_their_known_values() {
    // Radius h, 2h, 8h: 1/2, 4/5, 64/65.
    for (radius, exact) in [(1.0, 0.5), (2.0, 0.8), (8.0, 64.0 / 65.0)] {
        assert!((form_factor::disc(radius, 1.0) - exact).abs() < 1e-15);
    }
    // A corner of a cube's face sees the opposite face: atan(1/√2)/(π √2).
    let exact = FRAC_1_SQRT_2 * libm::atan(FRAC_1_SQRT_2) / std::f64::consts::PI;
    assert!((form_factor::rectangle([0.0, 0.0], [1.0, 1.0], 1.0) - exact).abs() < 1e-15);
    // Far above, an area times cosines over π r²; below a half plane, 1/2; below a plane, 1.
    let far = form_factor::rectangle([300.0, 400.0], [301.0, 401.0], 1000.0);
    let (x, y, h) = (300.5, 400.5, 1000.0);
    let square = x * x + y * y + h * h;
    assert!((far / (h * h / (std::f64::consts::PI * square * square)) - 1.0).abs() < 1e-6);
    assert!((form_factor::square(1e9, 1.0) - 1.0).abs() < 1e-15);
    assert!((form_factor::rectangle([0.0, -1e9], [1e9, 1e9], 1.0) - 0.5).abs() < 1e-9);
}

/// A white square of 9 texels' side on 128 x 128: the light at a texel's centre below and beside it.
#[test]
fn a_square_cloud_lights_the_ground_by_its_closed_form() {
    let worst = |rule| {
        let mut worst = 0.0_f64;
        for h in [2.25, 4.5, 9.0] {
            let weights = Weights::new(rule, 128, 1.0, h).unwrap();
            for (east, north) in [(0, 0), (3, 1), (4, 4), (9, 2), (20, 0), (18, 18)] {
                let spans = [-east - 4..=4 - east, -north - 4..=4 - north];
                let wrapped = |i: i32| i.rem_euclid(128) as usize;
                let light: f64 = spans[1]
                    .clone()
                    .flat_map(|y| spans[0].clone().map(move |x| (x, y)))
                    .map(|(x, y)| weights.values()[wrapped(y) * 128 + wrapped(x)])
                    .sum();
                let [x, y] = [f64::from(-east), f64::from(-north)];
                let closed = form_factor::rectangle([x - 4.5, y - 4.5], [x + 4.5, y + 4.5], h);
                worst = worst.max((light - closed).abs());
            }
        }
        worst
    };
    let found = RULES.map(worst);
    println!("largest error below and beside a square: {found:?}");
    let [printed, wider, squares, exact, fitted] = found;
    // Images of the square that the closed form does not have: at most 2e-4 of the hemisphere.
    assert!(exact < 2e-4 && fitted < 0.03, "{found:?}");
    assert!(printed > 0.2 && wider > 0.1 && squares > 0.1, "the comparator sees them: {found:?}");
}

/// Errors of the irradiance over its mean at the default size, and that `LeastSquares` is the best of the rules.
#[test]
fn the_default_rule_is_the_nearest_to_light_summed_one_by_one() {
    let (side, patches) = (16 * FINER, |h: &f64| if *h > 0.8 { 0.8 } else { 0.15 });
    let h = BASE_M / EXTENT_M * side as f64;
    let mut worst = [[0.0_f64; 2]; 5];
    for seed in 0..3 {
        let field: Vec<f64> = waves(seed, side, 3).iter().map(patches).collect();
        let truth = irradiance(&field, side, h);
        for (worst, rule) in worst.iter_mut().zip(RULES) {
            let [rms, most] = error(&by_rule(rule, &field, side, h), &truth);
            *worst = [worst[0].max(rms), worst[1].max(most)];
        }
    }
    println!("rms and largest error over the mean: {worst:?}");
    let [rings @ .., exact, fitted] = worst;
    assert!(fitted[0] < 0.012 && fitted[1] < 0.06 && exact[0] < 0.04, "{worst:?}");
    assert!(rings.iter().all(|rule| rule[0] > 0.08), "the comparator sees them: {worst:?}");
}

/// Sides, heights in texels: texels wider than h, squares wider than the period, odd sides, one texel.
const GRIDS: [(usize, f64); 7] = [(16, 2.0), (32, 4.0), (7, 0.3), (16, 0.1), (5, 20.0), (2, 1.0), (1, 3.0)];

#[test]
fn what_one_plane_gives_out_the_other_receives() {
    for rule in RULES {
        for (side, h) in GRIDS {
            let weights = Weights::new(rule, side, 1.0, h).unwrap();
            let light: Vec<[f64; 3]> =
                (0..side * side).map(|i| [0, 1, 2].map(|c| uniform(c, i as u64))).collect();
            let total = |light: &[[f64; 3]]| light.iter().flatten().sum::<f64>();
            let (given, received) = (total(&light), total(&weights.gather(&light)));
            assert!((received / given - 1.0).abs() < 1e-12, "{rule:?} {side} {h}: {given} {received}");
            let w = weights.values();
            for i in 0..side * side {
                let back = (side - i / side) % side * side + (side - i % side) % side;
                assert!(w[i] >= 0.0 && (w[i] - w[back]).abs() < 1e-15, "{rule:?} {side} {h} {i}: {}", w[i]);
            }
        }
    }
}

#[test]
fn wide_periods_of_low_clouds_need_more_texels() {
    let sides = [(16000.0, 2000.0, 16), (16001.0, 2000.0, 32), (48000.0, 1500.0, 64), (48000.0, 800.0, 128)];
    for (extent, h, side) in sides {
        assert_eq!(side_for(extent, h), side);
    }
}

#[test]
fn grids_that_make_no_sense_are_refused() {
    for (side, texel, h) in
        [(0, 1.0, 1.0), (129, 1.0, 1.0), (16, 0.0, 1.0), (16, 1.0, 0.0), (16, 1.0, f64::NAN)]
    {
        assert!(Weights::new(RingRule::Exact, side, texel, h).is_err(), "{side} {texel} {h}");
    }
}
