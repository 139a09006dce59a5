//! Integer counts of one batch of photons.
//!
//! A photon that leaves through the top, or is absorbed, before its depth has passed H_k does so in every slab
//! from k on. Such events are counted once, at the first of them, and summed over k at the end
//! ([`Tally::spread`]).

use serde::{Deserialize, Serialize};
use stratiform_quantities::Order;
use stratiform_stats::Estimate;

/// What is known per thickness.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Quantity {
    /// Reflectance of an order.
    Reflectance(Order),
    /// Transmittance of an order.
    Transmittance(Order),
}

/// Counts per thickness and order bin. Bins are the orders 0…N and the tail; thicknesses ascend.
///
/// Sums saturate at 2⁶⁴ - 1, which [`TransportError::TooManyScatterings`](crate::TransportError) refuses: scatterings of 10¹² photons
/// at τ = 10⁶ come to 2·10¹⁸, a ninth of that.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Tally {
    /// Rows per thickness.
    pub(crate) bins: usize,
    /// Whether an end inside or above slab k is one of all thicker slabs too.
    pub(crate) nested: bool,
    /// Histories started.
    pub launched: u64,
    /// Photons that left through the top: bins inside thicknesses.
    pub reflected: Vec<u64>,
    /// Photons that left through the bottom: bins inside thicknesses.
    pub transmitted: Vec<u64>,
    /// Photons absorbed, per thickness.
    pub absorbed: Vec<u64>,
    /// Scatterings of photons that ended in or above each slab.
    pub turned: Vec<u64>,
    /// Scatterings of photons that passed each slab.
    pub passed: Vec<u64>,
}

impl Tally {
    pub(crate) fn new(thicknesses: usize, bins: usize, nested: bool) -> Self {
        Self {
            bins,
            nested,
            launched: 0,
            reflected: vec![0; thicknesses * bins],
            transmitted: vec![0; thicknesses * bins],
            absorbed: vec![0; thicknesses],
            turned: vec![0; thicknesses],
            passed: vec![0; thicknesses],
        }
    }

    #[inline]
    fn cell(&self, thickness: usize, order: u64) -> usize {
        thickness * self.bins + order.min(self.bins as u64 - 1) as usize
    }

    /// `photons` histories start.
    pub fn launch(&mut self, photons: u64) {
        self.launched += photons;
    }

    /// Adds a row of a ledger, and the photons that passed without a scattering.
    pub(crate) fn add_slab(&mut self, slab: usize, row: &[u64], unscattered: u64) {
        let (turned, rest) = row.split_at(self.bins);
        let (passed, rest) = rest.split_at(self.bins);
        let cells = slab * self.bins..(slab + 1) * self.bins;
        sum_into(&mut self.reflected[cells.clone()], turned);
        sum_into(&mut self.transmitted[cells.clone()], passed);
        sum_into(&mut self.transmitted[cells], &[unscattered]);
        let sums = [&mut self.absorbed[slab], &mut self.turned[slab], &mut self.passed[slab]];
        sums.into_iter().zip(rest).for_each(|(sum, count)| *sum = sum.saturating_add(*count));
    }

    /// A photon leaves through the bottom of slab `thickness` after `order` scatterings.
    #[inline]
    pub fn transmit(&mut self, thickness: usize, order: u64) {
        let cell = self.cell(thickness, order);
        self.transmitted[cell] += 1;
        self.passed[thickness] += order;
    }

    /// A photon leaves through the top of slab `first` (if nested, of every slab from there on) after `order` scatterings.
    #[inline]
    pub fn reflect(&mut self, first: usize, order: u64) {
        let cell = self.cell(first, order);
        self.reflected[cell] += 1;
        self.turned[first] += order;
    }

    /// A photon is absorbed in slab `first` (if nested, in every slab from there on) after `order` scatterings.
    #[inline]
    pub fn absorb(&mut self, first: usize, order: u64) {
        self.absorbed[first] += 1;
        self.turned[first] += order;
    }

    /// So many photons pass slab `thickness` after `order` scatterings, which are not counted.
    #[inline]
    pub(crate) fn pass(&mut self, thickness: usize, order: u64, photons: u64) {
        let cell = self.cell(thickness, order);
        self.transmitted[cell] += photons;
    }

    /// Adds photons of the tail: those that pass slab `slab`, and those that turn or are absorbed in it and not above.
    pub(crate) fn add_tail(&mut self, slab: usize, passed: u64, turned: u64, absorbed: u64) {
        let tail = self.cell(slab, u64::MAX);
        self.transmitted[tail] += passed;
        self.reflected[tail] += turned;
        self.absorbed[slab] += absorbed;
    }

