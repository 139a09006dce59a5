//! The fitted parameters of the one-dimensional model as a table to load: b, c, κ_c, t, r at each θ_l, thickness as
//! optical thickness τ of the full medium.
//!
//! Between rows b, t, 1/c, 1/κ_c and 1/r are linear in μ_l = cosθ_l, as in emitted code. Textures hold these five, so that
//! a linear filter gives that rule: with μ_i > μ_l ≥ μ_{i+1} and w = (μ_i - μ_l)/(μ_i - μ_{i+1}) the texture coordinate
//! is (i + w + ½)/count (hardware rounds w to 1/256; for more digits fetch both texels and mix). The last row is
//! diffuse light: no filter may reach it, so μ_l never exceeds the row before. Its μ_l is written as -1.

use crate::TablesError;
use serde::{Deserialize, Serialize};
use stratiform_artifact::{MediumRecord, ParametersDocument, Provenance};
use stratiform_quantities::Range;

/// What a texture holds of a row, in order.
pub const COLUMNS: [&str; 6] = ["mu_l", "b", "inverse_c", "t", "inverse_kappa_c", "inverse_r"];

/// A row of the table.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ParameterValues {
    /// θ_l in degrees; none for diffuse light.
    pub theta_l_deg: Option<f64>,
    /// cosθ_l; -1 for diffuse light.
    pub mu_l: f64,
    /// b.
    pub b: f64,
    /// c, per unit of τ.
    pub c: f64,
    /// κ_c, per unit of τ.
    pub kappa_c: f64,
    /// t.
    pub t: f64,
    /// r.
    pub r: f64,
}

impl ParameterValues {
    /// [`COLUMNS`] of the row.
    pub fn columns(&self) -> [f64; 6] {
        [self.mu_l, self.b, 1.0 / self.c, self.t, 1.0 / self.kappa_c, 1.0 / self.r]
    }
}

/// What stands beside the rows.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ParameterMetadata {
    /// `stratiform/parameter-table/1`.
    pub schema: String,
    /// What thickness is measured in.
    pub units: String,
    /// How rows are interpolated.
    pub interpolation: String,
    /// What the last row is.
    pub last_row: String,
    /// T_ms in words.
    pub formula: String,
    /// T_ms at τ = 1.
    pub beta: f64,
    /// (1 - β)/β.
    pub slope: f64,
    /// κ_S per unit of τ.
    pub kappa_s: f64,
    /// τ of the fit, smallest and largest.
    pub fitted_tau: [f64; 2],
    /// What the parameters are for.
    pub medium: MediumRecord,
    /// How they were made.
    pub provenance: Provenance,
}

impl ParameterMetadata {
    /// The schema's name and version.
    pub const SCHEMA: &'static str = "stratiform/parameter-table/1";

    fn new(document: &ParametersDocument) -> Self {
        let (optical, medium) = (&document.optical, document.medium.clone());
        let words = |text: &str| text.to_owned();
        Self {
            schema: Self::SCHEMA.to_owned(),
            units: words(
                "thickness is the optical thickness tau of the full medium; c and kappa_c per unit of tau",
            ),
            interpolation: words(
                "b, t, 1/c, 1/kappa_c and 1/r linear in mu_l = cos(theta_l) between rows i and i+1, w = (mu_i - mu_l)/(mu_i - \
                 mu_(i+1)); as a texture of `count` columns, linear filter at (i + w + 0.5)/count",
            ),
            last_row: words("diffuse light, mu_l = -1; not to be filtered with the others"),
            formula: words(
                "T_ms = (b + (1 - b) exp(-c tau))/(1 + slope tau), slope = (1 - beta)/beta; T_0 = exp(-kappa_s tau/mu_l)",
            ),
            beta: optical.beta.value,
            slope: (1.0 - optical.beta.value) / optical.beta.value,
            kappa_s: optical.kappa_s,
            fitted_tau: document.thickness_range_m.map(|metres| metres * medium.extinction_per_m),
            medium,
            provenance: document.provenance.clone(),
        }
    }
}

/// Angles in rising θ_l, then diffuse light.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ParameterTexels {
    /// Units, rule, medium.
    pub metadata: ParameterMetadata,
    /// The rows.
    pub rows: Vec<ParameterValues>,
}

impl ParameterTexels {
    /// What emitted code uses of `document`, in optical thickness.
    ///
    /// # Errors
    /// [`TablesError::Domain`] for numbers that are not finite, or c, κ_c or r not above 0; [`TablesError::Parameters`]
    /// unless angles rise and one diffuse row comes last.
    pub fn new(document: &ParametersDocument) -> Result<Self, TablesError> {
        let rows = document.optical.rows.iter().map(|row| {
            let theta_l_deg = row.theta_l_deg.degrees();
            let values = ParameterValues {
                theta_l_deg,
                mu_l: theta_l_deg.map_or(-1.0, cos_zenith),
                b: row.b.emitted,
                c: row.c.emitted,
                kappa_c: row.kappa_c.emitted,
                t: row.t.emitted,
                r: row.r.emitted,
            };
            check(&values)
        });
        let rows = rows.collect::<Result<Vec<_>, _>>()?;
        check_order(&rows)?;
        Ok(Self { metadata: ParameterMetadata::new(document), rows })
    }
}

/// cosθ_l; exactly 0 at 90°.
fn cos_zenith(theta_l_deg: f64) -> f64 {
    if theta_l_deg == 90.0 { 0.0 } else { libm::cos(theta_l_deg.to_radians()) }
}

fn check(values: &ParameterValues) -> Result<ParameterValues, TablesError> {
    let finite = Range::closed(-f64::MAX, f64::MAX);
    if let Some(theta_l_deg) = values.theta_l_deg {
        Range::closed(0.0, 90.0).check("theta_l_deg", theta_l_deg)?;
    }
    finite.check("b", values.b)?;
    finite.check("t", values.t)?;
    for (name, value) in [("c", values.c), ("kappa_c", values.kappa_c), ("r", values.r)] {
        Range::above(0.0).check(name, value)?;
    }
    Ok(*values)
}

fn check_order(rows: &[ParameterValues]) -> Result<(), TablesError> {
    let refuse = |reason: &str| Err(TablesError::Parameters { reason: reason.to_owned() });
    let Some((last, angles)) = rows.split_last() else { return refuse("there are no rows") };
    if last.theta_l_deg.is_some() || angles.iter().any(|row| row.theta_l_deg.is_none()) {
        return refuse("the last row, and no other, must be `diffuse`");
    }
    if angles.len() < 2 || angles.windows(2).any(|pair| pair[0].theta_l_deg >= pair[1].theta_l_deg) {
        return refuse("theta_l_deg must rise over two rows or more");
    }
    Ok(())
}
