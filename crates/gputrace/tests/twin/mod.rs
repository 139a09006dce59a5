//! The device's tracer told once more, one history after the other, with the CPU's single-precision functions.

use rand::Rng;
use stratiform_gputrace::BatchCounts;
use stratiform_optics::sampling::LinearPieces;
use stratiform_quantities::Incidence;
use stratiform_stats::{Purpose, key, photon_stream};
use stratiform_transport::single::{collide_and_fly, diffuse_cosine, optical_path};
use stratiform_transport::{TraceMedium, TraceRequest};

/// Counts of photon `index` are added to `counts`; slabs ascend.
pub fn history(
    medium: &TraceMedium,
    pieces: &LinearPieces,
    request: &TraceRequest,
    index: u64,
    counts: &mut BatchCounts,
) {
    let key = key(request.seed, Purpose::HalfSpaceTracer(request.stream));
    let mut rng = photon_stream(key, index);
    let absorbs_from = (medium.albedo() * 4_294_967_296.0).round() as u64;
    let bins = request.max_order as usize + 2;
    let bottom = |slab: usize| request.tau.get(slab).map(|tau| (tau * medium.extinction()) as f32);
    let mut mu = match request.incidence {
        Incidence::Beam(mu0) => mu0.get() as f32,
        Incidence::Diffuse => diffuse_cosine(rng.next_u32()),
    };
    let mut depth = mu * optical_path(rng.next_u32());
    let (mut slab, mut order) = (0, 0_u64);
    counts.launched += 1;
    loop {
        let cell = |slab: usize| slab * bins + (order as usize).min(bins - 1);
        while bottom(slab).is_some_and(|bottom| depth >= bottom) {
            counts.transmitted[cell(slab)] += 1;
            counts.passed[slab] += order;
            slab += 1;
        }
        if slab == request.tau.len() {
            return;
        }
        if depth < 0.0 {
            counts.reflected[cell(slab)] += 1;
            counts.turned[slab] += order;
            return;
        }
        if absorbs_from < 1 << 32 && u64::from(rng.next_u32()) >= absorbs_from {
            counts.absorbed[slab] += 1;
            counts.turned[slab] += order;
            return;
        }
        (mu, depth) = collide_and_fly(pieces, mu, depth, std::array::from_fn(|_| rng.next_u32()));
        order += 1;
    }
}

/// The batches of the first round, of `photons`.
pub fn trace(medium: &TraceMedium, request: &TraceRequest, photons: u64) -> Vec<BatchCounts> {
    let pieces = LinearPieces::new(medium.table().phase().as_ref());
    let (rows, slabs) = (request.tau.len() * (request.max_order as usize + 2), request.tau.len());
    let zero = |cells| vec![0; cells];
    let batch = |batch: u64| {
        let mut counts = BatchCounts {
            launched: 0,
            reflected: zero(rows),
            transmitted: zero(rows),
            absorbed: zero(slabs),
            turned: zero(slabs),
            passed: zero(slabs),
        };
        for index in photons * batch / 256..photons * (batch + 1) / 256 {
            history(medium, &pieces, request, index, &mut counts);
        }
        counts
    };
    (0..256).map(batch).collect()
}
