//! Parts of a trace: any split gives the bytes of the whole, and what does not belong together is refused.

#![allow(clippy::unwrap_used, reason = "a test may stop where it fails")]

mod common;

use common::{beam, cloud, full, half_space, hg, modified_cloud, request};
use rayon::ThreadPoolBuilder;
use std::sync::atomic::{AtomicBool, Ordering};
use stratiform_quantities::Incidence;
use stratiform_transport::{
    Control, Identity, Part, Share, Stop, TraceJob, TraceMedium, TraceRequest, Traced, Tracer,
    TransportError, trace_half_space, trace_plain,
};

fn medium() -> TraceMedium {
    full(hg(0.85), 0.99)
}

fn share(number: u64, of: u64) -> Share {
    Share::new(number, of).unwrap()
}

/// There and back again: what a file or a network does to a part.
fn sent(part: &Part) -> Part {
    postcard::from_bytes(&postcard::to_allocvec(part).unwrap()).unwrap()
}

fn traced_share(job: &TraceJob<'_>, share: Share) -> Part {
    let mut part = job.part();
    job.trace(&mut part, share, Control::default(), |_| ()).unwrap();
    sent(&part)
}

fn whole(tracer: Tracer, medium: &TraceMedium, request: &TraceRequest) -> Traced {
    match tracer {
        Tracer::HalfSpace => trace_half_space(medium, request, Control::default()).unwrap(),
        Tracer::Plain => trace_plain(medium, request, Control::default()).unwrap(),
    }
}

#[test]
fn any_split_gives_the_whole() {
    let cases = [
        (Tracer::HalfSpace, medium(), request(&[5.0, 1.0, 16.0], Incidence::Diffuse, 20_001)),
        (Tracer::HalfSpace, modified_cloud(), request(&[3.0, 0.0], beam(0.3), 1_200_003)),
        (Tracer::Plain, full(cloud(), 1.0), request(&[0.5, 2.0], beam(1.0), 3_001)),
        (Tracer::HalfSpace, medium(), request(&[2.0], beam(1.0), 3)),
    ];
    for (tracer, medium, request) in cases {
        let expected = whole(tracer, &medium, &request);
        let job = TraceJob::new(tracer, &medium, &request).unwrap();
        for of in 1..=7 {
            let threads = 1 + of as usize % 2;
            let pool = ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            let mut parts: Vec<Part> =
                pool.install(|| (1..=of).map(|number| traced_share(&job, share(number, of))).collect());
            parts.rotate_left(of as usize / 2);
            let mut sum = job.part();
            parts.iter().for_each(|part| sum.merge(part).unwrap());
            assert_eq!(sum.finish().unwrap(), expected, "{tracer} in {of} parts");
        }
    }
}

/// Stopped after every few cells, sent, and taken up again by another number of threads.
#[test]
fn a_trace_that_is_stopped_many_times_ends_as_the_whole() {
    let target = Stop::StdError { target: 4e-3, max_photons: 1 << 20 };
    let stops = [Stop::Photons(150_000), target];
    for stop in stops {
        let request = TraceRequest { stop, ..request(&[1.0, 9.0], beam(0.5), 2) };
        let request = TraceRequest { max_order: 1, ..request };
        let medium = medium();
        let job = TraceJob::new(Tracer::HalfSpace, &medium, &request).unwrap();
        let (mut part, mut stopped) = (job.part(), 0);
        loop {
            let cancel = AtomicBool::new(false);
            let control = Control { progress: None, cancel: Some(&cancel) };
            let (mut cells, mut held) = (0, 0);
            let keep = |part: &Part| {
                cells += 1;
                held = part.photons();
                cancel.store(cells >= 10, Ordering::Relaxed);
            };
            let pool = ThreadPoolBuilder::new().num_threads(1 + stopped % 2).build().unwrap();
            let ended = pool.install(|| job.trace(&mut part, Share::WHOLE, control, keep));
            assert!(part.photons() >= held);
            part = sent(&part);
            match ended {
                Ok(()) => break,
                Err(error) => assert_eq!(error, TransportError::Cancelled),
            }
            assert!(matches!(part.finish(), Err(TransportError::Missing { .. })));
            stopped += 1;
        }
        assert!(stopped >= 5, "{stopped}");
        assert_eq!(part.finish().unwrap(), half_space(&medium, &request));
    }
}

#[test]
fn photons_are_neither_counted_twice_nor_missed() {
    let (medium, request) = (medium(), request(&[1.0], beam(1.0), 10_000));
    let job = TraceJob::new(Tracer::HalfSpace, &medium, &request).unwrap();
    let [first, second, other] = [share(1, 2), share(2, 2), share(2, 3)].map(|s| traced_share(&job, s));
    let mut sum = first.clone();
    assert_eq!(
        sum.finish().unwrap_err().to_string(),
        "5000 photons are missing, from photon 5000 to 9999 first"
    );
    for (twice, message) in [(&first, "photons 0 to 4999"), (&other, "photons 3333 to 4999")] {
        let before = sum.clone();
        let error = sum.merge(twice).unwrap_err().to_string();
        assert_eq!(error, format!("{message} would be counted twice"));
        assert_eq!(sum, before, "a refused part has changed something");
    }
    let missing = sum.missing(share(2, 3)).unwrap();
    assert!(missing.len() == 1 && missing[0] == (5000..6666), "{missing:?}");
    sum.merge(&second).unwrap();
    assert_eq!(sum.finish().unwrap(), half_space(&medium, &request));
    assert!(sum.missing(Share::WHOLE).unwrap().is_empty());
}

