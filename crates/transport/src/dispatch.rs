//! Which arithmetic traces photons: its precision, and the instructions that it is compiled to.
//!
//! The instructions are chosen once per job, so everything it does is compiled for them.

use crate::Control;
use crate::flock::Flock;
use crate::flux_flock;
use crate::half_space::HalfSpace;
use crate::real::Real;
use crate::tally::Tally;
use std::ops::Range;

/// Precision of depth, direction and random variates.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Precision {
    /// f32; see [`single`](crate::single).
    Single,
    /// f64.
    Double,
}

/// Instruction sets. None of them changes a result.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Instructions {
    /// The widest vectors that the processor has: AVX-512, AVX2 or NEON.
    #[default]
    Widest,
    /// AVX2 where the processor has it.
    Avx2,
    /// What every processor of the architecture has.
    Portable,
}

/// How the half-space tracer computes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Kernel {
    /// Single unless a slab is deeper than [`Kernel::SINGLE_DEPTH`], if not given.
    pub precision: Option<Precision>,
    /// The widest if not given.
    pub instructions: Instructions,
}

impl Kernel {
    /// The deepest slab, in its medium's own optical thickness, for which single precision is the default.
    ///
    /// Down to it no reflectance or transmittance is off by 10⁻⁵: on the same photons (2²¹ per case; isotropic, Henyey–Greenstein 0.85,
    /// the paper's cloud with and without its forward events; beams of μ0 = 1 to 0.01, diffuse light; ω = 1, 0.9) f32 and f64 differ by
    /// at most 1.9·10⁻⁶ in any row, 4.5·10⁻⁶ with three standard errors (`cargo run --release -p stratiform-transport --example
    /// precision_bias -- 262144 8`). Both use a photon's words alike, so what that costs is not among it: relative changes of 10⁻⁷ of the mean path and
    /// 1.5·10⁻⁶ of its mean square.
    pub const SINGLE_DEPTH: f64 = 300.0;

    /// The precision for slabs down to `depth`.
    pub fn precision(self, depth: f64) -> Precision {
        let fitting = if depth <= Self::SINGLE_DEPTH { Precision::Single } else { Precision::Double };
        self.precision.unwrap_or(fitting)
    }
}

/// Photons to trace in one go.
pub(crate) struct Job<'a> {
    pub half_space: &'a HalfSpace<'a>,
    pub photons: &'a [Range<u64>],
    /// One for each range of photons.
    pub tallies: &'a mut [Tally],
    pub control: Control<'a>,
}

impl Job<'_> {
    #[inline(always)]
    fn run<R: Real>(self) {
        match self.half_space.fluxes {
            None => Flock::<R>::trace(self.half_space, self.photons, self.tallies, self.control),
            Some(extent) => {
                flux_flock::trace::<R>(self.half_space, extent, self.photons, self.tallies, self.control);
            }
        }
    }
}

/// Traces a job by `kernel`.
pub(crate) fn dispatch(kernel: Kernel, job: Job<'_>) {
    let deepest = job.half_space.bottoms.last().copied().unwrap_or(0.0);
    match (kernel.precision(deepest), kernel.instructions) {
        (Precision::Single, Instructions::Widest) => single_widest(job),
        (Precision::Single, Instructions::Avx2) => single_avx2(job),
        (Precision::Single, Instructions::Portable) => job.run::<f32>(),
        (Precision::Double, Instructions::Widest) => double_widest(job),
        (Precision::Double, Instructions::Avx2) => double_avx2(job),
        (Precision::Double, Instructions::Portable) => job.run::<f64>(),
    }
}

#[multiversion::multiversion(targets(
    "x86_64+avx512f+avx512bw+avx512cd+avx512dq+avx512vl+avx512vbmi2+avx2+fma",
    "x86_64+avx512f+avx512bw+avx512cd+avx512dq+avx512vl+avx2+fma",
    "x86_64+avx2",
    "aarch64+neon"
))]
fn single_widest(job: Job<'_>) {
    job.run::<f32>();
}

#[multiversion::multiversion(targets(
    "x86_64+avx512f+avx512bw+avx512cd+avx512dq+avx512vl+avx2+fma",
    "x86_64+avx2",
    "aarch64+neon"
))]
fn double_widest(job: Job<'_>) {
    job.run::<f64>();
}

#[multiversion::multiversion(targets("x86_64+avx2"))]
fn single_avx2(job: Job<'_>) {
    job.run::<f32>();
}

#[multiversion::multiversion(targets("x86_64+avx2"))]
fn double_avx2(job: Job<'_>) {
    job.run::<f64>();
}
