//! Writes every peer's file for the paper's cloud, the tables they come from, and what each program should reconstruct:
//! the input of `scripts/peers-check.py`.
//!
//! Usage: `cargo run -p stratiform-tables --example peer_files -- FOLDER`
#![allow(clippy::print_stdout, reason = "an example talks")]

use serde_json::json;
use std::error::Error;
use std::path::{Path, PathBuf};
use stratiform_artifact::{create_folder, write_atomic, write_csv, write_json};
use stratiform_optics::ensemble::Ensemble;
use stratiform_optics::phase::PhaseTable;
use stratiform_optics::{OpticsConfig, compute};
use stratiform_tables::peer::{PeerFile, disort, eradiate, mcx, mitsuba};

fn main() -> Result<(), Box<dyn Error>> {
    let folder = PathBuf::from(std::env::args().nth(1).ok_or("give a folder")?);
    create_folder(&folder)?;
    let cloud = cloud()?;
    let mut cards = serde_json::Map::new();
    let mut keep = |name: &str, file: PeerFile<Vec<u8>>| -> Result<(), Box<dyn Error>> {
        write_atomic(&folder.join(name), &file.content)?;
        cards.insert(name.to_owned(), json!(file.cards));
        Ok(())
    };
    let full = &cloud[1].phase;
    let modified = full.modified(5.0)?;
    for (name, table) in [("full", full), ("modified", &modified)] {
        for count in [1025, 65537] {
            keep(&format!("tabphase-{count}-{name}.xml"), bytes(mitsuba::tabphase(table, count)?))?;
        }
        keep(&format!("irregular-{name}.xml"), bytes(mitsuba::tabphase_irregular(table)))?;
        for count in [254, 1022] {
            keep(&format!("mcx-{count}-{name}.json"), bytes(mcx::inverse_cdf(table, count)?))?;
        }
        keep(&format!("pmom-1024-{name}.txt"), bytes(disort::pmom(table, 1024)?))?;
        write_source(&folder.join(format!("source-{name}.csv")), table)?;
    }
    keep("particles.nc", eradiate::particle_properties(&spectrum(&cloud), 1024)?)?;
    for one in &cloud {
        write_source(
            &folder.join(format!("source-{}nm.csv", (1000.0 * one.wavelength_um).round())),
            &one.phase,
        )?;
    }
    write_json(&folder.join("cards.json"), &cards)?;
    println!("{}", serde_json::to_string_pretty(&cards)?);
    Ok(())
}

fn bytes(file: PeerFile<String>) -> PeerFile<Vec<u8>> {
    PeerFile { content: file.content.into_bytes(), values: file.values, cards: file.cards }
}

fn write_source(path: &Path, table: &PhaseTable) -> Result<(), Box<dyn Error>> {
    Ok(write_csv(path, &table.rows())?)
}

fn spectrum(cloud: &[Ensemble]) -> Vec<eradiate::Wavelength<'_>> {
    cloud.iter().map(wavelength).collect()
}

fn wavelength(one: &Ensemble) -> eradiate::Wavelength<'_> {
    eradiate::Wavelength {
        wavelength_um: one.wavelength_um,
        extinction_per_m: one.extinction.mie,
        single_scattering_albedo: one.single_scattering_albedo,
        phase: &one.phase,
    }
}

fn cloud() -> Result<Vec<Ensemble>, Box<dyn Error>> {
    let config: OpticsConfig = serde_json::from_value(json!({
        "number_density_per_cm3": 300.0,
        "wavelengths_um": [0.45, 0.55, 0.65],
        "droplets": { "distribution": "modified-gamma", "gamma": 2.0, "effective_radius_um": 7.0 },
    }))?;
    Ok(compute(&config)?)
}
