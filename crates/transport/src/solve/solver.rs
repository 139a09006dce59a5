//! Streams chosen for a tolerance: the ladder of stream counts is climbed until its rungs agree.
//!
//! The half-range rule converges algebraically (radiances have a μ ln μ at grazing), so the difference of
//! two rungs bounds the error of the upper one. The error reported is that difference, or a quarter of the
//! one before if that is larger (rungs may agree by chance), and what the neglected moments could add. The
//! first rungs agree by chance too often: no answer comes from fewer than 24 streams. In thin slabs the rungs
//! converge irregularly until they resolve μ ~ τ, and four times the difference is reported. A tolerance the
//! last rung does not meet is an error that says what was reached.

use super::kernel::Kernel;
use super::medium::SolveMedium;
use super::modes::Modes;
use super::orders::{Light, Orders};
use super::slab::{Direction, Pair, Slab};
use super::solved::Solved;
use crate::TransportError;
use rayon::prelude::*;
use std::borrow::Cow;
use std::sync::{Arc, OnceLock};
use stratiform_quantities::{Incidence, OpticalThickness, Order, Range};

/// Streams per hemisphere.
const LADDER: [usize; 8] = [12, 16, 24, 32, 48, 64, 96, 128];

/// Streams that the kernels serve; larger ones are prepared when they are first needed.
const SIZES: [usize; 2] = [64, 128];

/// Streams that can be asked for.
const STREAMS: Range = Range::closed(1.0, 128.0);

/// Numbers of orders listed.
const ORDERS: Range = Range::closed(0.0, 60.0);

/// Tolerances that double precision can meet.
const TOLERANCE: Range = Range { max_included: false, ..Range::closed(1e-12, 1.0) };

/// Slabs thinner than this converge irregularly.
const THIN: f64 = 0.1;

/// What rounding in the eigenproblem may leave in a flux.
const ROUNDING: f64 = 5e-13;

/// A medium with its scattering kernel, ready for any thicknesses and incidences.
#[derive(Clone)]
pub struct Solver {
    medium: SolveMedium,
    moments: Vec<f64>,
    /// What neglected moments could add.
    neglected: f64,
    tolerance: f64,
    kernels: Arc<[OnceLock<Kernel>; SIZES.len()]>,
    /// Of the ladder's rungs, kept because they serve every slab.
    modes: [OnceLock<Modes>; LADDER.len()],
}

impl Solver {
    /// Prepares moments and kernel for fluxes within `tolerance`, absolute.
    ///
    /// # Errors
    /// [`TransportError::Domain`] unless 1e-12 ≤ `tolerance` < 1.
    pub fn new(medium: SolveMedium, tolerance: f64) -> Result<Self, TransportError> {
        TOLERANCE.check("tolerance", tolerance)?;
        let (moments, neglected) = medium.moments(tolerance);
        let solver = Self {
            medium,
            moments,
            neglected,
            tolerance,
            kernels: Default::default(),
            modes: Default::default(),
        };
        solver.kernel(SIZES[0]);
        Ok(solver)
    }

    /// The smallest kernel that serves `count` streams.
    fn kernel(&self, count: usize) -> &Kernel {
        let place = SIZES.iter().take_while(|size| **size < count).count();
        self.kernels[place].get_or_init(|| Kernel::new(self.moments.clone(), SIZES[place]))
    }

    /// Prepares what solving with `streams` needs of the medium alone, 128 at most.
    pub fn prepare(&self, streams: usize) {
        self.kernel(streams.min(SIZES[SIZES.len() - 1]));
    }

    /// The medium.
    pub fn medium(&self) -> &SolveMedium {
        &self.medium
    }

    /// The same without the modes that were kept, for measuring what they cost.
    pub fn unsolved(&self) -> Self {
        Self { modes: Default::default(), ..self.clone() }
    }

