//! The device against the CPU on the same streams, per counter.

#![allow(clippy::unwrap_used, reason = "a test may stop where it fails")]

#[path = "../../gpu/tests/device/mod.rs"]
mod device;
mod twin;

use device::device;
use std::sync::Arc;
use stratiform_gputrace::{BatchCounts, GpuTracer};
use stratiform_optics::phase::HenyeyGreenstein;
use stratiform_quantities::{Asymmetry, Incidence, SingleScatteringAlbedo};
use stratiform_transport::{Control, Stop, TraceMedium, TraceRequest};

fn sums(batches: &[BatchCounts], column: impl Fn(&BatchCounts) -> &[u64]) -> Vec<u64> {
    let mut sum = column(&batches[0]).to_vec();
    batches[1..].iter().for_each(|b| sum.iter_mut().zip(column(b)).for_each(|(a, b)| *a += b));
    sum
}

#[test]
fn counts_are_those_of_the_cpu() {
    let Some(gpu) = device() else { return };
    for omega in [1.0, 0.9] {
        for incidence in [Incidence::beam(1.0).unwrap(), Incidence::beam(0.1).unwrap(), Incidence::Diffuse] {
            let phase = Arc::new(HenyeyGreenstein::new(Asymmetry::new(0.85).unwrap()));
            let medium = TraceMedium::full(phase, SingleScatteringAlbedo::new(omega).unwrap());
            let tau = vec![0.0, 0.3, 1.0, 5.0, 16.0, 50.0];
            let stop = Stop::Photons(300_000);
            let request = TraceRequest { tau, incidence, stop, max_order: 20, seed: 5, stream: 2 };
            let t = std::time::Instant::now();
            let cpu = twin::trace(&medium, &request, 300_000);
            let tc = t.elapsed();
            let t = std::time::Instant::now();
            let device = GpuTracer::new(&gpu).unwrap().trace(&medium, &request, Control::default()).unwrap();
            let tg = t.elapsed();
            let diff = |f: fn(&BatchCounts) -> &[u64]| -> u64 {
                cpu.iter().zip(&device).map(|(a, b)| f(a).iter().zip(f(b)).map(|(a, b)| a.abs_diff(*b)).sum::<u64>()).sum()
            };
            let d = [diff(|b| &b.reflected), diff(|b| &b.transmitted), diff(|b| &b.absorbed), diff(|b| &b.turned), diff(|b| &b.passed)];
            println!("{omega} {incidence}: {d:?}, {tc:?} {tg:?}");
        }
    }
}
