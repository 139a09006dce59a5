//! The fast tracer: one history in a half space serves every thickness.
//!
//! A photon that turns back at greatest depth d is reflected by all slabs thicker than d. It is transmitted
//! by a slab of thickness H at the moment its depth first passes H, with the scatterings it has had by then; one
//! flight may pass several. Only depth and direction cosine μ matter for fluxes, and the azimuth ψ about
//! the direction of flight is uniform: μ' = μ cosΘ + √(1-μ²) sinΘ cosψ, with sin²Θ = v(2-v), v = 1 - cosΘ.
//! The arithmetic is in [`lanes`](crate::lanes); photons go through the lanes in a [`Flock`](crate::flock::Flock).

use crate::dispatch::{Job, dispatch};
use crate::run::{Estimator, run};
use crate::tally::Tally;
use crate::{Control, Extent, Fluxes, Kernel, TraceMedium, TraceRequest, Traced, TransportError};
use std::ops::Range;
use stratiform_quantities::Incidence;
use stratiform_stats::{Purpose, key};

/// Traces `request` through `medium`.
///
/// # Errors
/// [`TransportError`] for input out of domain, on cancellation, or if photons are not all accounted for.
pub fn trace_half_space(
    medium: &TraceMedium,
    request: &TraceRequest,
    control: Control<'_>,
) -> Result<Traced, TransportError> {
    trace_half_space_with(Kernel::default(), medium, request, control)
}

/// The same by a given kernel. Instructions change nothing but the speed; precision changes which photons go where.
///
/// # Errors
/// As [`trace_half_space`].
pub fn trace_half_space_with(
    kernel: Kernel,
    medium: &TraceMedium,
    request: &TraceRequest,
    control: Control<'_>,
) -> Result<Traced, TransportError> {
    run(medium, request, control, |medium, request, tau| HalfSpace::new(kernel, medium, request, tau))
}

/// The same photons' fluxes alone, as far as `extent` says: faster, the more slabs the better.
///
/// # Errors
/// As [`trace_half_space`].
pub fn trace_fluxes(
    medium: &TraceMedium,
    request: &TraceRequest,
    extent: Extent,
    control: Control<'_>,
) -> Result<Fluxes, TransportError> {
    let traced = run(medium, request, control, |medium, request, tau| HalfSpace {
        fluxes: Some(extent),
        ..HalfSpace::new(Kernel::default(), medium, request, tau)
    })?;
    Ok(Fluxes::new(traced, extent))
}

/// The half space with the depths at which something is counted, in its own extinction.
pub(crate) struct HalfSpace<'a> {
    kernel: Kernel,
    pub medium: &'a TraceMedium,
    /// Ascending.
    pub bottoms: Vec<f64>,
    pub incidence: Incidence,
    /// A collision absorbs where its random word is not below this: ω to within 1.2·10⁻¹⁰.
    pub absorbs_from: u64,
    pub key: u64,
    /// Whether fluxes alone are counted, and how far.
    pub fluxes: Option<Extent>,
}

impl<'a> HalfSpace<'a> {
    pub fn new(kernel: Kernel, medium: &'a TraceMedium, request: &TraceRequest, tau: &[f64]) -> Self {
        Self {
            kernel,
            medium,
            bottoms: tau.iter().map(|tau| tau * medium.extinction()).collect(),
            incidence: request.incidence,
            absorbs_from: (medium.albedo() * 4_294_967_296.0).round() as u64,
            key: key(request.seed, Purpose::HalfSpaceTracer(request.stream)),
            fluxes: None,
        }
    }
}

