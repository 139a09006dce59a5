// The half-space tracer: each invocation carries one photon, and takes the next of the queue when it has ended.
//
// A look counts what the photon has done, replaces it if it has ended, and lets it fly some times, at most until it has done
// something. So that the neighbours of a photon that has wait for it together, what is done seldom is in one place.
// Wherever a loop stops, by itself or by the driver, the photon is whole and goes on with the next dispatch.

struct Settings {
    key: vec2<u32>,
    // Number of the queue's first photon, and its place in its round.
    first: vec2<u32>,
    place: u32,
    // Photons in the queue.
    count: u32,
    // The last round, counted from that of the first photon, and its length; the others are full.
    last_round: u32,
    last_length: u32,
    thicknesses: u32,
    bins: u32,
    absorbing: u32,
    absorbs_from: u32,
    diffuse: u32,
    mu: f32,
    // Looks at a photon in one dispatch, and most flights between two.
    looks: u32,
    flights: u32,
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

const NONE: u32 = 0u;
const FLYING: u32 = 1u;
const ABSORBED: u32 = 2u;

const ROUND: u32 = 1048576u;
const BATCHES: u32 = 256u;

// The batch of the queue's photon `number`.
fn batch_of(number: u32) -> u32 {
    let round = (settings.place + number) / ROUND;
    let place = (settings.place + number) % ROUND;
    let length = select(ROUND, settings.last_length, round == settings.last_round);
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

// Whether the photon is above the cloud or has passed its slab.
fn is_out(photon: Photon, bottom: f32) -> bool {
    return photon.depth < 0.0 || photon.depth >= bottom;
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
    for (var look = 0u; look < settings.looks; look++) {
        while (photon.fate == ABSORBED || (photon.fate == FLYING && is_out(photon, bottom))) {
            let passes = photon.fate == FLYING && photon.depth >= bottom;
            count(photon, passes);
            if (passes) {
                photon.slab += 1u;
                bottom = bottoms[photon.slab];
            }
            let absorbed = photon.fate == ABSORBED;
            let end = vec4<bool>(false, !passes && !absorbed, passes && photon.slab == settings.thicknesses, absorbed);
            books += select(vec4<u32>(0u), vec4<u32>(1u), end);
            photon.fate = select(photon.fate, NONE, any(end));
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
        for (var flight = 0u; flight < settings.flights; flight++) {
            if (photon.fate != FLYING || is_out(photon, bottom)) {
                break;
            }
            if (settings.absorbing == 1u && draw(&stream) >= settings.absorbs_from) {
                photon.fate = ABSORBED;
                break;
            }
            let v = sampled(draw(&stream));
            let word = draw(&stream);
            photon.mu = scattered(photon.mu, v, azimuth_cosine(word));
            photon.depth += photon.mu * flight_path(word);
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
