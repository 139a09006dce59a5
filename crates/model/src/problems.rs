//! Values that no flux can have, named instead of clamped.

use crate::{Fluxes, Real};
use std::fmt;

/// A flux outside \[0, 1\].
#[derive(Clone, Debug, PartialEq)]
pub struct Problem {
    /// Field of [`Fluxes`].
    pub quantity: &'static str,
    /// Its value.
    pub value: f64,
}

impl fmt::Display for Problem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} = {} is outside [0, 1]", self.quantity, self.value)
    }
}

/// Every flux that lies outside \[0, 1\], among them negative T_3+ and R_3+.
pub fn problems<F: Real>(fluxes: &Fluxes<F>) -> Vec<Problem> {
    let named =
        fluxes.named().into_iter().map(|(quantity, value)| Problem { quantity, value: value.to_f64() });
    named.filter(|problem| !(0.0..=1.0).contains(&problem.value)).collect()
}
