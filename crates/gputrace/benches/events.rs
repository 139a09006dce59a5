//! Scattering events per second on the device.

#![allow(clippy::unwrap_used, clippy::print_stdout, reason = "a program that prints figures")]

use std::sync::Arc;
use std::time::Instant;
use stratiform_gpu::Gpu;
use stratiform_gputrace::GpuTracer;
use stratiform_optics::phase::HenyeyGreenstein;
use stratiform_quantities::{Asymmetry, Incidence, SingleScatteringAlbedo};
use stratiform_transport::{Control, Stop, TraceMedium, TraceRequest};

fn main() {
    let gpu = Gpu::new().unwrap();
    println!("{}", gpu.adapter());
    let tracer = GpuTracer::new(&gpu).unwrap();
    let phase = Arc::new(HenyeyGreenstein::new(Asymmetry::new(0.85).unwrap()));
    let medium = TraceMedium::full(phase, SingleScatteringAlbedo::CONSERVATIVE);
    for tau in [1.0, 5.0, 16.0, 50.0] {
        let photons = (1.5e7 / tau) as u64;
        let request = TraceRequest { tau: vec![tau], incidence: Incidence::beam(1.0).unwrap(), stop: Stop::Photons(photons), max_order: 20, seed: 1, stream: 0 };
        for _ in 0..3 {
            let start = Instant::now();
            let counts = tracer.trace(&medium, &request, Control::default()).unwrap();
            let time = start.elapsed().as_secs_f64();
            let events: u64 = counts.iter().map(|b| b.turned[0] + b.passed[0]).sum();
            println!("{tau} {photons} {events} {:.2} ns {time}", time * 1e9 / events as f64);
        }
    }
}
