//! Scattering events per second on the device, beside what bounds them on the same adapter: its copy bandwidth, and a kernel that only
//! draws the two random words of an event.
//!
//! An event takes two words (about 35 integer operations each), a logarithm, a cosine, a root and the rest of the collision (about
//! 60 operations in single precision), and 8 bytes of the table, 32 KiB for a smooth phase function; a photon that enters and leaves
//! takes 4 counters of 4 bytes, each read and written. A photon's state, 40 bytes, is read and written once per dispatch of at least
//! 16 looks. So the tracer is bound by arithmetic wherever copying reaches a few bytes per hundred operations.
//!
//! Wall times are the least of some runs. On a software adapter the processor time says what a busy machine hides.

#![allow(clippy::unwrap_used, clippy::print_stdout, reason = "a program that prints figures")]

#[path = "../tests/media/mod.rs"]
mod media;

use std::time::Instant;
use stratiform_gpu::{Access, Gpu, Pass};
use stratiform_gputrace::GpuTracer;
use stratiform_quantities::Incidence;
use stratiform_transport::{Control, Stop, TraceMedium, TraceRequest};

const REPEATS: usize = 5;
/// Scatterings of one run.
const EVENTS: f64 = 1.5e7;
const INVOCATIONS: u32 = 1 << 17;
/// Events of one invocation of the kernel that only draws.
const DRAWS: u32 = 100;
/// What is copied, bytes.
const COPIED: u32 = 1 << 26;
const COPY: &str = "
@group(0) @binding(0) var<storage, read> source: array<vec4<u32>>;
@group(0) @binding(1) var<storage, read_write> copied: array<vec4<u32>>;
@compute @workgroup_size(64) fn copy(@builtin(global_invocation_id) id: vec3<u32>) { copied[id.x] = source[id.x]; }
";
const DRAW: &str = "
@group(0) @binding(0) var<storage, read_write> sums: array<u32>;
@compute @workgroup_size(64) fn draw_only(@builtin(global_invocation_id) id: vec3<u32>) {
    var stream = photon_stream(vec2<u32>(1u, 2u), vec2<u32>(id.x, 0u));
    var sum = 0u;
    for (var k = 0u; k < DRAWS; k++) { sum ^= draw(&stream) ^ draw(&stream); }
    sums[id.x] = sum;
}
";

/// Least wall and processor time of some runs, s.
fn least(mut run: impl FnMut()) -> [f64; 2] {
    let mut least = [f64::INFINITY; 2];
    for _ in 0..REPEATS {
        let (start, processor) = (Instant::now(), processor_time());
        run();
        let times = [start.elapsed().as_secs_f64(), processor_time() - processor];
        least = [least[0].min(times[0]), least[1].min(times[1])];
    }
    least
}

/// Processor time of this program so far, s; NaN where the system does not tell.
fn processor_time() -> f64 {
    let stat = std::fs::read_to_string("/proc/self/stat").unwrap_or_default();
    let fields: Vec<f64> = stat
        .rsplit(')')
        .next()
        .into_iter()
        .flat_map(str::split_whitespace)
        .map(|field| field.parse().unwrap_or(f64::NAN))
        .collect();
    // User and system time, in hundredths of a second.
    fields.get(11).zip(fields.get(12)).map_or(f64::NAN, |(user, system)| (user + system) / 100.0)
}

/// Wall and processor time of one event's random words, ns.
fn draws(gpu: &Gpu) -> [f64; 2] {
    let text = format!("const DRAWS: u32 = {DRAWS}u;\n{}{DRAW}", include_str!("../src/wgsl/stream.wgsl"));
    let kernel = gpu.kernel(&text, "draw_only", &[Access::Write]).unwrap();
    let sums = [&gpu.zeroed(4 * INVOCATIONS as usize).unwrap()];
    let pass = Pass { name: "draw", kernel: &kernel, buffers: &sums, groups: [INVOCATIONS / 64, 1, 1] };
    let run = || {
        gpu.submit_passes(&[pass]).unwrap();
        gpu.wait().unwrap();
    };
    run();
    least(run).map(|time| time * 1e9 / f64::from(INVOCATIONS * DRAWS))
}

/// Bytes read and written per second, GB/s.
fn bandwidth(gpu: &Gpu) -> f64 {
    let kernel = gpu.kernel(COPY, "copy", &[Access::Read, Access::Write]).unwrap();
    let buffers = [&gpu.zeroed(COPIED as usize).unwrap(), &gpu.zeroed(COPIED as usize).unwrap()];
    // 16 bytes per invocation, and at most 65535 groups of 64.
    let groups = (COPIED / 16 / 64).min(65_535);
    let pass = Pass { name: "copy", kernel: &kernel, buffers: &buffers, groups: [groups, 1, 1] };
    let run = || {
        gpu.submit_passes(&[pass]).unwrap();
        gpu.wait().unwrap();
    };
    run();
    2.0 * 16.0 * 64.0 * f64::from(groups) / least(run)[0] / 1e9
}

/// Events per photon, and wall and processor time per event, ns.
fn trace(tracer: &GpuTracer, medium: &TraceMedium, tau: f64, incidence: Incidence) -> (f64, [f64; 2]) {
    let request = |photons| {
        let (tau, stop) = (vec![tau], Stop::Photons(photons));
        TraceRequest { tau, incidence, stop, max_order: 2, seed: 1, stream: 0 }
    };
    let run = |photons| tracer.trace(medium, &request(photons), Control::default()).unwrap();
    let per_photon = run(20_000).mean_scatterings(0).value;
    let photons = (EVENTS / per_photon) as u64;
    let time = least(|| drop(run(photons)));
    (per_photon, time.map(|time| time * 1e9 / (photons as f64 * per_photon)))
}

fn main() {
    let gpu = Gpu::new().unwrap();
    println!("{}", gpu.adapter());
    println!("copies {:.1} GB/s, reading and writing", bandwidth(&gpu));
    let bound = draws(&gpu);
    println!("two random words: {:.2} ns, {:.2} ns of processor time\n", bound[0], bound[1]);
    println!(
        "phase,tau,incidence,events per photon,Mevents/s,ns per event,processor ns per event,ratio of it to random words,table and counters GB/s"
    );
    let tracer = GpuTracer::new(&gpu).unwrap();
    for (name, medium) in [("hg 0.85", media::hg(0.85, 1.0)), ("cloud", media::cloud(1.0))] {
        for incidence in [Incidence::beam(1.0).unwrap(), Incidence::Diffuse] {
            for tau in [1.0, 5.0, 16.0, 100.0] {
                let (events, [wall, processor]) = trace(&tracer, &medium, tau, incidence);
                let bytes = 8.0 + 32.0 / events;
                println!(
                    "{name},{tau},{incidence},{events:.2},{:.1},{wall:.2},{processor:.2},{:.2},{:.2}",
                    1e3 / wall,
                    processor / bound[1],
                    bytes / wall
                );
            }
        }
    }
}
