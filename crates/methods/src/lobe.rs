//! Phase functions as a shader evaluates them, in either precision.

use crate::scalar::Scalar;

/// A phase function of v = 1 - cosΘ, mean 1 over the sphere.
pub trait Lobe<F>: Send + Sync {
    /// P at v.
    fn at(&self, v: F) -> F;
}

/// Henyey and Greenstein's function.
#[derive(Clone, Copy, Debug)]
pub struct Hg<F> {
    /// g.
    pub g: F,
}

/// (1-g²)/((1-g)² + 2gv)^{3/2} (Henyey & Greenstein 1941, eq. 2).
pub(crate) fn henyey_greenstein<F: Scalar>(g: F, v: F) -> F {
    let (one, two) = (F::of(1.0), F::of(2.0));
    let square = (one - g) * (one - g) + two * g * v;
    (one - g) * (one + g) / (square * square.sqrt())
}

impl<F: Scalar> Lobe<F> for Hg<F> {
    fn at(&self, v: F) -> F {
        henyey_greenstein(self.g, v)
    }
}
