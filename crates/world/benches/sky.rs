//! Our clear sky and that of Hosek & Wilkie against the solver, where both know the air; how far they are apart where nobody knows;
//! what ours costs. `cargo bench -p stratiform-world --bench sky`
#![allow(
    clippy::unwrap_used,
    clippy::print_stdout,
    reason = "a benchmark prints, and may stop where it fails"
)]

#[path = "../tests/solved_sky/mod.rs"]
mod solved_sky;

use hw_skymodel::rgb::{Channel, SkyParams, SkyState};
use solved_sky::{direction, hemisphere, solvable_air, solved};
use std::time::Instant;
use stratiform_world::{Air, ClearSky, Sky};

type Radiances = Vec<[f64; 3]>;

fn main() {
    let views = hemisphere();
    println!(
        "| sun above horizon | rms, ours | rms, H & W shape | H & W level | towards 1 deg, ours |\n| ---: | ---: | ---: | ---: | ---: |"
    );
    for elevation in [85.0, 60.0, 30.0, 20.0, 10.0, 5.0] {
        against_solver(elevation, &views);
    }
    println!(
        "\n| sun above horizon | round - flat | H & W shape, median | sky/sun, T = 1 | T = 2 | T = 3 | sun's colour, T = 2 |"
    );
    println!("| ---: | ---: | ---: | ---: | ---: | ---: | --- |");
    for elevation in [85.0, 60.0, 30.0, 10.0, 5.0, 2.0] {
        where_nobody_knows(elevation, &views);
    }
    cost();
}

fn against_solver(elevation: f64, views: &[(f64, f64)]) {
    let sine = libm::sin(elevation.to_radians());
    let truth = solved(sine, views);
    let clear = ClearSky::new(direction(sine, 0.0), &solvable_air()).unwrap();
    let transmittance = clear.sun_transmittance();
    let theirs = hosek_wilkie(elevation, 1.0, 0.0, views);
    let level = mean(&theirs) / (mean(&truth) * transmittance);
    let low: Vec<(f64, f64)> = [0.0, 90.0, 180.0].map(|a| (libm::sin(1f64.to_radians()), a)).to_vec();
    println!(
        "| {elevation} | {:.4} | {:.3} | {level:.3} | {:.4} |",
        rms(&ours(&clear, views), &truth),
        rms(&scaled(&theirs, &truth), &truth),
        rms(&ours(&clear, &low), &solved(sine, &low)),
    );
}

fn where_nobody_knows(elevation: f64, views: &[(f64, f64)]) {
    let sun = direction(libm::sin(elevation.to_radians()), 0.0);
    let clear = |turbidity, radius_m| {
        ClearSky::new(
            sun,
            &Air { turbidity, radius_m, altitude_m: 0.0, ground_albedo: 0.0, ..Air::default() },
        )
        .unwrap()
    };
    let (round, flat) = (clear(2.0, 6.371e6), clear(2.0, 1e12));
    let per_sun = |sky: &ClearSky| {
        ours(sky, views)
            .into_iter()
            .map(|rgb| rgb.map(|l| l * sky.sun_transmittance()))
            .collect::<Radiances>()
    };
    let theirs = hosek_wilkie(elevation, 2.0, 0.0, views);
    let share = |turbidity| {
        let e = clear(turbidity, 6.371e6).irradiance();
        (0.2126 * e[0] + 0.7152 * e[1] + 0.0722 * e[2]) / sun.z
    };
    let [r, g, b] = round.sun_irradiance();
    println!(
        "| {elevation} | {:.3} | {:.3} | {:.3} | {:.3} | {:.3} | {r:.2} {g:.2} {b:.2} |",
        rms(&per_sun(&flat), &per_sun(&round)),
        median(&scaled(&theirs, &per_sun(&round)), &per_sun(&round)),
        share(1.0),
        share(2.0),
        share(3.0)
    );
}

fn ours(sky: &ClearSky, views: &[(f64, f64)]) -> Radiances {
    let sky = Sky::Clear(sky.clone());
    views.iter().map(|(sine, azimuth)| sky.radiance(direction(*sine, *azimuth))).collect()
}

#[allow(clippy::cast_possible_truncation, reason = "theirs is in single precision")]
fn hosek_wilkie(elevation: f64, turbidity: f32, albedo: f32, views: &[(f64, f64)]) -> Radiances {
    let params = SkyParams { elevation: elevation.to_radians() as f32, turbidity, albedo: [albedo; 3] };
    let state = SkyState::new(&params).unwrap();
    let sun = direction(libm::sin(elevation.to_radians()), 0.0);
    let of = |(sine, azimuth): &(f64, f64)| {
        let theta = libm::acos(*sine) as f32;
        let gamma = libm::acos(direction(*sine, *azimuth).dot(sun).clamp(-1.0, 1.0)) as f32;
        [Channel::R, Channel::G, Channel::B].map(|channel| f64::from(state.radiance(theta, gamma, channel)))
    };
    views.iter().map(of).collect()
}

fn mean(radiances: &[[f64; 3]]) -> f64 {
    radiances.iter().flatten().sum::<f64>() / (3 * radiances.len()) as f64
}

/// Each channel at the mean of `like`: neither level nor white counts.
fn scaled(radiances: &[[f64; 3]], like: &[[f64; 3]]) -> Radiances {
    let total = |of: &[[f64; 3]], c: usize| of.iter().fold(0.0, |sum, rgb| sum + rgb[c]);
    let factors: [f64; 3] = std::array::from_fn(|c| total(like, c) / total(radiances, c));
    radiances.iter().map(|rgb| std::array::from_fn(|c| rgb[c] * factors[c])).collect()
}

/// Over the mean of the truth.
fn rms(found: &[[f64; 3]], truth: &[[f64; 3]]) -> f64 {
    let squares = found.iter().flatten().zip(truth.iter().flatten()).map(|(a, b)| (a - b) * (a - b));
    (squares.sum::<f64>() / (3 * truth.len()) as f64).sqrt() / mean(truth)
}

/// Of the differences' magnitudes: not ruled by the aureole, which stands for the aerosol.
fn median(found: &[[f64; 3]], other: &[[f64; 3]]) -> f64 {
    let pairs = found.iter().flatten().zip(other.iter().flatten());
    let mut differences: Vec<f64> = pairs.map(|(a, b)| (a - b).abs() / b).collect();
    differences.sort_by(f64::total_cmp);
    differences[differences.len() / 2]
}

fn cost() {
    let sun = direction(0.5, 30.0);
    let start = Instant::now();
    let sky = Sky::Clear(ClearSky::new(sun, &Air::default()).unwrap());
    let built = start.elapsed().as_secs_f64();
    let table = sky.table();
    let views: Vec<_> = hemisphere().iter().map(|(sine, azimuth)| direction(*sine, *azimuth)).collect();
    let start = Instant::now();
    let rounds = 2000;
    let sum = (0..rounds).flat_map(|_| &views).fold(0.0, |sum, view| sum + sky.radiance(*view)[1]);
    let ns = 1e9 * start.elapsed().as_secs_f64() / (rounds * views.len()) as f64;
    println!(
        "\ntable {} x {}, {} bytes, {:.0} ms; look-up {ns:.0} ns ({sum:.0})",
        table.width,
        table.height,
        12 * table.values.len(),
        1e3 * built
    );
}
