// The half-space tracer: each invocation carries one photon, and takes the next of the queue when it has ended.
// One turn of the loop is one flight, and the collision or launch before it. Whenever a loop stops, the photon is whole.

struct Settings {
    key: vec2<u32>,
    // Index of the queue's first photon, which begins a round.
    first: vec2<u32>,
    // Photons in the queue.
    count: u32,
    // The queue's last round, and its photons.
    last_round: u32,
    last_length: u32,
    thicknesses: u32,
    bins: u32,
    absorbing: u32,
    absorbs_from: u32,
    diffuse: u32,
    mu: f32,
    steps: u32,
}

struct Photon {
    stream: Stream,
    mu: f32,
    depth: f32,
    // The first slab that it has not passed.
    slab: u32,
    order: u32,
    batch: u32,
    fate: u32,
}

struct Ledger {
    // Photons asked of the queue.
    asked: atomic<u32>,
    launched: atomic<u32>,
    reflected: atomic<u32>,
    transmitted: atomic<u32>,
    absorbed: atomic<u32>,
    // More in flight than before, modulo 2³².
    in_flight: atomic<u32>,
}

@group(0) @binding(0) var<uniform> settings: Settings;
@group(0) @binding(1) var<storage, read> bottoms: array<f32>;
@group(0) @binding(2) var<storage, read> table: array<vec2<f32>>;
@group(0) @binding(3) var<storage, read_write> photons: array<Photon>;
@group(0) @binding(4) var<storage, read_write> ledger: Ledger;
// By batch and slab: photons that turned, by order bin; that passed, by order bin; that were absorbed.
@group(0) @binding(5) var<storage, read_write> counts: array<atomic<u32>>;
// By batch and slab: scatterings of photons that turned or were absorbed, and of photons that passed, each as low and high word.
@group(0) @binding(6) var<storage, read_write> scatterings: array<atomic<u32>>;

const FLIGHTS: u32 = 16u;
const NONE: u32 = 0u;
const FLYING: u32 = 1u;
const ABSORBED: u32 = 2u;

const LOG_ROUND: u32 = 20u;
const BATCHES: u32 = 256u;

// The batch of the queue's photon `number`.
fn batch_of(number: u32) -> u32 {
    let round = number >> LOG_ROUND;
    let place = number & ((1u << LOG_ROUND) - 1u);
    let length = select(1u << LOG_ROUND, settings.last_length, round == settings.last_round);
    return (BATCHES * (place + 1u) - 1u) / length;
}

fn launched(number: u32) -> Photon {
    var stream = photon_stream(settings.key, add64(settings.first, vec2<u32>(number, 0u)));
    var photon: Photon;
    photon.mu = settings.mu;
    if (settings.diffuse == 1u) {
        photon.mu = diffuse_cosine(draw(&stream));
    }
    photon.depth = photon.mu * optical_path(draw(&stream));
    photon.stream = stream;
    photon.batch = batch_of(number);
    photon.fate = FLYING;
    return photon;
}

// Adds to a sum of two words.
fn add_scatterings(sum: u32, order: u32) {
    let before = atomicAdd(&scatterings[2u * sum], order);
    if (before + order < before) {
        atomicAdd(&scatterings[2u * sum + 1u], 1u);
    }
}

// Counts that the photon has passed its slab, or else that it has turned or been absorbed there.
fn count(photon: Photon, passes: bool) {
    let row = photon.batch * settings.thicknesses + photon.slab;
    let bin = min(photon.order, settings.bins - 1u);
    let turn = select(bin, 2u * settings.bins, photon.fate == ABSORBED);
    let column = select(turn, settings.bins + bin, passes);
    atomicAdd(&counts[row * (2u * settings.bins + 1u) + column], 1u);
    add_scatterings(2u * row + select(0u, 1u, passes), photon.order);
}

@compute @workgroup_size(64)
fn trace(@builtin(global_invocation_id) id: vec3<u32>) {
    var photon = photons[id.x];
    var stream = photon.stream;
    var bottom = bottoms[photon.slab];
    let before = select(1u, 0u, photon.fate == NONE);
    // Photons launched, reflected, transmitted, absorbed.
    var books = vec4<u32>(0u);
    for (var step = 0u; step < settings.steps; step++) {
        while (photon.fate == ABSORBED || (photon.fate == FLYING && (photon.depth < 0.0 || photon.depth >= bottom))) {
            let passes = photon.fate == FLYING && photon.depth >= bottom;
            count(photon, passes);
            if (passes) {
                photon.slab += 1u;
                bottom = bottoms[photon.slab];
            }
            let ends = !passes || photon.slab == settings.thicknesses;
            books += select(vec4<u32>(0u), vec4<u32>(0u, 1u, 0u, 0u), ends && !passes && photon.fate == FLYING);
            books += select(vec4<u32>(0u), vec4<u32>(0u, 0u, 1u, 0u), ends && passes);
            books += select(vec4<u32>(0u), vec4<u32>(0u, 0u, 0u, 1u), photon.fate == ABSORBED);
            photon.fate = select(photon.fate, NONE, ends);
        }
        if (photon.fate == NONE) {
            let number = atomicAdd(&ledger.asked, 1u);
            if (number >= settings.count) {
                break;
            }
            photon = launched(number);
            stream = photon.stream;
            bottom = bottoms[0];
            books.x += 1u;
        }
        for (var flight = 0u; flight < FLIGHTS; flight++) {
            if (photon.fate != FLYING || photon.depth < 0.0 || photon.depth >= bottom) {
                break;
            }
            if (settings.absorbing == 1u && draw(&stream) >= settings.absorbs_from) {
                photon.fate = ABSORBED;
                break;
            }
            let v = sampled(draw(&stream));
            photon.mu = scattered(photon.mu, v, azimuth_cosine(draw(&stream)));
            photon.depth += photon.mu * optical_path(draw(&stream));
            photon.order += 1u;
        }
    }
    photon.stream = stream;
    photons[id.x] = photon;
    atomicAdd(&ledger.launched, books.x);
    atomicAdd(&ledger.reflected, books.y);
    atomicAdd(&ledger.transmitted, books.z);
    atomicAdd(&ledger.absorbed, books.w);
    atomicAdd(&ledger.in_flight, select(1u, 0u, photon.fate == NONE) - before);
}
