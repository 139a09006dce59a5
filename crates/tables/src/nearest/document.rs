//! The approximations as rows of JSON or CSV.

use super::{Blend, Measured};
use crate::TablesError;
use serde::{Deserialize, Serialize};
use stratiform_artifact::{to_csv, to_json};

/// One approximation: P ≈ (1-w)·HG(g1) + w·Draine(g2, α). Errors are the approximation less the table; ratios the approximation
/// over the table.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct NearestRow {
    /// `henyey-greenstein`, `two-lobe`, `hg-draine`.
    pub family: String,
    /// `asymmetry`, `total-variation`, `log-least-squares`, `jendersie-deon-2023`.
    pub fitted_by: String,
    /// Droplet diameter of the closed form; empty for what was fitted.
    pub diameter_um: Option<f64>,
    /// Weight of the second lobe.
    pub w: f64,
    /// g of the first lobe.
    pub g1: f64,
    /// g of the second lobe.
    pub g2: f64,
    /// α of the second lobe.
    pub alpha: f64,
    /// Share of light sent into a wrong direction.
    pub total_variation: f64,
    /// Root mean square of the logarithm of the ratio, over the sphere.
    pub log_rms: f64,
    /// g.
    pub asymmetry: f64,
    /// Its error.
    pub asymmetry_error: f64,
    /// P_f.
    pub forward_fraction: f64,
    /// Its error.
    pub forward_fraction_error: f64,
    /// Share beyond 90°.
    pub backward_fraction: f64,
    /// Its error.
    pub backward_fraction_error: f64,
    /// At 0°; empty where the table is 0.
    pub forward_ratio: Option<f64>,
    /// At the fogbow; empty where the table has none.
    pub fogbow_ratio: Option<f64>,
    /// At 180°; empty where the table is 0.
    pub glory_ratio: Option<f64>,
}

impl NearestRow {
    pub(super) fn new(
        family: &str,
        fitted_by: &str,
        diameter_um: Option<f64>,
        blend: Blend,
        measured: &Measured,
    ) -> Self {
        let [asymmetry, asymmetry_error] = measured.asymmetry;
        let [forward_fraction, forward_fraction_error] = measured.forward_fraction;
        let [backward_fraction, backward_fraction_error] = measured.backward_fraction;
        Self {
            family: family.to_owned(),
            fitted_by: fitted_by.to_owned(),
            diameter_um,
            w: blend.w,
            g1: blend.g1,
            g2: blend.g2,
            alpha: blend.alpha,
            total_variation: measured.total_variation,
            log_rms: measured.log_rms,
            asymmetry,
            asymmetry_error,
            forward_fraction,
            forward_fraction_error,
            backward_fraction,
            backward_fraction_error,
            forward_ratio: measured.forward_ratio,
            fogbow_ratio: measured.fogbow_ratio,
            glory_ratio: measured.glory_ratio,
        }
    }

    /// The parameters.
    pub const fn blend(&self) -> Blend {
        Blend { w: self.w, g1: self.g1, g2: self.g2, alpha: self.alpha }
    }
}

/// Approximations of one phase function.
#[derive(Clone, Debug, PartialEq)]
pub struct NearestPhases {
    /// θ_f of P_f.
    pub theta_f_deg: f64,
    /// One each.
    pub rows: Vec<NearestRow>,
}

/// [`NearestPhases`] as a JSON document.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct NearestDocument {
    /// `stratiform/nearest-phases/1`.
    pub schema: String,
    /// The form that the parameters are those of.
    pub form: String,
    /// θ_f of P_f.
    pub theta_f_deg: f64,
    /// One each.
    pub rows: Vec<NearestRow>,
}

impl NearestPhases {
    /// As JSON text.
    ///
    /// # Errors
    /// [`TablesError`] if a number is not finite.
    pub fn to_json(&self) -> Result<String, TablesError> {
        Ok(to_json(&NearestDocument {
            schema: "stratiform/nearest-phases/1".to_owned(),
            form: "P = (1-w) HG(g1) + w Draine(g2, alpha), mean 1 over the sphere".to_owned(),
            theta_f_deg: self.theta_f_deg,
            rows: self.rows.clone(),
        })?)
    }

    /// As CSV text.
    ///
    /// # Errors
    /// [`TablesError`] if a number is not finite.
    pub fn to_csv(&self) -> Result<String, TablesError> {
        Ok(to_csv(&self.rows)?)
    }
}