    /// The modes for `count` streams.
    fn modes(&self, count: usize) -> Cow<'_, Modes> {
        let fresh = || Modes::new(self.kernel(count), count, self.medium.albedo);
        match LADDER.iter().position(|rung| *rung == count) {
            Some(place) => Cow::Borrowed(self.modes[place].get_or_init(fresh)),
            None => Cow::Owned(fresh()),
        }
    }

    /// Total reflectance and transmittance for every thickness and incidence.
    ///
    /// # Errors
    /// [`TransportError::Domain`] for τ, [`TransportError::NoThickness`], [`TransportError::NoIncidence`];
    /// [`TransportError::Tolerance`] if 128 streams do not suffice.
    pub fn totals(&self, tau: &[f64], incidence: &[Incidence]) -> Result<Solved, TransportError> {
        check(tau, incidence)?;
        let rows = |count: usize| {
            let modes = self.modes(count);
            self.rung(&modes, tau, &self.lights(&modes, incidence))
        };
        let solved = self.climb(rows, |row| self.caution(tau, row / 2))?;
        Ok(Solved::new(self, (tau, incidence), vec![Order::Total], solved))
    }

    /// Total reflectance and transmittance with `streams` per hemisphere, whatever their error: thicknesses
    /// inside incidences. For studies of convergence.
    ///
    /// # Errors
    /// [`TransportError::Domain`] for τ or unless 1 ≤ `streams` ≤ 128; [`TransportError::NoThickness`],
    /// [`TransportError::NoIncidence`].
    pub fn totals_with_streams(
        &self,
        streams: usize,
        tau: &[f64],
        incidence: &[Incidence],
    ) -> Result<Vec<(f64, f64)>, TransportError> {
        check(tau, incidence)?;
        STREAMS.check("streams", streams as f64)?;
        let modes = self.modes(streams);
        let values = self.rung(&modes, tau, &self.lights(&modes, incidence));
        Ok(values.chunks(2).map(|pair| (pair[0], pair[1])).collect())
    }

    /// Orders 0…`max_order`, tail and total for every thickness and incidence; the tail is the total less
    /// the orders.
    ///
    /// # Errors
    /// As for [`totals`](Self::totals), and [`TransportError::Domain`] for more than 60 orders.
    pub fn orders(
        &self,
        tau: &[f64],
        incidence: &[Incidence],
        max_order: u32,
    ) -> Result<Solved, TransportError> {
        check(tau, incidence)?;
        ORDERS.check("orders", f64::from(max_order))?;
        let rows = |count: usize| {
            let modes = self.modes(count);
            let lights = self.lights(&modes, incidence);
            let totals = self.rung(&modes, tau, &lights);
            let orders = self.order_rung(&modes, tau, &lights, max_order as usize);
            with_tails(&orders, &totals)
        };
        let listed: Vec<Order> = Order::rows(max_order).collect();
        let solved = self.climb(rows, |row| self.caution(tau, row / 2 / listed.len()))?;
        Ok(Solved::new(self, (tau, incidence), listed, solved))
    }

    /// How many times the usual error counts for the slab of row `place`, thicknesses inside incidences.
    fn caution(&self, tau: &[f64], place: usize) -> f64 {
        if tau[place % tau.len()] * self.medium.extinction < THIN { 4.0 } else { 1.0 }
    }

    /// Legendre moments used.
    pub fn moments(&self) -> &[f64] {
        &self.moments
    }

    /// Values with their errors, from the first rung that agrees with the one below; a row's error counts
    /// `caution` times.
    fn climb(
        &self,
        rung: impl Fn(usize) -> Vec<f64>,
        caution: impl Fn(usize) -> f64,
    ) -> Result<(Vec<(f64, f64)>, usize), TransportError> {
        let mut rungs: Vec<Vec<f64>> = Vec::new();
        let mut reached = f64::INFINITY;
        for count in LADDER {
            rungs.push(rung(count));
            let [.., first, second, third] = rungs.as_slice() else { continue };
            let errors: Vec<f64> =
                (0..third.len()).map(|i| caution(i) * self.error(first[i], second[i], third[i])).collect();
            let worst = errors.iter().fold(0.0_f64, |worst, error| worst.max(*error));
            if worst <= self.tolerance {
                return Ok((third.iter().copied().zip(errors).collect(), count));
            }
            reached = reached.min(worst);
        }
        let streams = LADDER[LADDER.len() - 1];
        Err(TransportError::Tolerance { wanted: self.tolerance, reached, streams, place: String::new() })
    }

    /// Estimated error of the last of three rungs. The step before counts too, lest two rungs agree by
    /// chance.
    fn error(&self, first: f64, second: f64, third: f64) -> f64 {
        let step = (third - second).abs().max(0.25 * (second - first).abs());
        if step == 0.0 {
            // The same on every rung: unscattered light, which no quadrature touches.
            return f64::EPSILON;
        }
        // A phase function that is no probability may break down: that is no answer.
        if third.is_finite() && step.is_finite() { step + self.neglected + ROUNDING } else { f64::INFINITY }
    }

    /// The incidences as the streams of `modes` see them.
    fn lights(&self, modes: &Modes, incidence: &[Incidence]) -> Vec<Light> {
        let kernel = self.kernel(modes.streams.count());
        let light = |incidence: &Incidence| match incidence {
            Incidence::Diffuse => Light::Diffuse,
            Incidence::Beam(mu0) => Light::Beam(mu0.get(), kernel.towards(mu0.get(), &modes.streams)),
        };
        incidence.iter().map(light).collect()
    }

    /// Orders with the streams of `modes`, a list for each incidence and thickness inside it.
    fn order_rung(&self, modes: &Modes, tau: &[f64], lights: &[Light], max_order: usize) -> Vec<Vec<Pair>> {
        let (streams, albedo) = (&modes.streams, self.medium.albedo);
        // Depth is refined along with angle, so that the ladder sees both errors.
        let intervals = 6 + LADDER.iter().take_while(|rung| **rung < streams.count()).count();
        let orders = Orders::new(self.kernel(streams.count()), streams, intervals, albedo, lights, max_order);
        let slabs: Vec<Vec<Vec<Pair>>> =
            tau.par_iter().map(|tau| orders.of_slab(tau * self.medium.extinction)).collect();
        (0..lights.len()).flat_map(|i| slabs.iter().map(move |slab| slab[i].clone())).collect()
    }

    /// R and T by `modes`: incidences outside, thicknesses inside.
    fn rung(&self, modes: &Modes, tau: &[f64], lights: &[Light]) -> Vec<f64> {
        let directions: Vec<Option<Direction>> = lights
            .iter()
            .map(|light| match light {
                Light::Diffuse => None,
                Light::Beam(mu0, towards) => {
                    let (sum, difference) = modes.towards(towards);
                    Some(Direction { mu0: *mu0, sum, difference })
                }
            })
            .collect();
        let slabs: Vec<Slab> = tau.iter().map(|tau| Slab::new(modes, tau * self.medium.extinction)).collect();
        let mut values = Vec::with_capacity(2 * tau.len() * lights.len());
        for direction in &directions {
            for slab in &slabs {
                let Pair { reflectance, transmittance } = direction
                    .as_ref()
                    .map_or_else(|| slab.lit_diffusely(), |direction| slab.lit_from(direction));
                values.extend([reflectance, transmittance]);
            }
        }
        values
    }
}

/// R and T of orders, tail and total, from lists of orders and totals.
fn with_tails(orders: &[Vec<Pair>], totals: &[f64]) -> Vec<f64> {
    let mut rows = Vec::new();
    for (orders, total) in orders.iter().zip(totals.chunks(2)) {
        let mut tail = [total[0], total[1]];
        for pair in orders {
            rows.extend([pair.reflectance, pair.transmittance]);
            tail[0] -= pair.reflectance;
            tail[1] -= pair.transmittance;
        }
        rows.extend(tail);
        rows.extend(total);
    }
    rows
}

fn check(tau: &[f64], incidence: &[Incidence]) -> Result<(), TransportError> {
    if tau.is_empty() {
        return Err(TransportError::NoThickness);
    }
    if incidence.is_empty() {
        return Err(TransportError::NoIncidence);
    }
    for &tau in tau {
        OpticalThickness::new(tau)?;
    }
    Ok(())
}
