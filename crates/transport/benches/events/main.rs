//! Nanoseconds per scattering event on one core, by instruction set, phase function, τ and incidence; the bound that the
//! arithmetic sets, measured in the same run; and the plain tracer.

#![expect(clippy::print_stdout, reason = "a benchmark prints its figures")]

mod bound;

use std::error::Error;
use std::path::PathBuf;
use std::sync::{Arc, LazyLock};
use std::time::Instant;
use stratiform_optics::droplets::DropletDistribution;
use stratiform_optics::ensemble::{EnsembleSpec, QuadratureTolerance, ensemble};
use stratiform_optics::phase::{HenyeyGreenstein, PhaseFunction, PhaseTable};
use stratiform_optics::water::WaterTable;
use stratiform_quantities::{Asymmetry, Incidence, SingleScatteringAlbedo};
use stratiform_transport::{
    Control, Instructions, Kernel, Precision, Stop, TraceMedium, TraceRequest, Traced, TransportError,
    trace_half_space_with, trace_plain,
};

const TAU: [f64; 3] = [1.0, 5.0, 16.0];
const REPEATS: usize = 5;

/// ns that this process has had a processor (Linux), so that a busy machine does not count; elsewhere ns since the start.
fn processor_time() -> f64 {
    static START: LazyLock<Instant> = LazyLock::new(Instant::now);
    let of_task =
        |path: PathBuf| std::fs::read_to_string(path.join("schedstat")).ok()?.split(' ').next()?.parse().ok();
    let tasks = std::fs::read_dir("/proc/self/task").into_iter().flatten().flatten();
    let times: Vec<f64> = tasks.filter_map(|task| of_task(task.path())).collect();
    if times.is_empty() {
        START.elapsed().as_secs_f64() * 1e9
    } else {
        times.iter().fold(0.0, |sum, ns| sum + ns)
    }
}

/// Fastest of some runs, in ns per scattering.
fn fastest(
    repeats: usize,
    trace: impl Fn() -> Result<Traced, TransportError>,
) -> Result<f64, TransportError> {
    let mut best = f64::INFINITY;
    for _ in 0..repeats {
        let start = processor_time();
        let traced = trace()?;
        let events = traced.mean_scatterings(0).value * traced.photons() as f64;
        best = best.min((processor_time() - start) / events);
    }
    Ok(best)
}

fn request(tau: f64, incidence: Incidence, photons: u64) -> TraceRequest {
    TraceRequest { tau: vec![tau], incidence, stop: Stop::Photons(photons), max_order: 2, seed: 1, stream: 0 }
}

/// One kernel on one medium; without a bound there is no ratio to it.
fn rows(name: &str, medium: &TraceMedium, kernel: Kernel, bound: Option<f64>) -> Result<(), Box<dyn Error>> {
    for (light, incidence) in [("mu0 = 1", Incidence::beam(1.0)?), ("diffuse", Incidence::Diffuse)] {
        for tau in TAU {
            let request = request(tau, incidence, 1 << 18);
            let ns =
                fastest(REPEATS, || trace_half_space_with(kernel, medium, &request, Control::default()))?;
            let sets = format!("{:?}", kernel.instructions);
            let precision = format!("{:?}", kernel.precision.unwrap_or(Precision::Single));
            let ratio = bound.map(|bound| format!("{bound:>8.2}{:>7.2}", ns / bound)).unwrap_or_default();
            println!("{name:<10}{sets:<10}{precision:<8}{light:<9}{tau:>4}{ns:>8.2}{ratio}");
        }
    }
    Ok(())
}

/// The paper's cloud at 0.55 µm: γ = 2, r_e = 7 µm.
fn cloud() -> Result<PhaseTable, Box<dyn Error>> {
    let spec = EnsembleSpec {
        droplets: &DropletDistribution::ModifiedGamma { gamma: 2.0, effective_radius_um: 7.0 }.resolve()?,
        number_density_per_cm3: 300.0,
        wavelength_um: 0.55,
        refractive_index: WaterTable::HaleQuerry1973.at(0.55)?,
        theta_f_deg: 5.0,
        tolerance: QuadratureTolerance::default(),
    };
    Ok(ensemble(&spec)?.phase)
}

fn main() -> Result<(), Box<dyn Error>> {
    rayon::ThreadPoolBuilder::new().num_threads(1).build_global()?;
    let phases: [(&str, Arc<dyn PhaseFunction>); 2] =
        [("hg 0.85", Arc::new(HenyeyGreenstein::new(Asymmetry::new(0.85)?))), ("cloud", Arc::new(cloud()?))];
    println!(
        "ns per scattering event, one core, conservative; then the bound (its parts by themselves), and the ratio to it"
    );
    for (name, phase) in phases {
        let medium = TraceMedium::full(phase, SingleScatteringAlbedo::CONSERVATIVE);
        println!("{name}: {:.1e} of the table's intervals split", medium.pieces().split_share());
        for instructions in [Instructions::Widest, Instructions::Avx2, Instructions::Portable] {
            let parts = bound::measure(instructions, medium.pieces());
            let bound = parts.iter().fold(0.0, |sum, part| sum + part);
            let listed: Vec<String> =
                bound::PARTS.iter().zip(parts).map(|(name, ns)| format!("{name} {ns:.2}")).collect();
            println!("{instructions:?} parts: {}; bound {bound:.2}", listed.join(", "));
            rows(name, &medium, Kernel { precision: Some(Precision::Single), instructions }, Some(bound))?;
        }
        let double = Kernel { precision: Some(Precision::Double), instructions: Instructions::Widest };
        rows(name, &medium, double, None)?;
        for tau in TAU {
            let request = request(tau, Incidence::beam(1.0)?, 8192);
            let ns = fastest(2, || trace_plain(&medium, &request, Control::default()))?;
            println!("{name:<10}{:<27}{tau:>4}{ns:>8.1}", "plain tracer, mu0 = 1");
        }
    }
    Ok(())
}
