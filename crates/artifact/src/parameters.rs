//! The fitted parameters of the one-dimensional model: schema `stratiform/parameters/1` and `parameters.csv`.

use crate::Provenance;
use serde::{Deserialize, Serialize};
use stratiform_quantities::ExtinctionConvention;
use stratiform_stats::Estimate;

/// The medium the parameters belong to.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct MediumRecord {
    /// Wavelength of the transport, µm.
    pub wavelength_um: f64,
    /// Which κ turns metres into optical thickness.
    pub extinction_convention: ExtinctionConvention,
    /// That κ of the full medium, 1/m.
    pub extinction_per_m: f64,
    /// ω of the full medium.
    pub single_scattering_albedo: f64,
    /// g of the full medium.
    pub asymmetry: f64,
    /// θ_f in degrees.
    pub theta_f_deg: f64,
    /// P_f.
    pub forward_fraction: f64,
}

/// Incidence of a row: degrees, or `"diffuse"`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(untagged)]
pub enum RowIncidence {
    /// θ_l in degrees.
    Degrees(f64),
    /// The word `diffuse`.
    Word(String),
}

impl RowIncidence {
    /// The row of hemispheric light.
    pub fn diffuse() -> Self {
        Self::Word("diffuse".to_owned())
    }

    /// θ_l, unless diffuse.
    pub fn degrees(&self) -> Option<f64> {
        match self {
            Self::Degrees(degrees) => Some(*degrees),
            Self::Word(_) => None,
        }
    }
}

impl std::fmt::Display for RowIncidence {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Degrees(degrees) => write!(f, "{degrees}"),
            Self::Word(word) => f.write_str(word),
        }
    }
}

/// One fitted number.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct FittedParameter {
    /// The fitted value; `null` where the data do not determine it.
    pub value: Option<f64>,
    /// Its standard error, or estimated error, from the reference's covariance (sandwich); `null` where fixed, on a bound or
    /// undetermined.
    pub std_error: Option<f64>,
    /// What emitted code uses: the fitted value, or where there is none one continuous in θ_l.
    pub emitted: f64,
}

/// Remarks on a row that a user must see.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Flag {
    /// b is so near 1 that c has no influence.
    CNotIdentifiable,
    /// b sits on a bound of the fit.
    BOnBound,
    /// c sits on a bound of the fit.
    COnBound,
    /// κ_c sits on a bound of the fit.
    KappaCOnBound,
    /// t sits on a bound of the fit.
    TOnBound,
    /// r sits on a bound of the fit.
    ROnBound,
    /// β was taken from the other rows, because the form cannot fit here.
    BetaFixed,
    /// The fitted model's T_3+ falls below -1e-3 somewhere on the grid.
    NegativeT3Plus,
    /// The fitted model's R_3+ falls below -1e-3 somewhere on the grid.
    NegativeR3Plus,
    /// The fitted model leaves \[0, 1\] somewhere on the grid.
    OutsideUnitInterval,
    /// The optimiser stopped without converging.
    NotConverged,
}

impl std::fmt::Display for Flag {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Flag::CNotIdentifiable => "c-not-identifiable",
            Flag::BOnBound => "b-on-bound",
            Flag::COnBound => "c-on-bound",
            Flag::KappaCOnBound => "kappa-c-on-bound",
            Flag::TOnBound => "t-on-bound",
            Flag::ROnBound => "r-on-bound",
            Flag::BetaFixed => "beta-fixed",
            Flag::NegativeT3Plus => "negative-t3-plus",
            Flag::NegativeR3Plus => "negative-r3-plus",
            Flag::OutsideUnitInterval => "outside-unit-interval",
            Flag::NotConverged => "not-converged",
        })
    }
}

/// Model minus reference over the thickness grid.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Misfit {
    /// `t_ms`, `t_1`, `t_2`, `r_1`, `r_2`.
    pub quantity: String,
    /// Root mean square.
    pub rms: f64,
    /// Largest magnitude.
    pub max: f64,
    /// Thickness where it is largest (unit of the table).
    pub max_at: f64,
}

