//! Times the averages over the paper's cloud at the default error.
#![allow(clippy::print_stdout, clippy::unwrap_used, reason = "a benchmark prints figures")]
use std::time::Instant;
use stratiform_optics::droplets::DropletDistribution;
use stratiform_optics::ensemble::*;
use stratiform_optics::water::WaterTable;

fn main() {
    let droplets =
        DropletDistribution::ModifiedGamma { gamma: 2.0, effective_radius_um: 7.0 }.resolve().unwrap();
    let most: u64 = std::env::args().filter_map(|a| a.parse().ok()).next().unwrap_or(1 << 14);
    for wavelength_um in [0.65, 0.55, 0.45] {
        let spec = EnsembleSpec {
            droplets: &droplets,
            number_density_per_cm3: 300.0,
            wavelength_um,
            refractive_index: WaterTable::HaleQuerry1973.at(wavelength_um).unwrap(),
            theta_f_deg: 5.0,
            tolerance: QuadratureTolerance { asymmetry: 1e-9, most_radii: most, ..Default::default() },
        };
        let start = Instant::now();
        let e = refine(&spec, |r, p| {
            println!(
                "{:6} {:.3}s g {:.1e} pf {:.1e} mom {:.1e} p<60 {:.1e} p>60 {:.1e}  n={} pf={:.5} g={:.5}",
                r.radii,
                start.elapsed().as_secs_f64(),
                r.asymmetry,
                r.forward_fraction,
                r.moments,
                r.phase_below_60_deg,
                r.phase_beyond_60_deg,
                p.values().len(),
                p.forward_fraction(5.0).unwrap(),
                stratiform_optics::phase::PhaseFunction::asymmetry(p)
            )
        });
        println!("{:?}", e.map(|e| (e.asymmetry, e.extinction)).map_err(|e| e.to_string()));
    }
}
