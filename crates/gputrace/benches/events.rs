//! Scattering events per second on the device.

#![allow(clippy::unwrap_used, clippy::print_stdout, reason = "a program that prints figures")]

use std::sync::Arc;
use std::time::Instant;
use stratiform_gpu::Gpu;
use stratiform_gputrace::GpuTracer;
use stratiform_optics::phase::HenyeyGreenstein;
use stratiform_quantities::{Asymmetry, Incidence, SingleScatteringAlbedo};
use stratiform_transport::{Control, Stop, TraceMedium, TraceRequest};

/// Processor time of this program so far, s.
fn processor() -> f64 {
    let stat = std::fs::read_to_string("/proc/self/stat").unwrap();
    let fields: Vec<&str> = stat.rsplit(')').next().unwrap().split_whitespace().collect();
    (fields[11].parse::<f64>().unwrap() + fields[12].parse::<f64>().unwrap()) / 100.0
}

fn main() {
    let gpu = Gpu::new().unwrap();
    println!("{}", gpu.adapter());
    let tracer = GpuTracer::new(&gpu).unwrap();
    let phase = Arc::new(HenyeyGreenstein::new(Asymmetry::new(0.85).unwrap()));
    let medium = TraceMedium::full(phase, SingleScatteringAlbedo::CONSERVATIVE);
    for tau in [1.0, 5.0, 16.0, 50.0] {
        let photons = (6e6 / tau) as u64;
        let request = TraceRequest { tau: vec![tau], incidence: Incidence::beam(1.0).unwrap(), stop: Stop::Photons(photons), max_order: 20, seed: 1, stream: 0 };
        for _ in 0..2 {
            let (start, cpu) = (Instant::now(), processor());
            let counts = tracer.trace(&medium, &request, Control::default()).unwrap();
            let time = start.elapsed().as_secs_f64();
            let events = (counts.mean_scatterings(0).value * counts.photons() as f64) as u64;
            println!("{tau} {photons} {events} {:.2} ns {:.2} ns cpu", time * 1e9 / events as f64, (processor() - cpu) * 1e9 / events as f64);
        }
    }
}
