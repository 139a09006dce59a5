//! Reproducibility, stopping, and refusals.

mod common;

use common::{beam, full, half_space, hg, modified, request};
use rayon::ThreadPoolBuilder;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use stratiform_optics::phase::Isotropic;
use stratiform_quantities::{Incidence, Order, SingleScatteringAlbedo};
use stratiform_transport::{
    Control, Quantity, Stop, TraceMedium, TraceRequest, TransportError, trace_half_space, trace_plain,
};

fn medium() -> TraceMedium {
    full(hg(0.85), 0.99)
}

#[test]
fn any_number_of_threads_gives_the_same() {
    for trace in [trace_half_space, trace_plain] {
        let results = [1, 2, 3].map(|threads| {
            let pool = ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            let request = request(&[5.0, 1.0, 16.0], Incidence::Diffuse, 20_001);
            pool.install(|| trace(&medium(), &request, Control::default()).unwrap())
        });
        assert_eq!(results[0], results[1]);
        assert_eq!(results[0], results[2]);
    }
}

#[test]
fn seeds_and_streams_differ() {
    let hits = |seed, stream| {
        let request = TraceRequest { seed, stream, ..request(&[5.0], beam(0.5), 10_000) };
        let traced = half_space(&medium(), &request);
        traced.hits(0, Quantity::Reflectance(Order::Total))
    };
    assert_ne!(hits(1, 0), hits(2, 0));
    assert_ne!(hits(1, 0), hits(1, 1));
}

/// A thickness has the same photons whatever others stand beside it, and in whatever order.
#[test]
fn thicknesses_do_not_disturb_each_other() {
    let trace = |tau: &[f64]| half_space(&medium(), &request(tau, beam(0.7), 10_000));
    let (one, many) = (trace(&[5.0]), trace(&[16.0, 5.0, 0.0, 5.0, 1.0]));
    for order in one.orders() {
        for quantity in [Quantity::Reflectance(order), Quantity::Transmittance(order)] {
            assert_eq!(one.hits(0, quantity), many.hits(1, quantity));
            assert_eq!(one.hits(0, quantity), many.hits(3, quantity));
        }
    }
    assert_eq!(one.mean_scatterings(0), many.mean_scatterings(3));
    assert_eq!(one.absorptance(0), many.absorptance(1));
}

#[test]
fn the_tail_is_what_the_listed_orders_leave() {
    let trace = |max_order| {
        let request = TraceRequest { max_order, ..request(&[3.0], beam(1.0), 10_000) };
        half_space(&medium(), &request)
    };
    let (few, many) = (trace(1), trace(40));
    let hits = |order| few.hits(0, Quantity::Reflectance(order));
    let listed = |order| many.hits(0, Quantity::Reflectance(order));
    assert_eq!(hits(Order::Exactly(1)), listed(Order::Exactly(1)));
    let tail: u64 = (2..=40).map(|n| listed(Order::Exactly(n))).sum();
    assert_eq!(hits(Order::Tail), tail + listed(Order::Tail));
    assert_eq!(hits(Order::Total), listed(Order::Total));
    assert_eq!(hits(Order::Exactly(2)), 0);
}

#[test]
fn a_target_error_stops_the_trace() {
    let stop = |target, max_photons| {
        let stop = Stop::StdError { target, max_photons };
        let request = TraceRequest { stop, ..request(&[1.0, 5.0], beam(0.5), 2) };
        half_space(&medium(), &request)
    };
    let reached = stop(1e-3, 100_000_000);
    assert_eq!(reached.target_reached(), Some(true));
    assert!(reached.worst_error() <= 1e-3 && reached.photons() < 400_000, "{}", reached.photons());
    let missed = stop(1e-4, 50_000);
    assert_eq!(missed.target_reached(), Some(false));
    assert_eq!(missed.photons(), 50_000);
}

#[test]
fn progress_ends_at_the_total() {
    let furthest = AtomicU64::new(0);
    let progress = |done: u64, total: u64| {
        assert_eq!(total, 30_000);
        furthest.fetch_max(done, Ordering::Relaxed);
    };
    let control = Control { progress: Some(&progress), cancel: None };
    trace_half_space(&medium(), &request(&[1.0], beam(1.0), 30_000), control).unwrap();
    assert_eq!(furthest.into_inner(), 30_000);
}

#[test]
fn cancellation_gives_no_result() {
    let cancel = AtomicBool::new(false);
    let stop_half_way = |done: u64, total: u64| cancel.store(2 * done > total, Ordering::Relaxed);
    for trace in [trace_half_space, trace_plain] {
        cancel.store(false, Ordering::Relaxed);
        let control = Control { progress: Some(&stop_half_way), cancel: Some(&cancel) };
        let result = trace(&medium(), &request(&[1.0], beam(1.0), 100_000), control);
        assert_eq!(result, Err(TransportError::Cancelled));
    }
}

#[test]
fn bad_input_is_refused_by_name_value_and_range() {
    let good = request(&[1.0], beam(1.0), 1000);
    let target = |target| Stop::StdError { target, max_photons: 1000 };
    let cases = [
        (TraceRequest { tau: vec![], ..good.clone() }, "tau: the list of optical thicknesses is empty"),
        (TraceRequest { tau: vec![1.0, f64::NAN], ..good.clone() }, "tau = NaN is outside [0, 1000000]"),
        (TraceRequest { tau: vec![-1.0], ..good.clone() }, "tau = -1 is outside [0, 1000000]"),
        (
            TraceRequest { stop: Stop::Photons(0), ..good.clone() },
            "photons = 0 is outside [2, 281474976710656]",
        ),
        (
            TraceRequest { stop: target(0.0), ..good.clone() },
            "target standard error = 0 is outside (0, infinity)",
        ),
        (
            TraceRequest { max_order: u32::MAX, ..good.clone() },
            "1 thicknesses with 4294967297 orders each make more than 65536 rows",
        ),
    ];
    for (request, message) in cases {
        for trace in [trace_half_space, trace_plain] {
            let error = trace(&medium(), &request, Control::default()).unwrap_err();
            assert_eq!(error.to_string(), message);
        }
    }
    for share in [1.0, -0.1, f64::NAN] {
        let omega = SingleScatteringAlbedo::CONSERVATIVE;
        assert!(TraceMedium::modified(Arc::new(Isotropic), omega, share).is_err());
    }
}

#[test]
fn the_modified_medium_scales_extinction_and_albedo() {
    let medium = modified(hg(0.7), 0.8, 0.25);
    assert!((medium.extinction() - 0.8).abs() < 1e-15);
    assert!((medium.albedo() - 0.75).abs() < 1e-15);
    assert_eq!(modified(hg(0.7), 1.0, 0.25).albedo(), 1.0);
}
