//! Reflectance and transmittance of each scattering order, by successive orders.
//!
//! The same diffusely lit problem as the totals: order 0 is e^{-t/μ}; each order's field is scattered
//! (kernel) and transported (grid) into the next, and its source function integrated towards any μ0 gives,
//! by reciprocity, R_n(μ0) and T_n(μ0) for all incidences at once. Chosen over the transform of totals at
//! complex ω: no complex eigenproblem, all orders keep their relative size, and orders 0–2 cost next to
//! nothing.
//!
//! Light that was scattered n times does not reach a depth of n + 12√n + 40 (Poisson tail below 1e-13):
//! thicker slabs are cut there.

use super::grid::{Collocation, doublings};
use super::kernel::{Kernel, Towards};
use super::panel::Panel;
use super::product::product;
use super::quadrature::Streams;
use super::slab::Pair;
use super::sweep::{Mixed, Sweep};
use std::sync::OnceLock;

/// What one number of streams needs for orders in any slab.
pub(crate) struct Orders<'a> {
    pub(crate) streams: &'a Streams,
    lights: &'a [Light],
    /// Cosines of the beams among the lights.
    beams: Vec<f64>,
    between: Kernels,
    towards_beams: Kernels,
    collocation: Collocation,
    /// Panels that slabs share, each made for the first that has it.
    doublings: Vec<(f64, OnceLock<Panel>)>,
    max_order: usize,
}

/// An incidence, with the kernel into it.
pub(crate) enum Light {
    Diffuse,
    Beam(f64, Towards),
}

/// ½ω times the even and the odd kernel, a row of `width` directions for each stream.
pub(crate) struct Kernels {
    even: Vec<f64>,
    odd: Vec<f64>,
    shape: (usize, usize),
}

impl Kernels {
    /// From the elements of row `stream` and column `direction`.
    fn new(shape: (usize, usize), omega: f64, of: impl Fn(usize, usize) -> (f64, f64)) -> Self {
        let places = (0..shape.0).flat_map(|stream| (0..shape.1).map(move |direction| (stream, direction)));
        let scaled = |(even, odd)| (0.5 * omega * even, 0.5 * omega * odd);
        let (even, odd) = places.map(|(stream, direction)| scaled(of(stream, direction))).unzip();
        Self { even, odd, shape }
    }

    /// Even and odd parts of the sources from sums and differences of radiances.
    pub(crate) fn of(&self, sum: &[f64], difference: &[f64]) -> [Vec<f64>; 2] {
        [product(sum, &self.even, self.shape), product(difference, &self.odd, self.shape)]
    }
}

impl<'a> Orders<'a> {
    pub(crate) fn new(
        kernel: &Kernel,
        streams: &'a Streams,
        intervals: usize,
        omega: f64,
        lights: &'a [Light],
        max_order: usize,
    ) -> Self {
        let count = streams.count();
        let (even, odd) = kernel.between(streams);
        let (beams, into): (Vec<f64>, Vec<&Towards>) = lights
            .iter()
            .filter_map(|light| match light {
                Light::Diffuse => None,
                Light::Beam(mu0, towards) => Some((*mu0, towards)),
            })
            .unzip();
        Self {
            between: Kernels::new((count, count), omega, |i, j| (even[(i, j)], odd[(i, j)])),
            towards_beams: Kernels::new((count, into.len()), omega, |i, k| (into[k].even[i], into[k].odd[i])),
            collocation: Collocation::new(intervals),
            doublings: doublings(streams.mu[count - 1]).map(|width| (width, OnceLock::new())).collect(),
            streams,
            lights,
            beams,
            max_order,
        }
    }

    pub(crate) fn intervals(&self) -> usize {
        self.collocation.intervals()
    }

    pub(crate) fn smallest_mu(&self) -> f64 {
        self.streams.mu[self.streams.count() - 1]
    }

    /// A panel of any width.
    pub(crate) fn panel(&self, width: f64) -> Panel {
        Panel::new(&self.collocation, width, &self.streams.mu, &self.beams)
    }

    /// Panel `k` of those that double in width.
    pub(crate) fn doubling(&self, k: usize) -> &Panel {
        let (width, panel) = &self.doublings[k];
        panel.get_or_init(|| self.panel(*width))
    }

    /// Orders 0…N of a slab, a list for each light.
    pub(crate) fn of_slab(&self, tau: f64) -> Vec<Vec<Pair>> {
        let mut lists: Vec<Vec<Pair>> =
            self.lights.iter().map(|light| vec![self.unscattered(tau, light)]).collect();
        let n = self.max_order as f64;
        let deepest = n + 12.0 * n.sqrt() + 40.0;
        if tau == 0.0 {
            lists.iter_mut().for_each(|list| list.resize(self.max_order + 1, NOTHING));
            return lists;
        }
        let sweep = Sweep::new(self, tau.min(deepest));
        let mut field = sweep.unscattered();
        for order in 1..=self.max_order {
            let before = Mixed::new(&field);
            let mut along = sweep.along(&before.scattered(&self.towards_beams)).into_iter();
            if order < self.max_order || self.beams.len() < self.lights.len() {
                field = sweep.transport(&before.scattered(&self.between));
            }
            for (list, light) in lists.iter_mut().zip(self.lights) {
                let pair = match light {
                    Light::Beam(..) => along.next().unwrap_or(NOTHING),
                    Light::Diffuse => sweep.fluxes(&field),
                };
                let transmittance = if tau > deepest { 0.0 } else { pair.transmittance };
                list.push(Pair { transmittance, ..pair });
            }
        }
        lists
    }

    fn unscattered(&self, tau: f64, light: &Light) -> Pair {
        let streams = self.streams;
        let transmittance = match light {
            _ if tau == 0.0 => 1.0,
            Light::Beam(mu0, _) => libm::exp(-tau / mu0),
            Light::Diffuse => streams
                .mu
                .iter()
                .zip(&streams.weight)
                .fold(0.0, |sum, (mu, w)| sum + 2.0 * w * mu * libm::exp(-tau / mu)),
        };
        Pair { reflectance: 0.0, transmittance }
    }
}

const NOTHING: Pair = Pair { reflectance: 0.0, transmittance: 0.0 };