/// One angle.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ParameterRow {
    /// θ_l in degrees or `"diffuse"`.
    pub theta_l_deg: RowIncidence,
    /// b.
    pub b: FittedParameter,
    /// c, per unit of thickness of the table.
    pub c: FittedParameter,
    /// κ_c, per unit of thickness of the table.
    pub kappa_c: FittedParameter,
    /// t.
    pub t: FittedParameter,
    /// r.
    pub r: FittedParameter,
    /// Correlations of (b, c).
    pub correlation_b_c: Option<f64>,
    /// Correlations of (κ_c, t), (κ_c, r), (t, r).
    pub correlation_kappa_c_t_r: Option<[f64; 3]>,
    /// Misfit per quantity.
    pub misfit: Vec<Misfit>,
    /// Remarks.
    pub flags: Vec<Flag>,
    /// What stopped the fit of (b, c).
    pub stopped_multiple: String,
    /// What stopped the fit of (κ_c, t, r).
    pub stopped_orders: String,
}

/// The whole table in one unit of thickness.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ParameterTable {
    /// β = T_ms at thickness 1 (1 m, or τ = 1).
    pub beta: Estimate,
    /// κ_S per unit of thickness: (1 - ωP_f)κ, or 1 - ωP_f.
    pub kappa_s: f64,
    /// One row per angle, then diffuse.
    pub rows: Vec<ParameterRow>,
}

/// The document `parameters.json`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ParametersDocument {
    /// `stratiform/parameters/1`.
    pub schema: String,
    /// How it was made.
    pub provenance: Provenance,
    /// What it is for.
    pub medium: MediumRecord,
    /// Smallest and largest thickness of the fit, metres.
    pub thickness_range_m: [f64; 2],
    /// Thickness in metres: valid for `medium.extinction_per_m` only.
    pub metres: ParameterTable,
    /// Thickness as optical thickness of the full medium: valid for every droplet number.
    pub optical: ParameterTable,
}

impl ParametersDocument {
    /// The schema's name and version.
    pub const SCHEMA: &'static str = "stratiform/parameters/1";

    /// The table in metres as rows of `parameters.csv`.
    pub fn csv_rows(&self) -> Vec<ParametersCsvRow> {
        self.metres.rows.iter().map(ParameterRow::csv).collect()
    }
}

impl ParameterRow {
    /// The flags' names, separated by spaces.
    pub fn flag_names(&self) -> String {
        self.flags.iter().map(Flag::to_string).collect::<Vec<_>>().join(" ")
    }

    fn csv(&self) -> ParametersCsvRow {
        ParametersCsvRow {
            theta_l_deg: self.theta_l_deg.to_string(),
            b: self.b.value,
            b_std_error: self.b.std_error,
            c_per_m: self.c.value,
            c_per_m_std_error: self.c.std_error,
            kappa_c_per_m: self.kappa_c.value,
            kappa_c_per_m_std_error: self.kappa_c.std_error,
            t: self.t.value,
            t_std_error: self.t.std_error,
            r: self.r.value,
            r_std_error: self.r.std_error,
            flags: self.flag_names(),
        }
    }
}

/// A row of `parameters.csv`. What is not identifiable is empty.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[expect(missing_docs, reason = "the columns are those of the table above")]
pub struct ParametersCsvRow {
    pub theta_l_deg: String,
    pub b: Option<f64>,
    pub b_std_error: Option<f64>,
    pub c_per_m: Option<f64>,
    pub c_per_m_std_error: Option<f64>,
    pub kappa_c_per_m: Option<f64>,
    pub kappa_c_per_m_std_error: Option<f64>,
    pub t: Option<f64>,
    pub t_std_error: Option<f64>,
    pub r: Option<f64>,
    pub r_std_error: Option<f64>,
    pub flags: String,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn flags_are_written_as_they_are_serialised() {
        for flag in [
            Flag::CNotIdentifiable,
            Flag::BOnBound,
            Flag::COnBound,
            Flag::KappaCOnBound,
            Flag::TOnBound,
            Flag::ROnBound,
            Flag::BetaFixed,
            Flag::NegativeT3Plus,
            Flag::NegativeR3Plus,
            Flag::OutsideUnitInterval,
            Flag::NotConverged,
        ] {
            assert_eq!(serde_json::to_value(flag).unwrap(), flag.to_string());
        }
    }
}
