//! Tries the adviser's promises in many random scenes: `verify-advice SEED SCENES`, CSV on stdout, the counts on stderr. Minutes.

#![allow(clippy::print_stdout, clippy::print_stderr, reason = "a program")]

#[path = "../tests/trial/mod.rs"]
mod trial;

use stratiform_advise::Data;
use stratiform_stats::{Purpose, key, photon_stream};
use trial::{Effort, Sampled, Trial, clouds, random_error, random_scene, trial};

/// Radii that are tried, none a node of the data.
const RADII_UM: [f64; 3] = [5.5, 9.0, 15.0];

const EFFORT: Effort = Effort { suns: 4, thicknesses: 4, views: 6 };

/// One scene in so many has three wavelengths, the others green alone.
const COLOURED: u64 = 4;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut args = std::env::args().skip(1);
    let seed: u64 = args.next().map_or(Ok(2027), |text| text.parse())?;
    let scenes: u64 = args.next().map_or(Ok(100), |text| text.parse())?;
    let data = Data::committed()?;
    let mut coloured = Vec::new();
    let mut green = Vec::new();
    for radius in RADII_UM {
        let waves = clouds(radius)?;
        green.push(Sampled::new(radius, waves[1..2].to_vec())?);
        coloured.push(Sampled::new(radius, waves)?);
    }
    println!("scene,max_error,met,method,channels,promised,reached,held,cheaper,points");
    let mut trials = Vec::new();
    for index in 0..scenes {
        let choice = photon_stream(key(seed + 1, Purpose::Calibration), index);
        let which = rand::Rng::next_u32(&mut { choice }) as usize % RADII_UM.len();
        let mut scene = random_scene(seed, index, RADII_UM[which], true);
        let max_error = random_error(seed, index);
        let pool = if index.is_multiple_of(COLOURED) { &coloured } else { &green };
        if !index.is_multiple_of(COLOURED) {
            scene.wavelengths_um = vec![0.55];
        }
        let one = trial(&data, &scene, max_error, &pool[which], seed.wrapping_mul(1000) + index, EFFORT)?;
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
