//! The result of a trace that follows photons through their first scatterings only.

use crate::{Quantity, Traced};
use stratiform_quantities::Order;
use stratiform_stats::Estimate;

/// Fluxes of the orders 0…N. What becomes of light that is scattered more often is not known: neither tail nor total.
#[derive(Clone, Debug, PartialEq)]
pub struct FirstOrders(Traced);

impl FirstOrders {
    /// Of photons whose further scatterings were counted as absorptions.
    pub(crate) fn new(traced: Traced) -> Self {
        Self(traced)
    }

    /// Optical thicknesses of the full medium, in the order of the request.
    pub fn tau(&self) -> &[f64] {
        self.0.tau()
    }

    /// Histories traced.
    pub fn photons(&self) -> u64 {
        self.0.photons()
    }

    /// N.
    pub fn max_order(&self) -> u32 {
        self.0.max_order()
    }

    /// Reflectance and transmittance of `order` at thickness `tau_index`; none for what is not known.
    ///
    /// # Panics
    /// If `tau_index` is not below the number of thicknesses.
    pub fn estimate(&self, tau_index: usize, order: Order) -> Option<(Estimate, Estimate)> {
        self.knows(order).then(|| self.0.estimate(tau_index, order))
    }

    /// Covariances as [`Traced::covariance`] has them; none if one of `quantities` is not known.
    ///
    /// # Panics
    /// If a thickness index is not below the number of thicknesses.
    pub fn covariance(&self, quantities: &[(usize, Quantity)]) -> Option<Vec<Vec<f64>>> {
        let known = |(_, quantity): &(usize, Quantity)| match quantity {
            Quantity::Reflectance(order) | Quantity::Transmittance(order) => self.knows(*order),
        };
        quantities.iter().all(known).then(|| self.0.covariance(quantities))
    }

    fn knows(&self, order: Order) -> bool {
        matches!(order, Order::Exactly(n) if n <= self.max_order())
    }
}
