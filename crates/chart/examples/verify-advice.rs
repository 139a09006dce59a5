//! Tries the adviser's promises in many random scenes: `verify-advice SEED SCENES`, CSV on stdout, the counts on stderr. Minutes.

#![allow(clippy::print_stdout, clippy::print_stderr, reason = "a program")]

#[path = "../tests/trial/mod.rs"]
mod trial;

use stratiform_advise::Data;
use stratiform_stats::{Purpose, key, photon_stream};
use trial::{Effort, Pool, Trial, clouds, random_error, random_scene, trial};

/// Radii that are tried, none a node of the data; at the one in the middle in three wavelengths, else in green alone.
const RADII_UM: [f64; 3] = [5.5, 9.0, 15.0];

const EFFORT: Effort = Effort { suns: 6, thicknesses: 10, views: 40, effects: 6 };

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut args = std::env::args().skip(1);
    let seed: u64 = args.next().map_or(Ok(2029), |text| text.parse())?;
    let scenes: u64 = args.next().map_or(Ok(100), |text| text.parse())?;
    let data = Data::committed()?;
    let mut pools = Vec::new();
    for (place, radius) in RADII_UM.into_iter().enumerate() {
        let all = clouds(radius)?;
        let waves = if place == 1 { all } else { all[1..2].to_vec() };
        pools.push(Pool::new(radius, waves, seed.wrapping_mul(1000) + place as u64, EFFORT)?);
        eprintln!("r_e {radius:4} um         {} points", pools[place].points.len());
    }
    println!("scene,max_error,met,method,channels,promised,reached,held,cheaper,points");
    let mut trials = Vec::new();
    for index in 0..scenes {
        let choice = photon_stream(key(seed + 1, Purpose::Calibration), index);
        let pool = &pools[rand::Rng::next_u32(&mut { choice }) as usize % pools.len()];
        let max_error = random_error(seed, index);
        let one = trial(&data, &random_scene(seed, index, pool, true), max_error, pool)?;
        println!("{}", row(index, max_error, &one));
        trials.push(one);
    }
    let count = |what: fn(&Trial) -> bool| trials.iter().filter(|one| what(one)).count();
    eprintln!("promise held          {} of {scenes}", count(Trial::held));
    eprintln!("nothing cheaper met   {} of {scenes}", count(Trial::cheapest));
    eprintln!("budget met            {} of {scenes}", count(|one| one.advice.met));
    eprintln!("both where it was met {}", count(|one| one.advice.met && one.held() && one.cheapest()));
    Ok(())
}

fn row(index: u64, max_error: f64, one: &Trial) -> String {
    let (advice, reached) = (&one.advice, one.reached);
    let cheaper: Vec<String> = one.cheaper.iter().map(|(name, error)| format!("{name} {error:.3}")).collect();
    format!(
        "{index},{max_error:.4},{},{},{:?},{:.4},{reached:.4},{},{},{}",
        advice.met,
        advice.method,
        advice.channels,
        advice.prediction.error,
        one.held(),
        cheaper.join(" "),
        one.points
    )
}
