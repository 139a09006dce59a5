//! How many wavelengths the colour of a phase function needs: the paper's cloud, against 33 wavelengths.
//!
//! Usage: `cargo run --release -p stratiform-tables --example colour_error`
//!
//! Prints, for equally spaced wavelengths and for the three of `fit-configs/appendix-b.toml`, the largest and the mean (over the
//! sphere) difference of a channel over the luminance, beside the estimate that [`colour_error`] makes by itself.
#![allow(clippy::print_stdout, reason = "an example talks")]

use serde_json::json;
use std::error::Error;
use stratiform_optics::phase::PhaseTable;
use stratiform_optics::{OpticsConfig, compute};
use stratiform_tables::colour::{SrgbPhase, colour_error, srgb_phase};

/// Wavelengths of the truth, µm.
const SHORTEST: f64 = 0.39;
const LONGEST: f64 = 0.71;
const MOST: usize = 33;

type Spectrum = Vec<(f64, PhaseTable)>;

fn main() -> Result<(), Box<dyn Error>> {
    let at = |i: usize| SHORTEST + (LONGEST - SHORTEST) * i as f64 / (MOST - 1) as f64;
    let all = spectrum(&(0..MOST).map(at).collect::<Vec<_>>())?;
    let truth = srgb_phase(&all)?;
    let (least, theta) = truth.smallest_channel();
    println!(
        "{MOST} wavelengths from {SHORTEST} to {LONGEST} um: smallest channel {least:.4} at {theta:.2} degrees"
    );
    println!("| wavelengths | largest difference | at degrees | mean difference | own estimate |");
    println!("| --- | ---: | ---: | ---: | ---: |");
    line("0.45, 0.55, 0.65", &spectrum(&[0.45, 0.55, 0.65])?, &truth)?;
    for step in [16, 8, 4, 2] {
        let few: Spectrum = all.iter().step_by(step).cloned().collect();
        line(&few.len().to_string(), &few, &truth)?;
    }
    line(&MOST.to_string(), &all, &truth)
}

fn line(name: &str, spectrum: &Spectrum, truth: &SrgbPhase) -> Result<(), Box<dyn Error>> {
    let (largest, theta, mean) = difference(&srgb_phase(spectrum)?, truth);
    let estimate = colour_error(spectrum)?.map_or("-".to_owned(), |error| format!("{:.4}", error.largest));
    println!("| {name} | {largest:.4} | {theta:.1} | {mean:.5} | {estimate} |");
    Ok(())
}

/// Largest difference of a channel over the luminance, where, and its mean over the sphere.
fn difference(of: &SrgbPhase, truth: &SrgbPhase) -> (f64, f64, f64) {
    let (mut largest, mut mean, steps) = ((0.0, 0.0), 0.0, 18_000);
    for i in 0..=steps {
        let theta = 180.0 * f64::from(i) / f64::from(steps);
        let (a, b) = (at(of, theta), at(truth, theta));
        let luminance = 0.2126 * b[0] + 0.7152 * b[1] + 0.0722 * b[2];
        let change = (0..3).fold(0.0, |most: f64, c| most.max((a[c] - b[c]).abs())) / luminance;
        if change > largest.0 {
            largest = (change, theta);
        }
        mean += 0.5 * change * libm::sin(theta.to_radians()) * std::f64::consts::PI / f64::from(steps);
    }
    (largest.0, largest.1, mean)
}

fn at(colour: &SrgbPhase, theta: f64) -> [f64; 3] {
    let right = colour.theta_deg.partition_point(|t| *t < theta).clamp(1, colour.theta_deg.len() - 1);
    let t = (theta - colour.theta_deg[right - 1]) / (colour.theta_deg[right] - colour.theta_deg[right - 1]);
    let (a, b) = (colour.rgb[right - 1], colour.rgb[right]);
    std::array::from_fn(|c| a[c] + t * (b[c] - a[c]))
}

fn spectrum(wavelengths_um: &[f64]) -> Result<Spectrum, Box<dyn Error>> {
    let config: OpticsConfig = serde_json::from_value(json!({
        "number_density_per_cm3": 300.0,
        "wavelengths_um": wavelengths_um,
        "droplets": { "distribution": "modified-gamma", "gamma": 2.0, "effective_radius_um": 7.0 },
    }))?;
    Ok(compute(&config)?.into_iter().map(|one| (one.wavelength_um, one.phase)).collect())
}