impl Estimator for HalfSpace<'_> {
    const NESTED: bool = true;

    const TOGETHER: usize = 64;

    fn trace(&self, photons: Range<u64>, tally: &mut Tally, control: Control<'_>) {
        self.trace_all(&[photons], std::slice::from_mut(tally), control);
    }

    fn trace_all(&self, photons: &[Range<u64>], tallies: &mut [Tally], control: Control<'_>) {
        dispatch(self.kernel, Job { half_space: self, photons, tallies, control });
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::real::Real;
    use crate::{Instructions, Precision, Quantity, Stop};
    use rand::Rng;
    use rand_pcg::Pcg32;
    use std::sync::Arc;
    use stratiform_optics::phase::{HenyeyGreenstein, PhaseFunction};
    use stratiform_quantities::{Asymmetry, Order, SingleScatteringAlbedo};
    use stratiform_stats::photon_stream;

    /// One history by itself, as the module's first lines tell it.
    fn history<R: Real>(half_space: &HalfSpace<'_>, rng: &mut Pcg32, tally: &mut Tally) {
        let table = R::table(half_space.medium);
        let bottoms: Vec<R> = half_space.bottoms.iter().copied().map(R::rounded).collect();
        let mut mu = match half_space.incidence {
            Incidence::Beam(mu0) => R::rounded(mu0.get()),
            Incidence::Diffuse => R::diffuse_cosine(rng.next_u32()),
        };
        let (mut depth, mut slab, mut order) = (mu * R::optical_path(rng.next_u32()), 0, 0);
        loop {
            if depth < R::ZERO {
                return tally.reflect(slab, order);
            }
            while bottoms.get(slab).is_some_and(|&bottom| depth >= bottom) {
                tally.transmit(slab, order);
                slab += 1;
            }
            if slab == bottoms.len() {
                return;
            }
            if half_space.absorbs_from < 1 << 32 && u64::from(rng.next_u32()) >= half_space.absorbs_from {
                return tally.absorb(slab, order);
            }
            let [v] = R::sample(table, &[rng.next_u32()]);
            let word = rng.next_u32();
            mu = mu.scattered(v, R::azimuth_cosine(word));
            depth = depth + mu * R::flight_path(word);
            order += 1;
        }
    }

    fn one_by_one(half_space: &HalfSpace<'_>, photons: u64, tally: &mut Tally) {
        for index in 0..photons {
            tally.launch(1);
            let rng = &mut photon_stream(half_space.key, index);
            match half_space.kernel.precision.unwrap() {
                Precision::Single => history::<f32>(half_space, rng, tally),
                Precision::Double => history::<f64>(half_space, rng, tally),
            }
        }
    }

    const PRECISIONS: [Precision; 2] = [Precision::Single, Precision::Double];

    /// Side by side or one after the other, with or without vector instructions: the same photons.
    #[test]
    fn lanes_change_nothing() {
        let phase: Arc<dyn PhaseFunction> = Arc::new(HenyeyGreenstein::new(Asymmetry::new(0.85).unwrap()));
        for (omega, precision) in [1.0, 0.9].into_iter().flat_map(|omega| PRECISIONS.map(|of| (omega, of))) {
            for (incidence, photons) in [(Incidence::Diffuse, 5_000), (Incidence::beam(0.0).unwrap(), 7)] {
                let omega = SingleScatteringAlbedo::new(omega).unwrap();
                let medium = TraceMedium::full(phase.clone(), omega);
                let tau = vec![0.0, 0.5, 5.0, 16.0];
                let stop = Stop::Photons(photons);
                let request = TraceRequest { tau, incidence, stop, max_order: 3, seed: 5, stream: 2 };
                let empty = Tally::new(request.tau.len(), request.bins(), true);
                let mut tally = empty.clone();
                for instructions in [Instructions::Widest, Instructions::Avx2, Instructions::Portable] {
                    let kernel = Kernel { precision: Some(precision), instructions };
                    let half_space = HalfSpace::new(kernel, &medium, &request, &request.tau);
                    if tally == empty {
                        one_by_one(&half_space, photons, &mut tally);
                    }
                    let mut flock = empty.clone();
                    half_space.trace(0..photons, &mut flock, Control::default());
                    assert_eq!(flock, tally, "{kernel:?}");
                }
                let counts = tally.spread();
                assert!(counts.of(3, Quantity::Transmittance(Order::Total)) > 0 || photons < 10);
            }
        }
    }

    /// Counts of 20 000 photons by `precision`, through a Henyey–Greenstein medium.
    fn counts(g: f64, precision: Precision) -> Vec<u64> {
        let phase = Arc::new(HenyeyGreenstein::new(Asymmetry::new(g).unwrap()));
        let medium = TraceMedium::full(phase, SingleScatteringAlbedo::CONSERVATIVE);
        let (tau, incidence) = (vec![0.5, 5.0, 16.0], Incidence::Diffuse);
        let request =
            TraceRequest { tau, incidence, stop: Stop::Photons(20_000), max_order: 3, seed: 5, stream: 2 };
        let kernel = Kernel { precision: Some(precision), ..Kernel::default() };
        let traced = trace_half_space_with(kernel, &medium, &request, Control::default()).unwrap();
        let quantities = |order| [Quantity::Reflectance(order), Quantity::Transmittance(order)];
        (0..3)
            .flat_map(|k| Order::rows(3).flat_map(quantities).map(move |quantity| (k, quantity)))
            .map(|(k, quantity)| traced.hits(k, quantity))
            .collect()
    }

    /// The same photons in single and double precision: at most 4 of 20 000 go elsewhere in any row. An asymmetry 0.001
    /// off is found out. `examples/precision_bias.rs` measures the bias.
    #[test]
    fn single_precision_follows_double() {
        let double = counts(0.85, Precision::Double);
        let far = |other: &[u64]| double.iter().zip(other).map(|(a, b)| a.abs_diff(*b)).max().unwrap();
        assert!(far(&counts(0.85, Precision::Single)) <= 4);
        assert!(far(&counts(0.849, Precision::Single)) > 4);
    }
}
