//! Fluxes alone are those of the same photons counted scattering by scattering, number by number.

#![allow(clippy::unwrap_used, reason = "a test may stop where it fails")]

use std::sync::Arc;
use std::sync::atomic::AtomicBool;
use stratiform_optics::phase::HenyeyGreenstein;
use stratiform_quantities::{Asymmetry, Incidence, Order, SingleScatteringAlbedo};
use stratiform_transport::{
    Control, Extent, Fluxes, Quantity, Stop, TraceMedium, TraceRequest, Traced, TransportError, trace_fluxes,
    trace_half_space,
};

const MAX_ORDER: u32 = 2;

fn medium(omega: f64) -> TraceMedium {
    let phase = HenyeyGreenstein::new(Asymmetry::new(0.85).unwrap());
    TraceMedium::full(Arc::new(phase), SingleScatteringAlbedo::new(omega).unwrap())
}

fn request(tau: &[f64], incidence: Incidence, photons: u64) -> TraceRequest {
    let (tau, stop) = (tau.to_vec(), Stop::Photons(photons));
    TraceRequest { tau, incidence, stop, max_order: MAX_ORDER, seed: 3, stream: 7 }
}

/// Both ways of counting.
fn traced(omega: f64, request: &TraceRequest, extent: Extent) -> (Traced, Fluxes) {
    let medium = medium(omega);
    let traced = trace_half_space(&medium, request, Control::default()).unwrap();
    (traced, trace_fluxes(&medium, request, extent, Control::default()).unwrap())
}

#[test]
fn fluxes_are_those_of_the_same_photons() {
    let slabs: [&[f64]; 4] = [&[16.0, 0.0, 0.5, 5.0, 0.5], &[0.0], &[0.01, 0.02], &[1.0, 400.0]];
    let suns = [Incidence::Diffuse, Incidence::beam(1.0).unwrap(), Incidence::beam(0.0).unwrap()];
    for (tau, incidence) in slabs.into_iter().flat_map(|tau| suns.map(|sun| (tau, sun))) {
        for (omega, photons) in [(1.0, 20_000), (0.9, 20_000), (0.0, 5), (1.0, 300)] {
            let request = request(tau, incidence, photons);
            for extent in [Extent::ToTheEnd, Extent::ListedOrders] {
                let (traced, fluxes) = traced(omega, &request, extent);
                assert_eq!((fluxes.tau(), fluxes.photons()), (traced.tau(), traced.photons()));
                for (k, order) in
                    (0..tau.len()).flat_map(|k| fluxes.orders().into_iter().map(move |n| (k, n)))
                {
                    let case = format!("tau {}, {order}, {incidence:?}, omega {omega}, {extent:?}", tau[k]);
                    assert_eq!(fluxes.estimate(k, order), Some(traced.estimate(k, order)), "{case}");
                }
            }
        }
    }
}

#[test]
fn covariances_are_those_of_the_same_photons() {
    let request = request(&[0.5, 5.0], Incidence::Diffuse, 20_000);
    let (traced, fluxes) = traced(0.9, &request, Extent::ListedOrders);
    let quantities = [
        (0, Quantity::Transmittance(Order::Exactly(1))),
        (1, Quantity::Transmittance(Order::Exactly(2))),
        (1, Quantity::Reflectance(Order::Exactly(1))),
    ];
    assert_eq!(fluxes.covariance(&quantities), Some(traced.covariance(&quantities)));
}

#[test]
fn what_was_not_followed_is_not_known() {
    let request = request(&[5.0], Incidence::Diffuse, 1000);
    let (_, fluxes) = traced(1.0, &request, Extent::ListedOrders);
    assert_eq!(fluxes.orders(), [0, 1, 2].map(Order::Exactly));
    for order in [Order::Exactly(3), Order::Tail, Order::Total] {
        assert_eq!(fluxes.estimate(0, order), None);
        assert_eq!(fluxes.covariance(&[(0, Quantity::Transmittance(order))]), None);
    }
    let (_, all) = traced(1.0, &request, Extent::ToTheEnd);
    assert_eq!(all.orders(), Order::rows(MAX_ORDER).collect::<Vec<_>>());
    assert_eq!(all.estimate(0, Order::Exactly(3)), None);
}

#[test]
fn a_trace_that_is_stopped_says_so() {
    let request = request(&[50.0, 200.0], Incidence::beam(1.0).unwrap(), 100_000);
    let stop = AtomicBool::new(true);
    let control = Control { progress: None, cancel: Some(&stop) };
    for extent in [Extent::ToTheEnd, Extent::ListedOrders] {
        let stopped = trace_fluxes(&medium(1.0), &request, extent, control);
        assert_eq!(stopped, Err(TransportError::Cancelled));
    }
}
