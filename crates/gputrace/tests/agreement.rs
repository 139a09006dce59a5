//! The device against the CPU on the same streams, per counter.

#![allow(clippy::unwrap_used, reason = "a test may stop where it fails")]

#[path = "../../gpu/tests/device/mod.rs"]
mod device;

use device::device;
use std::sync::Arc;
use stratiform_gputrace::{BatchCounts, trace_on_gpu};
use stratiform_optics::phase::HenyeyGreenstein;
use stratiform_quantities::{Asymmetry, Incidence, Order, SingleScatteringAlbedo};
use stratiform_transport::{Control, Quantity, Stop, TraceMedium, TraceRequest, trace_half_space};

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
            let cpu = trace_half_space(&medium, &request, Control::default()).unwrap();
            let tc = t.elapsed();
            let t = std::time::Instant::now();
            let device = trace_on_gpu(&gpu, &medium, &request, Control::default()).unwrap();
            let tg = t.elapsed();
            let (mut worst, mut sum) = (0, 0);
            let bins = 22;
            let mut reflected = sums(&device, |b| &b.reflected);
            for k in bins..reflected.len() {
                reflected[k] += reflected[k - bins];
            }
            let transmitted = sums(&device, |b| &b.transmitted);
            for slab in 0..6 {
                for bin in 0..bins {
                    let order = if bin < 21 { Order::Exactly(bin as u32) } else { Order::Tail };
                    for (q, d) in [
                        (Quantity::Reflectance(order), reflected[slab * bins + bin]),
                        (Quantity::Transmittance(order), transmitted[slab * bins + bin]),
                    ] {
                        let diff = cpu.hits(slab, q).abs_diff(d);
                        worst = worst.max(diff);
                        sum += diff;
                    }
                }
            }
            println!("{omega} {incidence}: worst {worst} sum {sum}, {tc:?} {tg:?}");
        }
    }
}
