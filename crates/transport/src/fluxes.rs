//! The result of a trace that counts fluxes alone.

use crate::{Quantity, Traced};
use stratiform_quantities::Order;
use stratiform_stats::Estimate;

/// How far photons are followed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Extent {
    /// Until they leave.
    ToTheEnd,
    /// To the last order that is listed by itself. What becomes of light that is scattered more often is not known: neither tail nor
    /// total.
    ListedOrders,
}

/// Reflectance and transmittance, without the number of scatterings: that of a slab is known only if each photon is looked at
/// when it passes the bottom, which costs time, the more slabs the more.
#[derive(Clone, Debug, PartialEq)]
pub struct Fluxes {
    traced: Traced,
    extent: Extent,
}

impl Fluxes {
    /// Of photons whose scatterings past `extent` were counted as absorptions.
    pub(crate) fn new(traced: Traced, extent: Extent) -> Self {
        Self { traced, extent }
    }

    /// Optical thicknesses of the full medium, in the order of the request.
    pub fn tau(&self) -> &[f64] {
        self.traced.tau()
    }

    /// Histories traced.
    pub fn photons(&self) -> u64 {
        self.traced.photons()
    }

    /// The rows that are known: orders 0…N; tail and total unless photons were left.
    pub fn orders(&self) -> Vec<Order> {
        self.traced.orders().filter(|order| self.knows(*order)).collect()
    }

    /// Reflectance and transmittance of `order` at thickness `tau_index`; none for what is not known.
    ///
    /// # Panics
    /// If `tau_index` is not below the number of thicknesses.
    pub fn estimate(&self, tau_index: usize, order: Order) -> Option<(Estimate, Estimate)> {
        self.knows(order).then(|| self.traced.estimate(tau_index, order))
    }

    /// Covariances as [`Traced::covariance`] has them; none if one of `quantities` is not known.
    ///
    /// # Panics
    /// If a thickness index is not below the number of thicknesses.
    pub fn covariance(&self, quantities: &[(usize, Quantity)]) -> Option<Vec<Vec<f64>>> {
        let known = |(_, quantity): &(usize, Quantity)| match quantity {
            Quantity::Reflectance(order) | Quantity::Transmittance(order) => self.knows(*order),
        };
        quantities.iter().all(known).then(|| self.traced.covariance(quantities))
    }

    fn knows(&self, order: Order) -> bool {
        match order {
            Order::Exactly(n) => n <= self.traced.max_order(),
            Order::Tail | Order::Total => self.extent == Extent::ToTheEnd,
        }
    }
}
