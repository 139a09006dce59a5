//! The device against the CPU on the same streams, counter by counter.
//!
//! Both compute in single precision by the same formulas, but a driver may fuse or reorder sums and products. A photon then
//! may decide otherwise at a boundary: one in some thousands, seen with f64 against f32 as the worst case. Mesa's software driver does
//! as the CPU does, and every counter is equal. On any driver each may differ by [`FEW`], a hundredth of what chance would allow.

#![allow(clippy::unwrap_used, reason = "a test may stop where it fails")]

#[path = "../../gpu/tests/device/mod.rs"]
mod device;
mod media;

use device::device;
use media::{cloud, cut_cloud, hg};
use stratiform_gputrace::GpuTracer;
use stratiform_quantities::{Incidence, Order};
use stratiform_transport::{Control, Quantity, Stop, TraceMedium, TraceRequest, Traced, trace_half_space};

const PHOTONS: u64 = 20_000;
const TAU: [f64; 6] = [16.0, 0.0, 0.3, 50.0, 1.0, 5.0];
/// Photons by which a counter may differ.
const FEW: u64 = 4;

fn request(incidence: Incidence) -> TraceRequest {
    TraceRequest {
        tau: TAU.to_vec(),
        incidence,
        stop: Stop::Photons(PHOTONS),
        max_order: 12,
        seed: 5,
        stream: 2,
    }
}

fn incidences() -> [Incidence; 3] {
    [Incidence::beam(1.0).unwrap(), Incidence::beam(0.1).unwrap(), Incidence::Diffuse]
}

/// Largest difference of any counter.
fn worst(a: &Traced, b: &Traced) -> u64 {
    let mut worst = 0;
    for tau in 0..TAU.len() {
        worst = worst.max(a.absorbed_hits(tau).abs_diff(b.absorbed_hits(tau)));
        for order in Order::rows(a.max_order()) {
            for quantity in [Quantity::Reflectance(order), Quantity::Transmittance(order)] {
                worst = worst.max(a.hits(tau, quantity).abs_diff(b.hits(tau, quantity)));
            }
        }
    }
    worst
}

#[test]
fn counts_are_those_of_the_cpu() {
    let Some(gpu) = device() else { return };
    let tracer = GpuTracer::new(&gpu).unwrap();
    let media = [hg(0.85, 1.0), hg(0.85, 0.9), hg(0.0, 1.0), cloud(1.0), cloud(0.9), cut_cloud(0.9)];
    for (index, medium) in media.iter().enumerate() {
        for incidence in incidences() {
            let request = request(incidence);
            let cpu = trace_half_space(medium, &request, Control::default()).unwrap();
            let device = tracer.trace(medium, &request, Control::default()).unwrap();
            let worst = worst(&cpu, &device);
            assert!(worst <= FEW, "medium {index}, {incidence}: a counter differs by {worst}");
            if gpu.adapter().starts_with("llvmpipe") {
                assert_eq!(cpu, device, "medium {index}, {incidence}: down to every batch");
            }
        }
    }
}

/// The comparator sees an asymmetry that is 1/1000 wrong, an albedo that is 1/1000 wrong, and other streams.
#[test]
fn planted_errors_are_rejected() {
    let Some(gpu) = device() else { return };
    let tracer = GpuTracer::new(&gpu).unwrap();
    let request = request(Incidence::Diffuse);
    let cpu = |medium: &TraceMedium, request: &TraceRequest| {
        trace_half_space(medium, request, Control::default()).unwrap()
    };
    let device = tracer.trace(&hg(0.85, 0.999), &request, Control::default()).unwrap();
    assert!(worst(&cpu(&hg(0.85, 0.999), &request), &device) <= FEW);
    assert!(worst(&cpu(&hg(0.850_85, 0.999), &request), &device) > FEW);
    assert!(worst(&cpu(&hg(0.85, 0.998), &request), &device) > FEW);
    let other = TraceRequest { stream: 3, ..request };
    assert!(worst(&cpu(&hg(0.85, 0.999), &other), &device) > FEW);
}
