//! The fast tracer: one history in a half space serves every thickness.
//!
//! A photon that turns back at greatest depth d is reflected by all slabs thicker than d. It is transmitted
//! by a slab of thickness H at the moment its depth first passes H, with the scatterings it has had by then; one
//! flight may pass several. Only depth and direction cosine μ matter for fluxes, and the azimuth ψ about
//! the direction of flight is uniform: μ' = μ cosΘ + √(1-μ²) sinΘ cosψ, with sin²Θ = v(2-v), v = 1 - cosΘ.

use crate::kernels::{cos_azimuth, exponential, uniform};
use crate::run::{Estimator, run};
use crate::tally::Tally;
use crate::{Control, TraceMedium, TraceRequest, Traced, TransportError};
use rand::Rng;
use rand_pcg::Pcg32;
use std::ops::Range;
use stratiform_optics::sampling::SamplingTable;
use stratiform_quantities::Incidence;
use stratiform_stats::{Purpose, key, photon_stream};

/// Traces `request` through `medium`.
///
/// # Errors
/// [`TransportError`] for input out of domain, on cancellation, or if photons are not all accounted for.
pub fn trace_half_space(
    medium: &TraceMedium,
    request: &TraceRequest,
    control: Control<'_>,
) -> Result<Traced, TransportError> {
    run(medium, request, control, HalfSpace::new)
}

/// The half space with the depths at which something is counted, in its own extinction.
pub(crate) struct HalfSpace<'a> {
    table: &'a SamplingTable,
    /// Ascending; infinity stands at the end.
    bottoms: Vec<f64>,
    incidence: Incidence,
    /// A collision absorbs where its random word is not below this.
    absorbs_from: u64,
    key: u64,
}

impl<'a> HalfSpace<'a> {
    fn new(medium: &'a TraceMedium, request: &TraceRequest, tau: &[f64]) -> Self {
        let bottoms = tau.iter().map(|tau| tau * medium.extinction()).chain([f64::INFINITY]).collect();
        Self {
            table: medium.table(),
            bottoms,
            incidence: request.incidence,
            absorbs_from: (medium.albedo() * 4_294_967_296.0).round() as u64,
            key: key(request.seed, Purpose::HalfSpaceTracer(request.stream)),
        }
    }

    fn launch(&self, rng: &mut Pcg32) -> f64 {
        match self.incidence {
            Incidence::Beam(mu0) => mu0.get(),
            Incidence::Diffuse => uniform(rng.next_u32()).sqrt(),
        }
    }

    #[inline]
    fn absorbs(&self, rng: &mut Pcg32) -> bool {
        self.absorbs_from < 1 << 32 && u64::from(rng.next_u32()) >= self.absorbs_from
    }

    /// μ after a scattering.
    #[inline(always)]
    fn scatter(&self, mu: f64, rng: &mut Pcg32) -> f64 {
        let v = self.table.sample(rng.next_u32());
        let sine = ((1.0 - mu * mu).max(0.0) * v * (2.0 - v)).sqrt();
        mu * (1.0 - v) + sine * cos_azimuth(rng.next_u32())
    }

    fn history(&self, rng: &mut Pcg32, tally: &mut Tally) {
        let mut mu = self.launch(rng);
        let mut depth = 0.0;
        let mut next = 0;
        let mut order = 0;
        loop {
            depth += mu * exponential(rng.next_u32());
            if depth < 0.0 {
                return tally.reflect(next, order);
            }
            while depth >= self.bottoms[next] {
                tally.transmit(next, order);
                next += 1;
            }
            if next + 1 == self.bottoms.len() {
                return;
            }
            if self.absorbs(rng) {
                return tally.absorb(next, order);
            }
            mu = self.scatter(mu, rng);
            order += 1;
        }
    }
}

impl Estimator for HalfSpace<'_> {
    const NESTED: bool = true;

    fn trace(&self, photons: Range<u64>, tally: &mut Tally, control: Control<'_>) {
        for index in photons {
            if control.is_cancelled() {
                return;
            }
            tally.launch(1);
            self.history(&mut photon_stream(self.key, index), tally);
        }
    }
}
