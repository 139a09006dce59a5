//! The answer.

use super::view::RadianceOrder;
use stratiform_stats::Estimate;

/// Reflectance factors πL/(μ0F0), unscattered light left out, with estimated absolute errors (in `std_error`).
#[derive(Clone, Debug, PartialEq)]
pub struct Radiances {
    pub(super) suns: usize,
    pub(super) views: usize,
    /// A list for each order solved: thicknesses outside, suns, views inside.
    pub(super) orders: Vec<Vec<Estimate>>,
    pub(super) streams: usize,
}

impl Radiances {
    /// The radiance of `order`.
    ///
    /// # Panics
    /// If an index is out of bounds or the order was not asked for.
    pub fn estimate(
        &self,
        tau_index: usize,
        mu0_index: usize,
        view_index: usize,
        order: RadianceOrder,
    ) -> Estimate {
        self.orders[order as usize][(tau_index * self.suns + mu0_index) * self.views + view_index]
    }

    /// Streams per hemisphere that were needed; 0 where no total was asked for.
    pub fn streams(&self) -> usize {
        self.streams
    }

    /// Largest estimated error of any row.
    pub fn worst_error(&self) -> f64 {
        self.orders.iter().flatten().fold(0.0, |worst, estimate| worst.max(estimate.std_error))
    }
}
