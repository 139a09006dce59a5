//! The fast tracer: one history in a half space serves every thickness.
//!
//! A photon that turns back at greatest depth d is reflected by all slabs thicker than d. It is transmitted
//! by a slab of thickness H at the moment its depth first passes H, with the scatterings it has had by then; one
//! flight may pass several. Only depth and direction cosine μ matter for fluxes, and the azimuth ψ about
//! the direction of flight is uniform: μ' = μ cosΘ + √(1-μ²) sinΘ cosψ, with sin²Θ = v(2-v), v = 1 - cosΘ.
//! The arithmetic is in [`lanes`](crate::lanes); here photons enter the lanes, are counted, and leave.

use crate::kernels::{exponential, uniform};
use crate::lanes::{LANES, Lanes, collide_and_fly};
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
    /// Ascending.
    bottoms: Vec<f64>,
    incidence: Incidence,
    /// A collision absorbs where its random word is not below this: ω to within 1.2·10⁻¹⁰.
    absorbs_from: u64,
    key: u64,
}

impl<'a> HalfSpace<'a> {
    pub fn new(medium: &'a TraceMedium, request: &TraceRequest, tau: &[f64]) -> Self {
        Self {
            table: medium.table(),
            bottoms: tau.iter().map(|tau| tau * medium.extinction()).collect(),
            incidence: request.incidence,
            absorbs_from: (medium.albedo() * 4_294_967_296.0).round() as u64,
            key: key(request.seed, Purpose::HalfSpaceTracer(request.stream)),
        }
    }

    /// μ at the top.
    fn incident_cosine(&self, rng: &mut Pcg32) -> f64 {
        match self.incidence {
            Incidence::Beam(mu0) => mu0.get(),
            Incidence::Diffuse => uniform(rng.next_u32()).sqrt(),
        }
    }
}

impl Estimator for HalfSpace<'_> {
    const NESTED: bool = true;

    fn trace(&self, photons: Range<u64>, tally: &mut Tally, control: Control<'_>) {
        Flock::new(self, photons, tally).trace(control);
    }
}

/// The photons of one batch on their way through the lanes.
struct Flock<'a> {
    half_space: &'a HalfSpace<'a>,
    waiting: Range<u64>,
    tally: &'a mut Tally,
    lanes: Lanes,
    /// The first slab that each lane's photon has not passed.
    slab: [usize; LANES],
    in_flight: usize,
}

impl<'a> Flock<'a> {
    fn new(half_space: &'a HalfSpace<'a>, photons: Range<u64>, tally: &'a mut Tally) -> Self {
        let (lanes, slab) = (Lanes::parked(), [0; LANES]);
        Self { half_space, waiting: photons, tally, lanes, slab, in_flight: 0 }
    }

    fn trace(mut self, control: Control<'_>) {
        (0..LANES).for_each(|lane| self.launch(lane));
        while self.in_flight > 0 {
            let half_space = self.half_space;
            let mut events = collide_and_fly(&mut self.lanes, half_space.table, half_space.absorbs_from);
            if events != 0 && control.is_cancelled() {
                return;
            }
            while events != 0 {
                self.settle(events.trailing_zeros() as usize);
                events &= events - 1;
            }
        }
    }

    /// Starts the next photon that does not pass all slabs in its first flight; parks the lane if none is left.
    fn launch(&mut self, lane: usize) {
        while let Some(index) = self.waiting.next() {
            let mut rng = photon_stream(self.half_space.key, index);
            let mu = self.half_space.incident_cosine(&mut rng);
            let depth = mu * exponential(rng.next_u32());
            self.tally.launch(1);
            let slab = self.pass(0, depth, 0);
            if let Some(&bottom) = self.half_space.bottoms.get(slab) {
                self.lanes.place(lane, &rng, mu, depth, bottom);
                self.slab[lane] = slab;
                self.in_flight += 1;
                return;
            }
        }
        self.lanes.park(lane);
    }

