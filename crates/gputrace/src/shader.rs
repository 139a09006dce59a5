//! The device's side of the tracer.

use stratiform_gpu::{Access, Gpu, GpuError, Kernel};
use stratiform_quantities::Incidence;
use stratiform_stats::{Purpose, key};
use stratiform_transport::{Stretch, TraceMedium, TraceRequest};

const PARTS: [&str; 3] =
    [include_str!("wgsl/stream.wgsl"), include_str!("wgsl/flight.wgsl"), include_str!("wgsl/trace.wgsl")];

/// Most flights between two looks at a photon: a look costs as much as some, and a photon in 15 or so has done something.
const FLIGHTS: u32 = 16;
/// Photons of one workgroup.
pub(crate) const WORKGROUP: u32 = 64;

/// The module with the entry point `trace`.
pub(crate) fn text() -> String {
    PARTS.concat()
}

/// The kernel of such a module.
pub(crate) fn kernel(gpu: &Gpu, text: &str) -> Result<Kernel, GpuError> {
    use Access::{Read, Uniform, Write};
    let bindings = [Uniform, Read, Read, Write, Write, Write, Write];
    gpu.kernel(text, "trace", &bindings)
}

/// What the kernel is told with every dispatch.
#[derive(Clone, Copy, Debug, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(C)]
pub(crate) struct Settings {
    pub key: [u32; 2],
    pub first: [u32; 2],
    pub place: u32,
    pub count: u32,
    pub last_round: u32,
    pub last_length: u32,
    pub thicknesses: u32,
    pub bins: u32,
    pub absorbing: u32,
    pub absorbs_from: u32,
    pub diffuse: u32,
    pub mu: f32,
    pub looks: u32,
    pub flights: u32,
}

impl Settings {
    /// With an empty queue.
    pub fn new(medium: &TraceMedium, request: &TraceRequest) -> Self {
        // The number of 2³² random words that do not absorb.
        let scattering = (medium.albedo() * 4_294_967_296.0).round() as u64;
        let mu = match request.incidence {
            Incidence::Beam(mu0) => mu0.get() as f32,
            Incidence::Diffuse => 0.0,
        };
        Self {
            key: words(key(request.seed, Purpose::HalfSpaceTracer(request.stream))),
            thicknesses: request.tau.len() as u32,
            bins: request.max_order + 2,
            absorbing: u32::from(scattering < 1 << 32),
            absorbs_from: scattering as u32,
            diffuse: u32::from(request.incidence == Incidence::Diffuse),
            mu,
            flights: FLIGHTS,
            ..bytemuck::Zeroable::zeroed()
        }
    }

    pub fn enqueue(&mut self, stretch: &Stretch) {
        let (photons, first, last) = (stretch.photons(), stretch.first_round(), stretch.last_round());
        self.first = words(photons.start);
        self.place = (photons.start - first) as u32;
        self.count = (photons.end - photons.start) as u32;
        self.last_round = ((last.start - first) / Stretch::ROUND) as u32;
        self.last_length = (last.end - last.start) as u32;
    }
}

/// Low and high word.
fn words(value: u64) -> [u32; 2] {
    [value as u32, (value >> 32) as u32]
}

/// A photon in flight, or (all zero) none.
#[derive(Clone, Copy, Debug, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(C)]
pub(crate) struct Photon {
    pub state: [u32; 2],
    pub increment: [u32; 2],
    pub mu: f32,
    pub depth: f32,
    pub slab: u32,
    pub order: u32,
    pub batch: u32,
    pub fate: u32,
}