    /// Adds the counts of other photons.
    pub(crate) fn add(&mut self, other: &Self) {
        self.launched = self.launched.saturating_add(other.launched);
        sum_into(&mut self.reflected, &other.reflected);
        sum_into(&mut self.transmitted, &other.transmitted);
        sum_into(&mut self.absorbed, &other.absorbed);
        sum_into(&mut self.turned, &other.turned);
        sum_into(&mut self.passed, &other.passed);
    }

    /// Whether every list has the length that goes with these numbers.
    pub(crate) fn has_shape(&self, thicknesses: usize, bins: usize) -> bool {
        self.bins == bins
            && [&self.reflected, &self.transmitted].iter().all(|list| list.len() == thicknesses * bins)
            && [&self.absorbed, &self.turned, &self.passed].iter().all(|list| list.len() == thicknesses)
    }

    /// Every number.
    pub(crate) fn words(&self) -> impl Iterator<Item = u64> {
        let lists = [&self.reflected, &self.transmitted, &self.absorbed, &self.turned, &self.passed];
        std::iter::once(self.launched).chain(lists.into_iter().flatten().copied())
    }

    /// Counts of each slab by itself.
    pub(crate) fn spread(&self) -> Counts {
        let upwards = |cells: &[u64], width| if self.nested { running(cells, width) } else { cells.to_vec() };
        let mut scatterings = upwards(&self.turned, 1);
        sum_into(&mut scatterings, &self.passed);
        Counts {
            bins: self.bins,
            launched: self.launched,
            reflected: upwards(&self.reflected, self.bins),
            transmitted: self.transmitted.clone(),
            absorbed: upwards(&self.absorbed, 1),
            scatterings,
        }
    }
}

fn sum_into(sum: &mut [u64], terms: &[u64]) {
    sum.iter_mut().zip(terms).for_each(|(a, b)| *a = a.saturating_add(*b));
}

/// Running sums over rows of `width` cells.
fn running(cells: &[u64], width: usize) -> Vec<u64> {
    let mut sums = cells.to_vec();
    for cell in width..sums.len() {
        sums[cell] = sums[cell].saturating_add(sums[cell - width]);
    }
    sums
}

/// Counts of each slab by itself, after all events are assigned.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Counts {
    bins: usize,
    pub launched: u64,
    reflected: Vec<u64>,
    transmitted: Vec<u64>,
    pub absorbed: Vec<u64>,
    pub scatterings: Vec<u64>,
}

impl Counts {
    /// Photons that make up `quantity` of slab `thickness`.
    pub fn of(&self, thickness: usize, quantity: Quantity) -> u64 {
        let (cells, order) = match quantity {
            Quantity::Reflectance(order) => (&self.reflected, order),
            Quantity::Transmittance(order) => (&self.transmitted, order),
        };
        let row = &cells[thickness * self.bins..(thickness + 1) * self.bins];
        match order {
            Order::Exactly(n) => row[..self.bins - 1].get(n as usize).copied().unwrap_or(0),
            Order::Tail => row[self.bins - 1],
            Order::Total => row.iter().fold(0, |sum, count| u64::saturating_add(sum, *count)),
        }
    }

    /// All photons of `batches`, of which there is at least one.
    pub fn sum(batches: &[Self]) -> Self {
        let mut sum = batches[0].clone();
        batches[1..].iter().for_each(|batch| sum.add(batch));
        sum
    }

    fn add(&mut self, other: &Self) {
        self.launched = self.launched.saturating_add(other.launched);
        sum_into(&mut self.reflected, &other.reflected);
        sum_into(&mut self.transmitted, &other.transmitted);
        sum_into(&mut self.absorbed, &other.absorbed);
        sum_into(&mut self.scatterings, &other.scatterings);
    }

    /// Largest standard error of any reflectance or transmittance of orders 0…`max_order`, tail and total.
    pub fn worst_error(&self, thicknesses: usize, max_order: u32) -> f64 {
        let mut worst = 0.0_f64;
        for thickness in 0..thicknesses {
            for order in Order::rows(max_order) {
                for quantity in [Quantity::Reflectance(order), Quantity::Transmittance(order)] {
                    let hits = self.of(thickness, quantity);
                    worst = worst.max(Estimate::from_hits(hits, self.launched).std_error);
                }
            }
        }
        worst
    }

    /// All photons of slab `thickness` that ended somewhere.
    pub fn ended(&self, thickness: usize) -> u64 {
        let total = |quantity| self.of(thickness, quantity);
        let left = total(Quantity::Reflectance(Order::Total));
        left.saturating_add(total(Quantity::Transmittance(Order::Total)))
            .saturating_add(self.absorbed[thickness])
    }
}
