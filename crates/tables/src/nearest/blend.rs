//! P = (1-w)·HG(g1) + w·Draine(g2, α), as parameters and as a phase function.

use serde::{Deserialize, Serialize};
use stratiform_optics::phase::{Draine, PhaseFunction};
use stratiform_quantities::{Asymmetry, DomainError, Range};

/// Parameters of a blend; w is the weight of the second lobe.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Blend {
    /// Weight of Draine's function, in \[0, 1\].
    pub w: f64,
    /// Asymmetry parameter of the Henyey–Greenstein function.
    pub g1: f64,
    /// Parameter g of Draine's function (its asymmetry parameter if α = 0).
    pub g2: f64,
    /// α of Draine's function; 0 makes it Henyey and Greenstein's.
    pub alpha: f64,
}

impl Blend {
    /// One Henyey–Greenstein function.
    pub const fn henyey_greenstein(g: f64) -> Self {
        Self { w: 0.0, g1: g, g2: 0.0, alpha: 0.0 }
    }

    /// (1-w)·HG(g1) + w·HG(g2).
    pub const fn two_lobe(w: f64, g1: f64, g2: f64) -> Self {
        Self { w, g1, g2, alpha: 0.0 }
    }

    /// The phase function.
    ///
    /// # Errors
    /// [`DomainError`] unless 0 ≤ w ≤ 1, both g in (-1, 1) and 0 ≤ α ≤ 1e3.
    pub fn phase(&self) -> Result<BlendPhase, DomainError> {
        let w = Range::closed(0.0, 1.0).check("w", self.w)?;
        let first = Draine::new(Asymmetry::new(self.g1)?, 0.0)?;
        let second = Draine::new(Asymmetry::new(self.g2)?, self.alpha)?;
        Ok(BlendPhase { lobes: [(1.0 - w, first), (w, second)] })
    }
}

/// The phase function of a [`Blend`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BlendPhase {
    lobes: [(f64, Draine); 2],
}

impl BlendPhase {
    fn sum(&self, of: impl Fn(&Draine) -> f64) -> f64 {
        self.lobes.iter().filter(|(w, _)| *w > 0.0).fold(0.0, |sum, (w, lobe)| sum + w * of(lobe))
    }
}

impl PhaseFunction for BlendPhase {
    fn value(&self, v: f64) -> f64 {
        self.sum(|lobe| lobe.value(v))
    }

    fn cumulative(&self, v: f64) -> f64 {
        self.sum(|lobe| lobe.cumulative(v))
    }

    /// The lobes' own inverses bracket it; bisection, in √v, where the peak is wide.
    fn invert(&self, xi: f64) -> f64 {
        let used = self.lobes.iter().filter(|(w, _)| *w > 0.0).map(|(_, lobe)| lobe.invert(xi).sqrt());
        let (mut low, mut high) = used.fold((f64::INFINITY, 0.0_f64), |(a, b), v| (a.min(v), b.max(v)));
        while high - low > 4.0 * f64::EPSILON * high {
            let middle = 0.5 * (low + high);
            if self.cumulative(middle * middle) > xi {
                high = middle;
            } else {
                low = middle;
            }
        }
        (high * high).min(2.0)
    }

    fn asymmetry(&self) -> f64 {
        self.sum(PhaseFunction::asymmetry)
    }

    fn moments(&self, count: usize) -> Vec<f64> {
        let [(w1, first), (w2, second)] = &self.lobes;
        let both = first.moments(count).into_iter().zip(second.moments(count));
        both.map(|(a, b)| w1 * a + w2 * b).collect()
    }
}
