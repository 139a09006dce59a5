//! Fluxes by the reference tracer, [`walk`](crate::walk): one slab at a time. It shares run control, tallies and
//! the generator with the fast tracer, but no sampling and no geometry.

use crate::run::{Estimator, run};
use crate::tally::Tally;
use crate::walk::{Walk, inverted, sunbeam, uniform};
use crate::{Control, TraceMedium, TraceRequest, Traced, TransportError};
use glam::DVec3;
use rand_pcg::Pcg32;
use std::ops::Range;
use stratiform_quantities::{Incidence, Side};
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
pub(crate) struct Plain<'a> {
    medium: &'a TraceMedium,
    bottoms: Vec<f64>,
    incidence: Incidence,
    key: u64,
}

impl<'a> Plain<'a> {
    pub fn new(medium: &'a TraceMedium, request: &TraceRequest, tau: &[f64]) -> Self {
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
        sunbeam(mu)
    }
}

impl Estimator for Plain<'_> {
    const NESTED: bool = false;
    const LONGEST: u64 = 64;

    fn trace(&self, photons: Range<u64>, tally: &mut Tally, control: Control<'_>) {
        let sampler = inverted(self.medium);
        for index in photons {
            tally.launch(1);
            for (slab, &bottom) in self.bottoms.iter().enumerate() {
                if control.is_cancelled() {
                    return;
                }
                let mut rng = photon_stream(self.key, index | (slab as u64) << 48);
                let start = self.launch(&mut rng);
                let end = Walk { medium: self.medium, sampler, bottom }.history(start, &mut rng, |_| ());
                match end.side {
                    Some(Side::Top) => tally.reflect(slab, end.order),
                    Some(Side::Bottom) => tally.transmit(slab, end.order),
                    None => tally.absorb(slab, end.order),
                }
            }
        }
    }
}
