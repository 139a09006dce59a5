//! Shaders with a fault in them: each is seen.

#![allow(clippy::unwrap_used, reason = "a test may stop where it fails")]

#[path = "../../gpu/tests/device/mod.rs"]
mod device;
#[path = "../tests/media/mod.rs"]
mod media;

use crate::{GpuJob, GpuTraceError, GpuTracer, shader};
use device::device;
use stratiform_gpu::Gpu;
use stratiform_quantities::{Incidence, Order};
use stratiform_transport::{
    Control, Quantity, Share, Stop, Stretch, TraceMedium, TraceRequest, Traced, TransportError,
    trace_half_space,
};

fn medium() -> TraceMedium {
    media::hg(0.85, 0.99)
}

fn request() -> TraceRequest {
    let (tau, stop) = (vec![0.5, 4.0, 16.0], Stop::Photons(20_000));
    TraceRequest { tau, incidence: Incidence::Diffuse, stop, max_order: 6, seed: 9, stream: 1 }
}

/// The tracer with `(right, wrong)` exchanged in its text; each must occur.
fn changed(gpu: &Gpu, changes: &[(&str, &str)]) -> GpuTracer {
    let text = changes.iter().fold(shader::text(), |text, (right, wrong)| {
        assert!(text.contains(right), "`{right}` is not in the shader");
        text.replacen(right, wrong, 1)
    });
    GpuTracer::of_text(gpu, &text).unwrap()
}

fn trace(tracer: &GpuTracer) -> Result<Traced, GpuTraceError> {
    tracer.trace(&medium(), &request(), Control::default())
}

fn on_the_cpu() -> Traced {
    trace_half_space(&medium(), &request(), Control::default()).unwrap()
}

/// Largest difference of any total.
fn worst(a: &Traced, b: &Traced) -> u64 {
    let reflected = Quantity::Reflectance(Order::Total);
    (0..3).map(|tau| a.hits(tau, reflected).abs_diff(b.hits(tau, reflected))).max().unwrap()
}

#[test]
fn a_wrong_constant_is_seen() {
    let Some(gpu) = device() else { return };
    let cpu = on_the_cpu();
    assert!(worst(&cpu, &trace(&changed(&gpu, &[])).unwrap()) <= 4);
    for (right, wrong) in
        [("0.6931472", "0.7001472"), ("3.141582", "3.1515925"), ("- 0.5000032", "- 0.5499998")]
    {
        let device = trace(&changed(&gpu, &[(right, wrong)])).unwrap();
        assert!(worst(&cpu, &device) > 4, "{wrong}");
    }
}

#[test]
fn lost_photons_are_seen() {
    let Some(gpu) = device() else { return };
    let unbooked = changed(&gpu, &[("books += select(vec4<u32>(0u), vec4<u32>(1u), end);", "")]);
    assert!(matches!(trace(&unbooked), Err(GpuTraceError::Books(_))));
    let uncounted = changed(&gpu, &[("atomicAdd(&counts[", "atomicMax(&counts[")]);
    assert!(matches!(trace(&uncounted), Err(GpuTraceError::Transport(TransportError::Books { .. }))));
    let stalled = changed(&gpu, &[("number >= settings.count", "number >= 0u")]);
    assert!(matches!(trace(&stalled), Err(GpuTraceError::Stalled(_))));
}

/// Mesa's software driver ends all loops of an invocation after 65535 turns: photons then wait for the next dispatch.
#[test]
fn a_driver_that_stops_loops_changes_nothing() {
    let Some(gpu) = device() else { return };
    let endless = changed(
        &gpu,
        &[("look < settings.looks", "look < 100000u"), ("flight < settings.flights", "flight < 3u")],
    );
    let tau = vec![60.0];
    let request = TraceRequest { tau, stop: Stop::Photons(600), ..request() };
    let medium = media::hg(0.0, 1.0);
    let device = endless.trace(&medium, &request, Control::default()).unwrap();
    let plain = GpuTracer::new(&gpu).unwrap().trace(&medium, &request, Control::default()).unwrap();
    assert_eq!(device, plain);
}

/// Scatterings counted 2²⁴ times each overflow 32 bits, and not 64.
#[test]
fn sums_of_scatterings_carry() {
    let Some(gpu) = device() else { return };
    let job = |tracer: &GpuTracer| {
        let request = TraceRequest { tau: vec![2.0], ..request() };
        let medium = medium();
        let job = GpuJob::new(tracer, &medium, &request).unwrap();
        let mut part = job.part();
        let stretch = part.next_stretch(Share::WHOLE, 1 << 20).unwrap().unwrap();
        assert_eq!(stretch.photons(), 0..20_000);
        let mut flock = crate::flock::Flock::new(&tracer.gpu, &tracer.kernel, &medium, &request).unwrap();
        flock.trace(&stretch, &part.empty_tally(), Control::default(), |_| ()).unwrap()
    };
    let many = job(&changed(
        &gpu,
        &[("select(0u, 1u, passes), photon.order)", "select(0u, 1u, passes), photon.order << 24u)")],
    ));
    let once = job(&changed(&gpu, &[]));
    for batch in 0..Stretch::BATCHES {
        assert_eq!(many[batch].passed[0], once[batch].passed[0] << 24);
        assert_eq!(many[batch].turned[0], once[batch].turned[0] << 24);
    }
    assert!(many.iter().any(|batch| batch.passed[0] > u64::from(u32::MAX)));
}
