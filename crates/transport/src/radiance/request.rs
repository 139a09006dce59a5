//! What radiance is traced for.

use crate::{PHOTONS, TraceMedium, TransportError};
use stratiform_quantities::{CosZenith, OpticalThickness, Order};

/// Largest number of views (or bins of both faces) times orders in one trace.
pub const MAX_CELLS: usize = 1 << 14;

/// One slab, one sun.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RadianceRequest {
    /// Optical thickness of the full medium; 0 is allowed.
    pub tau: f64,
    /// Cosine of the sun's zenith angle, in \[0, 1\]; 0 is a limit.
    pub mu0: f64,
    /// Histories, 2…2⁴⁸.
    pub photons: u64,
    /// Largest order listed by itself; later ones form the tail.
    pub max_order: u32,
    /// Seed of every random stream.
    pub seed: u64,
    /// Tells slabs, media and suns of one run apart, so that they share no random numbers.
    pub stream: u32,
}

impl RadianceRequest {
    /// Checks every number, with `places` views or bins.
    pub(super) fn check(&self, places: usize) -> Result<(), TransportError> {
        OpticalThickness::new(self.tau)?;
        CosZenith::new(self.mu0)?;
        PHOTONS.check("photons", self.photons as f64)?;
        let orders = self.rows();
        if places.saturating_mul(orders) > MAX_CELLS {
            return Err(TransportError::TooManyCells { places, orders, max: MAX_CELLS });
        }
        Ok(())
    }

    /// Depth of the lower face in `medium`.
    pub(super) fn bottom(&self, medium: &TraceMedium) -> f64 {
        self.tau * medium.extinction()
    }

    /// Orders 1…N, tail, total.
    pub(super) fn rows(&self) -> usize {
        self.max_order as usize + 2
    }

    /// Row of light scattered `order` times, at least once.
    pub(super) fn row(&self, order: u64) -> usize {
        (order.min(u64::from(self.max_order) + 1) - 1) as usize
    }
}

/// Row of `order` among 1…N, tail, total.
///
/// # Panics
/// For order 0 and those beyond N.
pub(super) fn row_of(order: Order, max_order: u32) -> usize {
    match order {
        Order::Exactly(n) => {
            assert!((1..=max_order).contains(&n), "order {n} was not traced by itself");
            n as usize - 1
        }
        Order::Tail => max_order as usize,
        Order::Total => max_order as usize + 1,
    }
}

/// Rows of a result: 1…N, tail, total.
pub(super) fn orders(max_order: u32) -> impl Iterator<Item = Order> + use<> {
    Order::rows(max_order).skip(1)
}
