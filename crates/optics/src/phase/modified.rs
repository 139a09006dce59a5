//! Any phase function without its forward peak.
//!
//! P_S = P/(1-P_f) for Θ ≥ θ_f and 0 below, with P_f the probability of Θ < θ_f (Bouthors, Neyret & Lefebvre
//! 2006, section 4.1, with the inequality turned the right way round).

use super::PhaseFunction;
use std::sync::Arc;
use stratiform_quantities::{DomainError, Range};

/// P_S of another function.
#[derive(Clone)]
pub struct Modified {
    inner: Arc<dyn PhaseFunction>,
    /// 1 - cosθ_f.
    edge: f64,
    forward_fraction: f64,
}

impl Modified {
    /// Cuts `inner` below `theta_f_deg`.
    ///
    /// # Errors
    /// [`DomainError`] unless 0 < θ_f ≤ 90° and P_f < 1.
    pub fn new(inner: Arc<dyn PhaseFunction>, theta_f_deg: f64) -> Result<Self, DomainError> {
        let domain = Range { min_included: false, ..Range::closed(0.0, 90.0) };
        let half = 0.5 * domain.check("modified (theta_f in degrees)", theta_f_deg)?.to_radians();
        let edge = 2.0 * libm::sin(half) * libm::sin(half);
        let share = Range { max_included: false, ..Range::closed(0.0, 1.0) };
        let forward_fraction = share.check("forward fraction", inner.cumulative(edge))?;
        Ok(Self { inner, edge, forward_fraction })
    }

    /// P_f of the function that was cut.
    pub fn forward_fraction(&self) -> f64 {
        self.forward_fraction
    }

    fn kept(&self) -> f64 {
        1.0 - self.forward_fraction
    }
}

impl PhaseFunction for Modified {
    fn value(&self, v: f64) -> f64 {
        if v < self.edge { 0.0 } else { self.inner.value(v) / self.kept() }
    }

    fn cumulative(&self, v: f64) -> f64 {
        if v <= self.edge { 0.0 } else { (self.inner.cumulative(v) - self.forward_fraction) / self.kept() }
    }

    fn invert(&self, xi: f64) -> f64 {
        self.inner.invert(self.forward_fraction + xi * self.kept()).max(self.edge)
    }

    fn asymmetry(&self) -> f64 {
        self.moments(2)[1]
    }

    /// The moments of the whole less those of the peak, the latter by the midpoint rule over the variate, which is
    /// exact to 1e-8 for smooth functions.
    fn moments(&self, count: usize) -> Vec<f64> {
        const STEPS: u32 = 4096;
        let mut peak = vec![0.0; count];
        for step in 0..STEPS {
            let xi = self.forward_fraction * (f64::from(step) + 0.5) / f64::from(STEPS);
            add_legendre(1.0 - self.inner.invert(xi), &mut peak);
        }
        let weight = self.forward_fraction / f64::from(STEPS);
        let whole = self.inner.moments(count);
        whole.iter().zip(&peak).map(|(whole, peak)| (whole - weight * peak) / self.kept()).collect()
    }
}

/// Adds P_0(x), P_1(x) … to `sums`.
fn add_legendre(x: f64, sums: &mut [f64]) {
    let (mut previous, mut current) = (0.0, 1.0);
    for (l, sum) in sums.iter_mut().enumerate() {
        *sum += current;
        let l = l as f64;
        (previous, current) = (current, ((2.0 * l + 1.0) * x * current - l * previous) / (l + 1.0));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::phase::{HenyeyGreenstein, Isotropic};
    use stratiform_quantities::Asymmetry;

    /// Isotropic light without its forward 60°: P_f = 1/4, P_S = 4/3 for cosΘ ≤ 1/2, g_S = (4/3)·½∫_{-1}^{1/2} x dx = -1/4.
    #[test]
    fn isotropic_without_a_cap_is_a_closed_form() {
        let cut = Modified::new(Arc::new(Isotropic), 60.0).unwrap();
        assert!((cut.forward_fraction() - 0.25).abs() < 1e-15);
        assert!((cut.value(0.6) - 4.0 / 3.0).abs() < 1e-15 && cut.value(0.4) == 0.0);
        assert!((cut.asymmetry() + 0.25).abs() < 1e-7);
    }

    #[test]
    fn nothing_is_sampled_below_the_edge() {
        let hg = HenyeyGreenstein::new(Asymmetry::new(0.9).unwrap());
        let cut = Modified::new(Arc::new(hg), 5.0).unwrap();
        for k in 0..1000 {
            let xi = f64::from(k) / 1000.0;
            let v = cut.invert(xi);
            assert!(v >= cut.edge && (cut.cumulative(v) - xi).abs() < 1e-12, "xi {xi}, v {v}");
        }
    }

    #[test]
    fn angles_out_of_domain_are_refused() {
        for theta in [0.0, -5.0, 90.5, f64::NAN] {
            assert!(Modified::new(Arc::new(Isotropic), theta).is_err(), "{theta}");
        }
    }
}
