//! Nanoseconds per scattering event on one core: plain and half-space tracer, by phase function and τ.

#![expect(clippy::print_stdout, reason = "a benchmark prints its figures")]

use std::error::Error;
use std::sync::Arc;
use std::time::Instant;
use stratiform_optics::droplets::DropletDistribution;
use stratiform_optics::ensemble::{EnsembleSpec, QuadratureTolerance, ensemble};
use stratiform_optics::phase::{HenyeyGreenstein, Isotropic, Modified, PhaseFunction, PhaseTable};
use stratiform_optics::water::WaterTable;
use stratiform_quantities::{Asymmetry, Incidence, SingleScatteringAlbedo};
use stratiform_transport::{
    Control, Stop, TraceMedium, TraceRequest, Traced, TransportError, trace_half_space, trace_plain,
};

type Trace = fn(&TraceMedium, &TraceRequest, Control<'_>) -> Result<Traced, TransportError>;

/// Scatterings of one run of the plain and of the half-space tracer.
const EVENTS: [f64; 2] = [5e5, 2e7];
const REPEATS: usize = 5;

fn request(tau: f64, photons: u64) -> TraceRequest {
    let incidence = Incidence::Diffuse;
    TraceRequest { tau: vec![tau], incidence, stop: Stop::Photons(photons), max_order: 2, seed: 1, stream: 0 }
}

/// Fastest of some runs, in ns per scattering.
fn measure(trace: Trace, events: f64, medium: &TraceMedium, tau: f64) -> Result<f64, TransportError> {
    let photons = (events / (2.0 * tau)) as u64;
    let mut best = f64::INFINITY;
    for _ in 0..REPEATS {
        let start = Instant::now();
        let traced = trace(medium, &request(tau, photons), Control::default())?;
        let events = traced.mean_scatterings(0).value * traced.photons() as f64;
        best = best.min(start.elapsed().as_secs_f64() * 1e9 / events);
    }
    Ok(best)
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
    let cloud: Arc<dyn PhaseFunction> = Arc::new(cloud()?);
    let phases: [(&str, Arc<dyn PhaseFunction>); 4] = [
        ("isotropic", Arc::new(Isotropic)),
        ("hg 0.85", Arc::new(HenyeyGreenstein::new(Asymmetry::new(0.85)?))),
        ("cloud", cloud.clone()),
        ("cloud > 5°", Arc::new(Modified::new(cloud, 5.0)?)),
    ];
    println!("ns per scattering event, one core, diffuse light, conservative");
    println!("{:<12}{:>6}{:>12}{:>12}{:>18}", "phase", "tau", "plain", "half-space", "exact inversions");
    for (name, phase) in phases {
        let medium = TraceMedium::full(phase, SingleScatteringAlbedo::CONSERVATIVE);
        let exact = medium.table().exact_share();
        for tau in [1.0, 5.0, 16.0] {
            let plain = measure(trace_plain, EVENTS[0], &medium, tau)?;
            let fast = measure(trace_half_space, EVENTS[1], &medium, tau)?;
            println!("{name:<12}{tau:>6}{plain:>12.1}{fast:>12.1}{exact:>18.1e}");
        }
    }
    Ok(())
}
