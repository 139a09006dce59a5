//! Nanoseconds per scattering event on one core: plain and half-space tracer, by phase function and τ.

#![expect(clippy::print_stdout, reason = "a benchmark prints its figures")]

use std::error::Error;
use std::sync::Arc;
use std::time::Instant;
use stratiform_optics::phase::{HenyeyGreenstein, Isotropic, PhaseFunction};
use stratiform_quantities::{Asymmetry, Incidence, SingleScatteringAlbedo};
use stratiform_transport::{
    Control, Stop, TraceMedium, TraceRequest, Traced, TransportError, trace_half_space, trace_plain,
};

type Trace = fn(&TraceMedium, &TraceRequest, Control<'_>) -> Result<Traced, TransportError>;

/// Long enough that a run takes about half a second.
const EVENTS: f64 = 2e7;
const REPEATS: usize = 3;

fn request(tau: f64, photons: u64) -> TraceRequest {
    let incidence = Incidence::Diffuse;
    TraceRequest { tau: vec![tau], incidence, stop: Stop::Photons(photons), max_order: 2, seed: 1, stream: 0 }
}

/// Fastest of some runs, in ns per scattering.
fn measure(trace: Trace, medium: &TraceMedium, tau: f64) -> Result<f64, TransportError> {
    let photons = (EVENTS / (2.0 * tau)) as u64;
    let mut best = f64::INFINITY;
    for _ in 0..REPEATS {
        let start = Instant::now();
        let traced = trace(medium, &request(tau, photons), Control::default())?;
        let events = traced.mean_scatterings(0).value * traced.photons() as f64;
        best = best.min(start.elapsed().as_secs_f64() * 1e9 / events);
    }
    Ok(best)
}

fn main() -> Result<(), Box<dyn Error>> {
    rayon::ThreadPoolBuilder::new().num_threads(1).build_global()?;
    let phases: [(&str, Arc<dyn PhaseFunction>); 2] = [
        ("isotropic", Arc::new(Isotropic)),
        ("hg 0.85", Arc::new(HenyeyGreenstein::new(Asymmetry::new(0.85)?))),
    ];
    println!("ns per scattering event, one core, diffuse light, conservative");
    println!("{:<12}{:>6}{:>12}{:>12}", "phase", "tau", "plain", "half-space");
    for (name, phase) in phases {
        let medium = TraceMedium::full(phase, SingleScatteringAlbedo::CONSERVATIVE);
        for tau in [1.0, 5.0, 16.0] {
            let plain = measure(trace_plain, &medium, tau)?;
            let fast = measure(trace_half_space, &medium, tau)?;
            println!("{name:<12}{tau:>6}{plain:>12.1}{fast:>12.1}");
        }
    }
    Ok(())
}
