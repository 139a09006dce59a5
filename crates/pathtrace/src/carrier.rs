//! What a path carries of the three channels.
//!
//! The path is sampled for one channel h, drawn once. With a_c = Π P_c over its events, the density that some channel led to it is
//! the mean of the a_h, and a_c over that mean weighs channel c: the balance heuristic (Veach & Guibas 1995), at most 3.

use crate::light::mean;

/// The path's colour.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Carrier {
    /// The channel that is sampled.
    pub(crate) channel: usize,
    /// a_c over the mean of the three.
    pub(crate) ratio: [f64; 3],
}

impl Carrier {
    pub(crate) fn new(channel: usize) -> Self {
        Self { channel, ratio: [1.0; 3] }
    }

    /// One more event, with phase functions `p`. If all are 0 the path is over: it had no chance.
    #[inline]
    pub(crate) fn scatter(&mut self, p: [f64; 3]) {
        let product: [f64; 3] = std::array::from_fn(|c| self.ratio[c] * p[c]);
        let scale = 1.0 / mean(product);
        self.ratio = product.map(|a| a * scale);
    }
}
