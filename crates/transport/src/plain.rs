//! The reference tracer: three-dimensional positions and directions, one slab at a time, the phase
//! function's own inversion, library functions. It shares run control, tallies and the generator with
//! the fast tracer, but no sampling and no geometry.

use crate::run::{Estimator, run};
use crate::tally::Tally;
use crate::{Control, TraceMedium, TraceRequest, Traced, TransportError};
use glam::DVec3;
use rand::Rng;
use rand_pcg::Pcg32;
use std::f64::consts::TAU;
use std::ops::Range;
use stratiform_quantities::Incidence;
use stratiform_stats::{Purpose, key, photon_stream};

/// Traces `request` through `medium`, each thickness with photons of its own.
///
/// # Errors
/// [`TransportError`] for input out of domain, on cancellation, or if photons are not all accounted for.
pub fn trace_plain(
    medium: &TraceMedium,
    request: &TraceRequest,
    control: Control<'_>,
) -> Result<Traced, TransportError> {
    run(medium, request, control, Plain::new)
}

/// Slabs of one medium. Depth is the z coordinate, in mean free paths.
struct Plain<'a> {
    medium: &'a TraceMedium,
    bottoms: Vec<f64>,
    incidence: Incidence,
    key: u64,
}

/// How a history ended.
enum End {
    Reflected,
    Transmitted,
    Absorbed,
}

impl<'a> Plain<'a> {
    fn new(medium: &'a TraceMedium, request: &TraceRequest, tau: &[f64]) -> Self {
        Self {
            medium,
            bottoms: tau.iter().map(|tau| tau * medium.extinction()).collect(),
            incidence: request.incidence,
            key: key(request.seed, Purpose::PlainTracer(request.stream)),
        }
    }

    fn launch(&self, rng: &mut Pcg32) -> DVec3 {
        let mu = match self.incidence {
            Incidence::Beam(mu0) => mu0.get(),
            Incidence::Diffuse => uniform(rng).sqrt(),
        };
        DVec3::new((1.0 - mu * mu).sqrt(), 0.0, mu)
    }

    /// A new direction at the sampled angle from `direction`.
    fn scatter(&self, direction: DVec3, rng: &mut Pcg32) -> DVec3 {
        let v = self.medium.table().phase().invert(uniform(rng));
        let azimuth = TAU * uniform(rng);
        let (across, up) = direction.any_orthonormal_pair();
        let sideways = across * libm::cos(azimuth) + up * libm::sin(azimuth);
        (direction * (1.0 - v) + sideways * (v * (2.0 - v)).sqrt()).normalize()
    }

    fn history(&self, bottom: f64, rng: &mut Pcg32) -> (End, u32) {
        let mut direction = self.launch(rng);
        let mut position = DVec3::ZERO;
        let mut order = 0;
        loop {
            position += direction * -libm::log(uniform(rng));
            if position.z < 0.0 {
                return (End::Reflected, order);
            }
            if position.z >= bottom {
                return (End::Transmitted, order);
            }
            if uniform(rng) >= self.medium.albedo() {
                return (End::Absorbed, order);
            }
            direction = self.scatter(direction, rng);
            order += 1;
        }
    }
}

impl Estimator for Plain<'_> {
    const NESTED: bool = false;

    fn trace(&self, photons: Range<u64>, tally: &mut Tally, control: Control<'_>) {
        for index in photons {
            tally.launch(1);
            for (slab, &bottom) in self.bottoms.iter().enumerate() {
                if control.is_cancelled() {
                    return;
                }
                let mut rng = photon_stream(self.key, index | (slab as u64) << 48);
                match self.history(bottom, &mut rng) {
                    (End::Reflected, order) => tally.reflect(slab, order),
                    (End::Transmitted, order) => tally.transmit(slab, order),
                    (End::Absorbed, order) => tally.absorb(slab, order),
                }
            }
        }
    }
}

/// A number in (0, 1) from 52 random bits.
fn uniform(rng: &mut Pcg32) -> f64 {
    ((rng.next_u64() >> 12) as f64 + 0.5) / 4_503_599_627_370_496.0
}