    /// Counts the slabs from `slab` on whose bottoms are above `depth`; returns the first that is not.
    #[inline]
    fn pass(&mut self, mut slab: usize, depth: f64, order: u32) -> usize {
        while self.half_space.bottoms.get(slab).is_some_and(|&bottom| depth >= bottom) {
            self.tally.transmit(slab, order);
            slab += 1;
        }
        slab
    }

    /// Counts what happened to a photon, and replaces it if it has ended.
    fn settle(&mut self, lane: usize) {
        if self.lanes.is_parked(lane) {
            return;
        }
        let (slab, depth, order) = (self.slab[lane], self.lanes.depth[lane], self.lanes.order[lane]);
        if self.lanes.absorbed[lane] {
            self.tally.absorb(slab, order - 1);
        } else if depth < 0.0 {
            self.tally.reflect(slab, order);
        } else {
            let slab = self.pass(slab, depth, order);
            if let Some(&bottom) = self.half_space.bottoms.get(slab) {
                self.slab[lane] = slab;
                self.lanes.bottom[lane] = bottom;
                return;
            }
        }
        self.in_flight -= 1;
        self.launch(lane);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::kernels::cos_azimuth;
    use crate::{Quantity, Stop};
    use std::sync::Arc;
    use stratiform_optics::phase::{HenyeyGreenstein, PhaseFunction};
    use stratiform_quantities::{Asymmetry, Order, SingleScatteringAlbedo};

    /// One history by itself, as the module's first lines tell it.
    fn history(half_space: &HalfSpace<'_>, rng: &mut Pcg32, tally: &mut Tally) {
        let mut mu = half_space.incident_cosine(rng);
        let (mut depth, mut slab, mut order) = (0.0, 0, 0);
        loop {
            depth += mu * exponential(rng.next_u32());
            if depth < 0.0 {
                return tally.reflect(slab, order);
            }
            while half_space.bottoms.get(slab).is_some_and(|&bottom| depth >= bottom) {
                tally.transmit(slab, order);
                slab += 1;
            }
            if slab == half_space.bottoms.len() {
                return;
            }
            if half_space.absorbs_from < 1 << 32 && u64::from(rng.next_u32()) >= half_space.absorbs_from {
                return tally.absorb(slab, order);
            }
            let v = half_space.table.sample(rng.next_u32());
            let sine = ((1.0 - mu * mu).max(0.0) * v * (2.0 - v)).sqrt();
            mu = mu * (1.0 - v) + sine * cos_azimuth(rng.next_u32());
            order += 1;
        }
    }

    /// Side by side or one after the other, with or without vector instructions: the same photons.
    #[test]
    fn lanes_change_nothing() {
        let phase: Arc<dyn PhaseFunction> = Arc::new(HenyeyGreenstein::new(Asymmetry::new(0.85).unwrap()));
        for omega in [1.0, 0.9] {
            for (incidence, photons) in [(Incidence::Diffuse, 5_000), (Incidence::beam(0.0).unwrap(), 7)] {
                let omega = SingleScatteringAlbedo::new(omega).unwrap();
                let medium = TraceMedium::full(phase.clone(), omega);
                let tau = vec![0.0, 0.5, 5.0, 16.0];
                let stop = Stop::Photons(photons);
                let request = TraceRequest { tau, incidence, stop, max_order: 3, seed: 5, stream: 2 };
                let half_space = HalfSpace::new(&medium, &request, &request.tau);
                let mut tally = Tally::new(request.tau.len(), request.bins(), true);
                let mut flock = tally.clone();
                for index in 0..photons {
                    tally.launch(1);
                    history(&half_space, &mut photon_stream(half_space.key, index), &mut tally);
                }
                half_space.trace(0..photons, &mut flock, Control::default());
                assert_eq!(flock, tally);
                let counts = tally.spread();
                assert!(counts.of(3, Quantity::Transmittance(Order::Total)) > 0 || photons < 10);
            }
        }
    }
}
