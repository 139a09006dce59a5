//! Errors of the rules that carry light between ground and cloud, and how fast the exchange converges.
//!
//! `cargo run -p stratiform-render --example rings`

#![allow(
    clippy::unwrap_used,
    clippy::print_stdout,
    clippy::disallowed_methods,
    reason = "an example prints, and stops where it fails"
)]

#[path = "../tests/radiosity_common/mod.rs"]
mod radiosity_common;
#[path = "../tests/radiosity_truth/mod.rs"]
mod truth;

use radiosity_common::{BASE_M, EXTENT_M, waves};
use stratiform_render::RingRule;
use stratiform_render::radiosity::{Planes, Weights, form_factor, kept, passes_for};
use truth::{FINER, RULES, by_rule, error, irradiance};

/// Share of texel `(x, y)` that lies in the shape, by 8 x 8 points; the origin is the centre of texel 0 of a grid that wraps.
fn covered(side: usize, inside: impl Fn(f64, f64) -> bool) -> Vec<[f64; 3]> {
    let along = |i: usize, k: usize| {
        let near = if 2 * i < side { i as f64 } else { i as f64 - side as f64 };
        near + (k as f64 + 0.5) / 8.0 - 0.5
    };
    let share = |i: usize| {
        let hits = (0..64).filter(|k| inside(along(i % side, k % 8), along(i / side, k / 8))).count();
        [hits as f64 / 64.0; 3]
    };
    (0..side * side).map(share).collect()
}

/// Texels along a shape and along the period.
const ACROSS: f64 = 9.0;
const PERIOD: usize = 128;

/// Light at the origin of a plane below a black one with a white shape; `h` in texels.
fn below(rule: RingRule, h: f64, inside: impl Fn(f64, f64) -> bool) -> f64 {
    let weights = Weights::new(rule, PERIOD, 1.0, h).unwrap();
    covered(PERIOD, inside).iter().zip(weights.values()).map(|(light, weight)| light[0] * weight).sum()
}

fn closed_forms() {
    println!("Light below a white shape that is {ACROSS} texels wide, by its width over h:");
    println!(
        "{:28}{:>10}{}",
        "",
        "closed",
        RULES.map(|rule| format!("{:>15}", format!("{rule:?}"))).concat()
    );
    let half = 0.5 * ACROSS;
    for size in [1.0, 2.0, 4.0, 8.0] {
        let h = ACROSS / size;
        let found = RULES.map(|rule| below(rule, h, |x, y| x.abs() < half && y.abs() < half));
        row(&format!("square of side {size} h"), form_factor::square(size, 1.0), found);
        let found = RULES.map(|rule| below(rule, h, |x, y| x * x + y * y < half * half));
        row(&format!("disc of radius {} h", 0.5 * size), form_factor::disc(0.5 * size, 1.0), found);
    }
    for away in [1.0, 2.0, 4.0] {
        let near = half * away;
        let found = RULES.map(|rule| below(rule, half, |x, y| (x - near).abs() < half && y.abs() < half));
        let closed = form_factor::rectangle([away - 1.0, -1.0], [away + 1.0, 1.0], 1.0);
        row(&format!("square of side 2 h, {away} h off"), closed, found);
    }
}

fn row(name: &str, closed: f64, found: [f64; 5]) {
    println!("{name:28}{closed:>10.4}{}", found.map(|value| format!("{value:>15.4}")).concat());
}

fn fields() {
    println!(
        "\nError of the irradiance over its mean, rms (largest), against {FINER} x {FINER} finer texels summed one by one:"
    );
    let patches = |h: &f64| if *h > 0.8 { 0.8 } else { 0.15 };
    let smooth = |h: &f64| (1.0 + 0.3 * h).max(0.0);
    for side in [4, 8, 16, 32] {
        let fine = FINER * side;
        let h = BASE_M / EXTENT_M * fine as f64;
        for (name, finest, field) in
            [("ice in land", 3, &patches as &dyn Fn(&f64) -> f64), ("broken cloud", 6, &smooth)]
        {
            let fields: Vec<Vec<f64>> =
                (0..3).map(|seed| waves(seed, fine, finest).iter().map(field).collect()).collect();
            let truths: Vec<Vec<f64>> = fields.iter().map(|field| irradiance(field, fine, h)).collect();
            let errors = RULES.map(|rule| {
                let pairs = fields.iter().zip(&truths);
                let errors = pairs.map(|(field, truth)| error(&by_rule(rule, field, fine, h), truth));
                let worst = errors.fold([0.0_f64; 2], |a, b| [a[0].max(b[0]), a[1].max(b[1])]);
                format!("{:>15}", format!("{:.4} ({:.3})", worst[0], worst[1]))
            });
            println!(
                "{:38}{}",
                format!("{name}, {side} x {side}, h = {} texels", side as f64 * BASE_M / EXTENT_M),
                errors.concat()
            );
        }
    }
}

fn convergence() {
    println!(
        "\nShare of the exchanged light that is missing after n pairs of passes, cloud of albedo 0.2 to 0.8:"
    );
    let cloud: Vec<[f64; 3]> =
        waves(9, 16, 3).iter().map(|h| [(0.5 + 0.15 * h).clamp(0.2, 0.8); 3]).collect();
    for albedo in [0.2, 0.8] {
        let planes = Planes {
            weights: Weights::new(RingRule::LeastSquares, 16, EXTENT_M / 16.0, BASE_M).unwrap(),
            ground_albedo: vec![[albedo; 3]; 256],
            cloud_albedo: cloud.clone(),
            ground_source: vec![[0.5; 3]; 256],
            cloud_source: vec![[0.3; 3]; 256],
        };
        let total = |passes| planes.exchange(passes).cloud.iter().map(|light| light[0]).sum::<f64>();
        let all = total(200);
        let q = kept(&planes.weights, &planes.ground_albedo, &planes.cloud_albedo);
        println!("ground albedo {albedo}: q = {q:.4}, {} pairs for 1e-3", passes_for(q, 1e-3).unwrap());
        for passes in [1, 2, 3, 4, 6, 8, 12] {
            let missing = 1.0 - total(passes) / all;
            println!("  n = {passes:2}: {missing:.2e}, bound {:.2e}", libm::pow(q, f64::from(passes)));
        }
    }
}

fn main() {
    closed_forms();
    fields();
    convergence();
}