#[test]
fn foreign_parts_are_refused_with_the_first_difference() {
    let (medium, good) = (medium(), request(&[1.0], beam(1.0), 1000));
    let other_medium = full(hg(0.84), 0.99);
    let part = |tracer, medium: &TraceMedium, request: &TraceRequest| {
        TraceJob::new(tracer, medium, request).unwrap().part()
    };
    let half = Tracer::HalfSpace;
    let mut sum = part(half, &medium, &good);
    let cases = [
        (part(Tracer::Plain, &medium, &good), "its tracer is plain, not half-space"),
        (part(half, &medium, &TraceRequest { seed: 7, ..good.clone() }), "its seed is 7, not 20060905"),
        (part(half, &other_medium, &good), "its medium is "),
        (part(half, &medium, &request(&[1.5], beam(1.0), 1000)), "its tau is [1.5], not [1.0]"),
        (part(half, &medium, &request(&[1.0], beam(0.5), 1000)), "its mu0 is 0.5, not 1"),
        (part(half, &medium, &request(&[1.0], beam(1.0), 1001)), "its photons is "),
        (part(half, &medium, &TraceRequest { max_order: 3, ..good.clone() }), "its orders is 3, not 2"),
        (part(half, &medium, &TraceRequest { stream: 3, ..good.clone() }), "its stream is 3, not 0"),
        (
            Part::of_engine(Identity::new("half-space", "other", &medium), &good, true).unwrap(),
            "its algorithm of the tracer is other, not ",
        ),
    ];
    for (other, message) in cases {
        let error = sum.merge(&other).unwrap_err().to_string();
        assert!(error.contains(message), "{error}");
    }
}

#[test]
fn a_trace_with_a_target_error_has_no_shares() {
    let stop = Stop::StdError { target: 1e-2, max_photons: 1000 };
    let request = TraceRequest { stop, ..request(&[1.0], beam(1.0), 2) };
    let medium = medium();
    let job = TraceJob::new(Tracer::HalfSpace, &medium, &request).unwrap();
    let mut part = job.part();
    let refused = job.trace(&mut part, share(1, 2), Control::default(), |_| ());
    assert_eq!(refused, Err(TransportError::OneAfterTheOther));
    job.trace(&mut part, Share::WHOLE, Control::default(), |_| ()).unwrap();
    assert_eq!(part.clone().merge(&part), Err(TransportError::OneAfterTheOther));
    assert_eq!(part.finish().unwrap(), half_space(&medium, &request));
}

/// An engine of its own: it takes cells from the part and hands in integers.
#[test]
fn another_engines_counts_must_balance() {
    let (medium, request) = (medium(), request(&[1.0, 2.0], beam(1.0), 5000));
    let identity = Identity::new("mirror", "1", &medium);
    let mut part = Part::of_engine(identity, &request, false).unwrap();
    let cells = part.next(Share::WHOLE, 10).unwrap();
    let mut wrong = part.empty_tally();
    wrong.launched = 11;
    assert!(matches!(part.add(&cells[0], &wrong), Err(TransportError::Launched { launched: 11, .. })));
    wrong.absorbed.pop();
    assert!(matches!(part.add(&cells[0], &wrong), Err(TransportError::Shape { .. })));
    for (index, cell) in cells.iter().enumerate() {
        let mut tally = part.empty_tally();
        tally.launched = cell.photons().end - cell.photons().start;
        let lost = u64::from(index == 3);
        // All light of slab 0 turns back after one scattering, that of slab 1 passes unscattered.
        tally.reflected[1] = tally.launched - lost;
        tally.turned[0] = tally.launched;
        let second = tally.transmitted.len() / 2;
        tally.transmitted[second] = tally.launched;
        part.add(cell, &tally).unwrap();
        assert!(matches!(part.add(cell, &tally), Err(TransportError::CountedTwice { .. })));
    }
    let error = part.finish().unwrap_err();
    assert_eq!(error, TransportError::Books { tau: 1.0, counted: 4999, launched: 5000 });
}

/// What a checksum lets through because it was so when it was written.
#[test]
fn stored_counts_that_contradict_themselves_are_refused() {
    let (medium, request) = (medium(), request(&[1.0], beam(1.0), 1000));
    let part = traced_share(&TraceJob::new(Tracer::HalfSpace, &medium, &request).unwrap(), share(1, 2));
    let good = postcard::to_allocvec(&part).unwrap();
    let mut refused = 0;
    for at in 0..good.len() {
        for bit in [1_u8, 8, 128] {
            let mut bytes = good.clone();
            bytes[at] ^= bit;
            // Whatever was changed, nothing panics; a lost or invented photon does not pass.
            match postcard::from_bytes::<Part>(&bytes) {
                Err(_) => refused += 1,
                Ok(other) => assert!(other != part || bytes == good),
            }
        }
    }
    assert!(refused > 0);
}
