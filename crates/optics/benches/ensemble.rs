//! Times the averages over the paper's cloud, prints error against radii and seconds, and times `scatrs` on one
//! wavelength and the same angles, with the error of both against this code's finest average.
//!
//! `cargo bench -p stratiform-optics --bench ensemble [-- RADII]`: RADII (default 65536) is the reference of the table.
#![expect(clippy::print_stdout, clippy::unwrap_used, reason = "a benchmark prints figures and may stop")]

use num_complex::Complex64;
use scatrs::ensemble::EnsembleOptions;
use std::time::Instant;
use stratiform_artifact::ReachedError;
use stratiform_optics::droplets::{DropletDistribution, SizeDistribution};
use stratiform_optics::ensemble::{EnsembleSpec, QuadratureTolerance, ensemble, refine};
use stratiform_optics::phase::{Norm, PhaseFunction, PhaseTable};
use stratiform_optics::water::WaterTable;

fn spec(droplets: &SizeDistribution, wavelength_um: f64, tolerance: QuadratureTolerance) -> EnsembleSpec<'_> {
    EnsembleSpec {
        droplets,
        number_density_per_cm3: 300.0,
        wavelength_um,
        refractive_index: WaterTable::HaleQuerry1973.at(wavelength_um).unwrap(),
        theta_f_deg: 5.0,
        tolerance,
    }
}

/// Largest relative difference of P on [from, to) degrees.
fn difference(a: &PhaseTable, b: &PhaseTable, from: f64, to: f64) -> f64 {
    let pairs = a.theta_deg().iter().zip(a.values().iter().zip(b.values()));
    let inside = pairs.filter(|(theta, _)| (from..to).contains(*theta));
    inside.map(|(_, (a, b))| (a / b - 1.0).abs()).fold(0.0, f64::max)
}

/// The default error at the three wavelengths of the paper.
fn default_error(droplets: &SizeDistribution) {
    let start = Instant::now();
    for wavelength_um in [0.65, 0.55, 0.45] {
        let one = ensemble(&spec(droplets, wavelength_um, QuadratureTolerance::default())).unwrap();
        println!(
            "{wavelength_um} um: {} radii, {} angles, reached g {:.1e}, P {:.1e} below 60 deg, {:.1e} beyond",
            one.reached.radii,
            one.phase.values().len(),
            one.reached.asymmetry,
            one.reached.phase_below_60_deg,
            one.reached.phase_beyond_60_deg
        );
    }
    println!("three wavelengths at the default error: {:.2} s", start.elapsed().as_secs_f64());
}

/// Estimated and true error of every refinement, the last one being the truth.
fn convergence(droplets: &SizeDistribution, wavelength_um: f64, most_radii: u64) -> PhaseTable {
    let unreachable = QuadratureTolerance { asymmetry: 1e-9, most_radii, ..QuadratureTolerance::default() };
    let start = Instant::now();
    let mut rows: Vec<(f64, ReachedError, PhaseTable)> = Vec::new();
    let record = |reached: &ReachedError, phase: &PhaseTable| {
        rows.push((start.elapsed().as_secs_f64(), *reached, phase.clone()));
    };
    assert!(refine(&spec(droplets, wavelength_um, unreachable), record).is_err(), "no error is that small");
    let (_, _, truth) = rows.last().unwrap().clone();
    println!(
        "radii,seconds,wavelength_um,estimate_moments,moments,estimate_p_f,p_f,estimate_p_below_60,p_below_60,estimate_p_beyond_60,p_beyond_60"
    );
    for (seconds, reached, phase) in &rows[..rows.len() - 1] {
        let moments =
            phase.moments(128).iter().zip(truth.moments(128)).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        let p_f = (phase.forward_fraction(5.0).unwrap() - truth.forward_fraction(5.0).unwrap()).abs();
        println!(
            "{},{seconds:.3},{wavelength_um},{:.1e},{moments:.1e},{:.1e},{p_f:.1e},{:.1e},{:.1e},{:.1e},{:.1e}",
            reached.radii,
            reached.moments,
            reached.forward_fraction,
            reached.phase_below_60_deg,
            difference(phase, &truth, 0.0, 60.0),
            reached.phase_beyond_60_deg,
            difference(phase, &truth, 60.0, 181.0)
        );
    }
    truth
}

/// P at the nodes by `scatrs`, relative tolerance `rtol`.
fn scatrs_phase(wavelength_um: f64, truth: &PhaseTable, rtol: f64) -> Vec<f64> {
    let law = scatrs::ensemble::SizeDistribution::Gamma { effective_radius: 7.0, effective_variance: 0.25 };
    let mu = truth.theta_rad().iter().map(|theta| libm::cos(*theta)).collect();
    let options = EnsembleOptions::new().with_rtol(rtol).with_mu(mu).with_max_panels(2048);
    let [n, k] = WaterTable::HaleQuerry1973.at(wavelength_um).unwrap();
    let result =
        scatrs::ensemble::compute(&law, &[wavelength_um], &[Complex64::new(n, k)], &options).unwrap();
    result[0].values.phase.clone().unwrap().f11
}

/// Seconds and true errors of both codes, coarse tolerances first.
fn side_by_side(truth: &PhaseTable, droplets: &SizeDistribution, wavelength_um: f64) {
    println!("code,seconds,wavelength_um,p_below_60,p_beyond_60");
    let start = Instant::now();
    let ours = ensemble(&spec(droplets, wavelength_um, QuadratureTolerance::default())).unwrap().phase;
    let seconds = start.elapsed().as_secs_f64();
    let row = |code: &str, seconds: f64, phase: &PhaseTable| {
        let [below, beyond] =
            [(0.0, 60.0), (60.0, 181.0)].map(|(from, to)| difference(phase, truth, from, to));
        println!("{code},{seconds:.2},{wavelength_um},{below:.1e},{beyond:.1e}");
    };
    row("stratiform (default)", seconds, &ours);
    for rtol in [1e-2, 1e-3, 1e-4] {
        let start = Instant::now();
        let p = scatrs_phase(wavelength_um, truth, rtol);
        let seconds = start.elapsed().as_secs_f64();
        let phase = PhaseTable::new(truth.theta_deg().to_vec(), p, Norm::Any).unwrap();
        row(&format!("scatrs (rtol {rtol})"), seconds, &phase);
    }
}

fn main() {
    let most = std::env::args().filter_map(|word| word.parse().ok()).next().unwrap_or(1 << 16);
    let cloud = DropletDistribution::ModifiedGamma { gamma: 2.0, effective_radius_um: 7.0 };
    let droplets = cloud.resolve().unwrap();
    default_error(&droplets);
    for wavelength_um in [0.65, 0.45] {
        convergence(&droplets, wavelength_um, most);
    }
    let truth = convergence(&droplets, 0.55, most);
    side_by_side(&truth, &droplets, 0.55);
}
