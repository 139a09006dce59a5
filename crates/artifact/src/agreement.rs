//! Whether the parameters of both sources agree: schema `stratiform/agreement/1` and `agreement.csv`.

use crate::Provenance;
use serde::{Deserialize, Serialize};

/// One parameter from both sources, per unit of optical thickness: a row of `agreement.csv`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct AgreementRow {
    /// Row of the table; `all` for β.
    pub theta_l_deg: String,
    /// `beta`, `b`, `c`, `kappa_c`, `t` or `r`.
    pub parameter: String,
    /// From the solver.
    pub solved: f64,
    /// Its estimated error; none where fixed or on a bound.
    pub solved_error: Option<f64>,
    /// From photons.
    pub traced: f64,
    /// Its standard error; none where fixed or on a bound.
    pub traced_std_error: Option<f64>,
    /// (solved - traced)/√(sum of both squared errors); none where unequal values claim no error.
    pub z: Option<f64>,
    /// Whether |z| is beyond the threshold, or there is none.
    pub differs: bool,
}

/// The document `agreement.json`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct AgreementDocument {
    /// `stratiform/agreement/1`.
    pub schema: String,
    /// How the photons' side was made.
    pub provenance: Provenance,
    /// Photons per incidence and medium.
    pub photons: u64,
    /// Probability that agreeing sources are said to differ.
    pub false_alarm_rate: f64,
    /// Parameters compared.
    pub comparisons: u64,
    /// |z| beyond which one differs.
    pub threshold: f64,
    /// Parameters that differ.
    pub differing: u64,
    /// The row with the largest |z|.
    pub worst: AgreementRow,
}

impl AgreementDocument {
    /// The schema's name and version.
    pub const SCHEMA: &'static str = "stratiform/agreement/1";

    /// Whether no parameter differs.
    pub fn agrees(&self) -> bool {
        self.differing == 0
    }
}

impl std::fmt::Display for AgreementDocument {
    /// One line for people.
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Self { comparisons, differing, threshold, worst, photons, .. } = self;
        let size = worst.z.map_or("without error".to_owned(), |z| format!("{:.2}", z.abs()));
        let place = format!("{} at {}", worst.parameter, worst.theta_l_deg);
        if self.agrees() {
            write!(f, "agreement: solver and {photons} photons agree in all {comparisons} parameters; ")?;
        } else {
            write!(
                f,
                "DISAGREEMENT: solver and {photons} photons differ in {differing} of {comparisons} parameters; "
            )?;
        }
        write!(f, "largest |z| {size} ({place}), threshold {threshold:.2}")
    }
}
