//! Counts the light of one slab on demand, for `scripts/compare-tracers` to time.
//!
//! Arguments: `half-space` or `plain`, τ, Henyey–Greenstein g, μ0, threads; no absorption. Each line of input, `PHOTONS SEED`,
//! is answered by `photons,reflected,transmitted,scatterings,seconds`. With `solve` instead of a tracer, it prints the
//! deterministic solver's `reflectance,transmittance,error` once.

#![expect(clippy::print_stdout, reason = "a program that prints")]

use std::error::Error;
use std::sync::Arc;
use std::time::Instant;
use stratiform_optics::phase::{HenyeyGreenstein, PhaseFunction};
use stratiform_quantities::{Asymmetry, Incidence, Order, SingleScatteringAlbedo};
use stratiform_transport::solve::{SolveMedium, Solver};
use stratiform_transport::{
    Control, Quantity, Stop, TraceMedium, TraceRequest, Traced, TransportError, trace_half_space, trace_plain,
};

type Trace = fn(&TraceMedium, &TraceRequest, Control<'_>) -> Result<Traced, TransportError>;

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [code, tau, g, mu0, threads] = arguments.as_slice() else {
        return Err("usage: count_slab half-space|plain|solve TAU G MU0 THREADS".into());
    };
    rayon::ThreadPoolBuilder::new().num_threads(threads.parse()?).build_global()?;
    let (tau, incidence) = (tau.parse()?, Incidence::beam(mu0.parse()?)?);
    let phase: Arc<dyn PhaseFunction> = Arc::new(HenyeyGreenstein::new(Asymmetry::new(g.parse()?)?));
    match code.as_str() {
        "half-space" => answer(trace_half_space, phase, tau, incidence),
        "plain" => answer(trace_plain, phase, tau, incidence),
        "solve" => solve(phase, tau, incidence),
        other => Err(format!("no tracer is called {other}").into()),
    }
}

fn answer(
    trace: Trace,
    phase: Arc<dyn PhaseFunction>,
    tau: f64,
    incidence: Incidence,
) -> Result<(), Box<dyn Error>> {
    let medium = TraceMedium::full(phase, SingleScatteringAlbedo::CONSERVATIVE);
    for line in std::io::stdin().lines() {
        let line = line?;
        let (photons, seed) = line.split_once(' ').ok_or("a line is PHOTONS SEED")?;
        let stop = Stop::Photons(photons.parse()?);
        let request =
            TraceRequest { tau: vec![tau], incidence, stop, max_order: 0, seed: seed.parse()?, stream: 0 };
        let start = Instant::now();
        let traced = trace(&medium, &request, Control::default())?;
        let seconds = start.elapsed().as_secs_f64();
        let photons = traced.photons();
        let [reflected, transmitted] = [Quantity::Reflectance, Quantity::Transmittance]
            .map(|quantity| traced.hits(0, quantity(Order::Total)));
        let scatterings = (traced.mean_scatterings(0).value * photons as f64).round();
        println!("{photons},{reflected},{transmitted},{scatterings},{seconds:e}");
    }
    Ok(())
}

fn solve(phase: Arc<dyn PhaseFunction>, tau: f64, incidence: Incidence) -> Result<(), Box<dyn Error>> {
    let medium = SolveMedium::full(phase, SingleScatteringAlbedo::CONSERVATIVE);
    let solved = Solver::new(medium, 1e-8)?.totals(&[tau], &[incidence])?;
    let (r, t) = solved.total(0, 0);
    println!("{:e},{:e},{:e}", r.value, t.value, solved.worst_error());
    Ok(())
}
