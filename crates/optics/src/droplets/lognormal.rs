//! n(r) = e^{-(ln r/r_0)²/2σ²}/(√(2π) σ r): r_e = r_0 e^{5σ²/2}, v_e = e^{σ²} - 1, ⟨r^k⟩ = r_0^k e^{k²σ²/2}.

use super::RADIUS_UM;
use crate::OpticsError;
use std::f64::consts::PI;
use stratiform_quantities::Range;

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Lognormal {
    median: f64,
    sigma: f64,
}

impl Lognormal {
    pub(super) fn new(
        effective_radius: Option<f64>,
        median_radius: Option<f64>,
        sigma: Option<f64>,
        effective_variance: Option<f64>,
    ) -> Result<Self, OpticsError> {
        let sigma = match (sigma, effective_variance) {
            (Some(sigma), None) => Range::closed(1e-3, 1.5).check("sigma", sigma)?,
            (None, Some(v)) => libm::log1p(Range::closed(1e-6, 8.0).check("effective_variance", v)?).sqrt(),
            _ => return Err(one_of("`sigma` and `effective_variance`")),
        };
        let median = match (effective_radius, median_radius) {
            (Some(r), None) => RADIUS_UM.check("effective_radius_um", r)? * libm::exp(-2.5 * sigma * sigma),
            (None, Some(r)) => RADIUS_UM.check("median_radius_um", r)?,
            _ => return Err(one_of("`effective_radius_um` and `median_radius_um`")),
        };
        Ok(Self { median, sigma })
    }

    pub(super) fn words(&self) -> String {
        format!("lognormal, median radius {} um, sigma = {}", self.median, self.sigma)
    }

    pub(super) fn density(&self, r: f64) -> f64 {
        if r <= 0.0 {
            return 0.0;
        }
        let t = libm::log(r / self.median) / self.sigma;
        libm::exp(-0.5 * t * t) / ((2.0 * PI).sqrt() * self.sigma * r)
    }

    pub(super) fn moment(&self, k: u32) -> f64 {
        let k = f64::from(k);
        libm::exp(k * libm::log(self.median) + 0.5 * k * k * self.sigma * self.sigma)
    }
}

fn one_of(keys: &str) -> OpticsError {
    OpticsError::Config(format!("a lognormal distribution takes exactly one of {keys}"))
}
