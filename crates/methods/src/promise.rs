//! How far a method promises to be from the truth, and where.

use crate::{Cloud, Domain, FluxPoint, Point};
use stratiform_model::angular::Sight;
use stratiform_quantities::{Range, Side};
use stratiform_stats::Estimate;

/// |value - truth| ≤ `relative`·truth + `absolute` + `sigmas`·(the value's own standard error), the truth being that of the full
/// medium. Bounds are round numbers above what was measured.
#[derive(Clone, Debug, PartialEq)]
pub struct Promise {
    /// Where, a part of the method's domain.
    pub within: Domain,
    /// Light that left below: only at scattering angles above this, in degrees.
    pub aureole_deg: f64,
    /// Share of the truth.
    pub relative: f64,
    /// Reflectance factor, or share of the incident flux.
    pub absolute: f64,
    /// Standard errors.
    pub sigmas: f64,
}

impl Promise {
    /// A share of the truth.
    pub fn relative(relative: f64, within: Domain) -> Self {
        Self { within, aureole_deg: 0.0, relative, absolute: 0.0, sigmas: 0.0 }
    }

    /// The same everywhere.
    pub fn absolute(absolute: f64, within: Domain) -> Self {
        Self { absolute, ..Self::relative(0.0, within) }
    }

    /// Noise alone.
    pub fn sigmas(sigmas: f64, within: Domain) -> Self {
        Self { sigmas, ..Self::relative(0.0, within) }
    }

    /// The same but for light scattered by less than an angle.
    #[must_use]
    pub fn outside_aureole(self, aureole_deg: f64) -> Self {
        Self { aureole_deg, ..self }
    }

    /// Whether the promise covers a radiance.
    pub fn covers(&self, cloud: &Cloud, point: &Point) -> bool {
        let narrow = || {
            let sight = Sight::new(point.mu_l, point.mu_v, point.phi_deg, point.side);
            let edge = 1.0 - libm::cos(self.aureole_deg.to_radians());
            point.side == Side::Bottom && sight.is_ok_and(|sight| sight.v < edge)
        };
        self.within.check_cloud(cloud).is_ok() && self.within.check(point).is_ok() && !narrow()
    }

    /// Whether the promise covers a flux.
    pub fn covers_flux(&self, cloud: &Cloud, point: &FluxPoint) -> bool {
        self.within.check_cloud(cloud).is_ok() && self.within.check_flux(point).is_ok()
    }

    /// Whether a value keeps it; the truth's own error counts for the method.
    pub fn is_kept(&self, value: Estimate, truth: Estimate) -> bool {
        let allowed = self.relative * truth.value.abs() + self.absolute + self.sigmas * value.std_error;
        (value.value - truth.value).abs() <= allowed + truth.std_error
    }
}

impl std::fmt::Display for Promise {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let parts = [
            (self.relative, format!("{} % of the truth", 100.0 * self.relative)),
            (self.absolute, format!("{}", self.absolute)),
            (self.sigmas, format!("{} standard errors", self.sigmas)),
        ];
        let said: Vec<String> =
            parts.into_iter().filter(|(size, _)| *size > 0.0).map(|(_, text)| text).collect();
        let Domain { tau, mu_l, mu_v, omega, r_eff_um } = &self.within;
        write!(f, "within {}: tau {tau}, mu_l {mu_l}, mu_v {mu_v}", said.join(" + "))?;
        write!(f, ", omega {omega}, r_eff_um {r_eff_um}")?;
        if self.aureole_deg > 0.0 {
            write!(f, ", below from {} deg off the beam", self.aureole_deg)?;
        }
        Ok(())
    }
}

/// What a method promises of each quantity; of `None` only that values are finite and not negative.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Promises {
    /// Of radiances.
    pub radiance: Option<Promise>,
    /// Of R and T.
    pub flux: Option<Promise>,
}

/// Slabs of this optical thickness, sun and view at these cosines or higher.
pub(crate) fn region(tau: [f64; 2], lowest_mu: f64) -> Domain {
    let mu = Range { min_included: lowest_mu > 0.0, ..Range::closed(lowest_mu, 1.0) };
    Domain { tau: Range::closed(tau[0], tau[1]), mu_l: mu, mu_v: mu, ..Domain::EVERYWHERE }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_truths_own_error_counts_for_the_method() {
        let promise = Promise::relative(0.1, Domain::EVERYWHERE);
        let of = |value, std_error| Estimate { value, std_error };
        assert!(
            promise.is_kept(of(1.09, 0.0), of(1.0, 0.0)) && !promise.is_kept(of(1.11, 0.0), of(1.0, 0.0))
        );
        assert!(promise.is_kept(of(1.11, 0.0), of(1.0, 0.02)));
        assert!(!promise.is_kept(of(1.3, 0.1), of(1.0, 0.0)));
        assert!(Promise::sigmas(4.0, Domain::EVERYWHERE).is_kept(of(1.3, 0.1), of(1.0, 0.0)));
        assert!(!promise.is_kept(of(f64::NAN, 0.0), of(1.0, 0.0)));
    }
}
