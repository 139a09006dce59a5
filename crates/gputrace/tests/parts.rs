//! Parts of a trace on the device, and what it refuses.

#![allow(clippy::unwrap_used, reason = "a test may stop where it fails")]

#[path = "../../gpu/tests/device/mod.rs"]
mod device;
mod media;

use device::device;
use media::hg;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use stratiform_gputrace::{GpuJob, GpuTraceError, GpuTracer};
use stratiform_quantities::{Incidence, Order};
use stratiform_transport::{Control, Part, Share, Stop, TraceRequest, TransportError, trace_half_space};

fn request(stop: Stop) -> TraceRequest {
    TraceRequest {
        tau: vec![1.0, 8.0],
        incidence: Incidence::Diffuse,
        stop,
        max_order: 3,
        seed: 3,
        stream: 0,
    }
}

/// Any split of the photons, in any order, gives the bytes of the whole. Shares begin and end inside rounds.
#[test]
fn shares_merge_to_the_whole() {
    let Some(gpu) = device() else { return };
    let (tracer, medium) = (GpuTracer::new(&gpu).unwrap(), hg(0.5, 0.9));
    let request = request(Stop::Photons((1 << 20) + 60_001));
    let job = GpuJob::new(&tracer, &medium, &request).unwrap();
    let mut merged = job.part();
    for number in [3, 1, 2] {
        let mut part = job.part();
        job.trace(&mut part, Share::new(number, 3).unwrap(), Control::default(), |_| ()).unwrap();
        merged.merge(&part).unwrap();
    }
    let whole = tracer.trace(&medium, &request, Control::default()).unwrap();
    assert_eq!(merged.finish().unwrap(), whole);
    assert_eq!(whole.photons(), (1 << 20) + 60_001);
}

/// Rounds are those of the CPU, so the trace ends with the same photons.
#[test]
fn a_target_error_is_reached_with_the_photons_of_the_cpu() {
    let Some(gpu) = device() else { return };
    let (tracer, medium) = (GpuTracer::new(&gpu).unwrap(), hg(0.85, 1.0));
    let request = request(Stop::StdError { target: 1.2e-3, max_photons: 1 << 20 });
    let device = tracer.trace(&medium, &request, Control::default()).unwrap();
    let cpu = trace_half_space(&medium, &request, Control::default()).unwrap();
    assert_eq!(device.target_reached(), Some(true));
    // The length of a round follows from the errors before it: a flipped count may shift it a little.
    assert!(device.photons().abs_diff(cpu.photons()) <= cpu.photons() / 1000 && device.photons() > 1 << 16);
}

/// A few photons, slabs that all have passed at once, slabs in which photons stay long.
#[test]
fn extremes_are_those_of_the_cpu() {
    let Some(gpu) = device() else { return };
    let tracer = GpuTracer::new(&gpu).unwrap();
    let thin: Vec<f64> = (0..300).map(|k| f64::from(k) * 1e-3).collect();
    let cases = [
        (vec![0.0], 2, 0.0, 1.0),
        (vec![1.0], 7, 0.85, 0.0),
        (thin, 3000, 0.85, 1.0),
        (vec![300.0], 400, 0.0, 1.0),
    ];
    for (tau, photons, g, omega) in cases {
        for incidence in [Incidence::beam(0.0).unwrap(), Incidence::beam(1.0).unwrap()] {
            let (medium, stop) = (hg(g, omega), Stop::Photons(photons));
            let request =
                TraceRequest { tau: tau.clone(), incidence, stop, max_order: 2, seed: 1, stream: 0 };
            let device = tracer.trace(&medium, &request, Control::default()).unwrap();
            let cpu = trace_half_space(&medium, &request, Control::default()).unwrap();
            for tau in 0..tau.len() {
                let [device, cpu] = [&device, &cpu].map(|traced| traced.estimate(tau, Order::Total));
                let few = 4.0 / photons as f64;
                assert!(
                    (device.0.value - cpu.0.value).abs() <= few
                        && (device.1.value - cpu.1.value).abs() <= few
                );
            }
        }
    }
}

/// Cancelled, it keeps what is whole, and goes on from there.
#[test]
fn a_cancelled_trace_goes_on() {
    let Some(gpu) = device() else { return };
    let (tracer, medium) = (GpuTracer::new(&gpu).unwrap(), hg(0.5, 0.9));
    let request = request(Stop::Photons(600_000));
    let job = GpuJob::new(&tracer, &medium, &request).unwrap();
    let (cancel, farthest) = (AtomicBool::new(false), AtomicU64::new(0));
    let advanced = |done: u64, _: u64| {
        farthest.fetch_max(done, Ordering::Relaxed);
    };
    let mut part = job.part();
    let control = Control { progress: Some(&advanced), cancel: Some(&cancel) };
    let stopped = job.trace(&mut part, Share::WHOLE, control, |_| cancel.store(true, Ordering::Relaxed));
    assert_eq!(stopped, Err(GpuTraceError::Transport(TransportError::Cancelled)));
    assert!(part.photons() > 0 && part.photons() < 600_000);
    assert_eq!(farthest.load(Ordering::Relaxed), part.photons());
    job.trace(&mut part, Share::WHOLE, Control::default(), |_| ()).unwrap();
    assert_eq!(part.finish().unwrap(), tracer.trace(&medium, &request, Control::default()).unwrap());
}

#[test]
fn what_it_cannot_trace_is_refused() {
    let Some(gpu) = device() else { return };
    let (tracer, medium) = (GpuTracer::new(&gpu).unwrap(), hg(0.5, 0.9));
    let refusal = |request: &TraceRequest| GpuJob::new(&tracer, &medium, request).err().unwrap().to_string();
    let good = request(Stop::Photons(100));
    let deep = TraceRequest { tau: vec![1.0, 300.1], ..good.clone() };
    assert!(refusal(&deep).contains("300.1"), "{}", refusal(&deep));
    let none = TraceRequest { tau: Vec::new(), ..good.clone() };
    assert!(refusal(&none).contains("empty"));
    let nan = TraceRequest { tau: vec![f64::NAN], ..good.clone() };
    assert!(refusal(&nan).contains("NaN"));
    let job = GpuJob::new(&tracer, &medium, &good).unwrap();
    let other = GpuJob::new(&tracer, &medium, &TraceRequest { seed: 4, ..good }).unwrap();
    let mut foreign: Part = other.part();
    let error = job.trace(&mut foreign, Share::WHOLE, Control::default(), |_| ()).unwrap_err();
    assert!(matches!(error, GpuTraceError::Transport(TransportError::Foreign { what: "seed", .. })));
}

#[test]
fn a_lost_device_says_so() {
    let Some(gpu) = device() else { return };
    let tracer = GpuTracer::new(&gpu).unwrap();
    gpu.lose();
    let lost = tracer.trace(&hg(0.5, 0.9), &request(Stop::Photons(100)), Control::default());
    assert!(matches!(lost, Err(GpuTraceError::Gpu(_))), "{lost:?}");
}
