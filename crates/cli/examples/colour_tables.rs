//! The stage `colour` by itself: writes `phase_colour.csv` into the accepted folder of each config named, and prints what one
//! extinction for all colours leaves out.
//!
//! Usage: `cargo run -p stratiform-cli --example colour_tables -- fit-configs/appendix-b.toml`
#![allow(clippy::print_stdout, reason = "an example talks")]

use std::error::Error;
use std::path::Path;
use std::time::Instant;
use stratiform_artifact::PhaseColour;
use stratiform_cli::config::Config;
use stratiform_cli::pipeline::{colour, optics};
use stratiform_optics::ensemble::Ensemble;

fn main() -> Result<(), Box<dyn Error>> {
    for path in std::env::args().skip(1) {
        one(Path::new(&path))?;
    }
    Ok(())
}

fn one(path: &Path) -> Result<(), Box<dyn Error>> {
    let config = Config::load(path)?;
    let start = Instant::now();
    let table = colour::table(&config)?;
    println!("{}: {:.1} s", path.display(), start.elapsed().as_secs_f64());
    let folder = path.parent().unwrap_or(Path::new("")).join(&config.codegen.accepted);
    table.write(&folder.join(colour::FILE))?;
    smallest(&table);
    spread(&config, &optics::ensembles(&colour::optics(&config.optics, &config.colour))?);
    Ok(())
}

/// How near the colours come to the edge of sRGB: the smallest channel over the mean of the three.
fn smallest(table: &PhaseColour) {
    for (k, name) in ["P", "P_S * P_S"].into_iter().enumerate() {
        let share = |i: &usize| {
            let rgb = table.rows[*i].channels()[k];
            3.0 * rgb[0].min(rgb[1]).min(rgb[2]) / (rgb[0] + rgb[1] + rgb[2])
        };
        let least = (0..table.rows.len()).min_by(|a, b| share(a).total_cmp(&share(b))).unwrap_or(0);
        println!(
            "{name}: smallest channel over mean {:.3} at {:.2} degrees",
            share(&least),
            table.rows[least].theta_deg
        );
    }
}

/// By wavelength, over the value at the transport's: κ, 1 - P_f (order 1 of thick layers), 1 - g (all orders).
fn spread(config: &Config, ensembles: &[Ensemble]) {
    let middle = ensembles.iter().find(|one| one.wavelength_um == config.transport.wavelength_um);
    let Some(middle) = middle else { return };
    println!("| um | kappa (Mie) | 1 - P_f | 1 - g |\n| --- | ---: | ---: | ---: |");
    for one in ensembles {
        let ratio = |of: fn(&Ensemble) -> f64| of(one) / of(middle) - 1.0;
        println!(
            "| {} | {:+.4} | {:+.4} | {:+.4} |",
            one.wavelength_um,
            ratio(|e| e.extinction.mie),
            ratio(|e| 1.0 - e.forward_fraction),
            ratio(|e| 1.0 - e.asymmetry)
        );
    }
}
