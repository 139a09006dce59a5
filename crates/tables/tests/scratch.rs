#![allow(clippy::unwrap_used, reason = "a test may stop where it fails")]
use stratiform_optics::{OpticsConfig, compute, phase::*};
use stratiform_tables::{nearest::nearest, diagnosis::landmarks::Landmarks};
#[test]
fn print() {
    let t: OpticsConfig = serde_json::from_str(r#"{"number_density_per_cm3":300.0,"wavelengths_um":[0.55],"droplets":{"distribution":"modified-gamma","gamma":2.0,"effective_radius_um":7.0}}"#).unwrap();
    let s = std::time::Instant::now();
    let e = &compute(&t).unwrap()[0];
    println!("mie {:?}", s.elapsed());
    println!("{} {:?}", e.phase.values().len(), Landmarks::of(&e.phase));
    let s = std::time::Instant::now();
    let n = nearest(&e.phase, 5.0, Some(14.0)).unwrap();
    println!("{:?}\n{}", s.elapsed(), n.to_csv().unwrap());
}
