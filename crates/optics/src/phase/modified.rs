//! Any phase function without its forward peak.
//!
//! P_S = P/(1-P_f) for Θ ≥ θ_f and 0 below, with P_f the probability of Θ < θ_f (Bouthors, Neyret & Lefebvre
//! 2006, section 4.1, with the inequality turned the right way round).

use super::{PhaseFunction, versine};
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
        let edge = versine(domain.check("modified (theta_f in degrees)", theta_f_deg)?.to_radians());
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

    fn values_at(&self, v: &mut [f64]) {
        let mut whole = v.to_vec();
        self.inner.values_at(&mut whole);
        let cut = |(v, p): (&mut f64, f64)| *v = if *v < self.edge { 0.0 } else { p / self.kept() };
        v.iter_mut().zip(whole).for_each(cut);
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

    /// The moments of the whole less those of the peak.
    fn moments(&self, count: usize) -> Vec<f64> {
        let (whole, peak) = (self.inner.moments(count), self.inner.peak_moments(self.edge, count));
        whole.iter().zip(&peak).map(|(whole, peak)| (whole - peak) / self.kept()).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::phase::{HenyeyGreenstein, Isotropic, Norm, PhaseTable};
    use stratiform_quantities::Asymmetry;

    /// Isotropic light without its forward 60°: P_f = 1/4, P_S = 4/3 for cosΘ ≤ 1/2, g_S = (4/3)·½∫_{-1}^{1/2} x dx = -1/4.
    #[test]
    fn isotropic_without_a_cap_is_a_closed_form() {
        let cut = Modified::new(Arc::new(Isotropic), 60.0).unwrap();
        assert!((cut.forward_fraction() - 0.25).abs() < 1e-15);
        assert!((cut.value(0.6) - 4.0 / 3.0).abs() < 1e-15 && cut.value(0.4) == 0.0);
        assert!((cut.asymmetry() + 0.25).abs() < 1e-14);
        // ½∫_{-1}^{1/2} P_l dx = [P_{l+1} - P_{l-1}](½)/(2(2l+1)): P_1 = ½, P_3 = -7/16.
        assert!((cut.moments(3)[2] - 4.0 / 3.0 * (-7.0 / 16.0 - 0.5) / 10.0).abs() < 1e-14);
    }

    /// A table cut as a function and cut as a table are the same, peaks within the first degrees included.
    #[test]
    fn a_table_has_the_moments_of_the_cut_table() {
        let hg = HenyeyGreenstein::new(Asymmetry::new(0.97).unwrap());
        let theta: Vec<f64> = (0..=1800).map(|i| 180.0 * libm::pow(f64::from(i) / 1800.0, 2.0)).collect();
        let p = theta.iter().map(|t| {
            let sine = libm::sin(0.5 * t.to_radians());
            hg.value(2.0 * sine * sine)
        });
        let table = PhaseTable::new(theta.clone(), p.collect(), Norm::Any).unwrap();
        let expected = table.modified(5.0).unwrap().moments(1500);
        let found = Modified::new(Arc::new(table), 5.0).unwrap().moments(1500);
        let worst = found.iter().zip(&expected).fold(0.0_f64, |worst, (a, b)| worst.max((a - b).abs()));
        assert!(worst < 1e-12, "{worst:e}");
    }

    /// The smooth function against its own inverse: the mean of P_1 over the variate, by many midpoints.
    #[test]
    fn a_narrow_peak_is_resolved() {
        let hg = HenyeyGreenstein::new(Asymmetry::new(0.9999).unwrap());
        let (edge, steps) = (2e-3, 200_000);
        let share = hg.cumulative(edge);
        let peak = hg.peak_moments(edge, 3);
        let mean = (0..steps).fold(0.0, |sum, i| {
            sum + hg.invert(share * (f64::from(i) + 0.5) / f64::from(steps)) / f64::from(steps)
        });
        assert!((peak[0] / share - 1.0).abs() < 1e-12, "{:e}", peak[0] / share - 1.0);
        assert!(((peak[0] - peak[1]) / (share * mean) - 1.0).abs() < 1e-6);
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
