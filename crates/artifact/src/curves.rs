//! `curves.csv` and `published.csv`: model curves and a published parameter table, ready to be drawn.

use serde::{Deserialize, Serialize};

/// What a curve of the one-dimensional model shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum CurveQuantity {
    /// All transmitted light.
    TMs,
    /// All reflected light.
    RMs,
    /// Unscattered light.
    #[serde(rename = "t_0")]
    T0,
    /// Transmitted after one wide event.
    #[serde(rename = "t_1")]
    T1,
    /// Transmitted after two.
    #[serde(rename = "t_2")]
    T2,
    /// Transmitted after three or more.
    #[serde(rename = "t_3_plus")]
    T3Plus,
    /// Reflected after one wide event.
    #[serde(rename = "r_1")]
    R1,
    /// Reflected after two.
    #[serde(rename = "r_2")]
    R2,
    /// Reflected after three or more.
    #[serde(rename = "r_3_plus")]
    R3Plus,
}

/// Which parameters a curve was computed from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum CurveModel {
    /// Those of the published table.
    Published,
    /// Those of `parameters.json`.
    Fitted,
}

/// One point of a model curve: a row of `curves.csv`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct CurvesRow {
    /// Incidence angle in degrees.
    pub theta_l_deg: f64,
    /// Thickness in metres.
    pub thickness_m: f64,
    /// What.
    pub quantity: CurveQuantity,
    /// From which parameters.
    pub model: CurveModel,
    /// Flux per incident flux. Differences of fits may be negative.
    pub value: f64,
}

/// One angle of a published parameter table: a row of `published.csv`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PublishedRow {
    /// Incidence angle in degrees.
    pub theta_l_deg: f64,
    /// b.
    pub b: f64,
    /// c per metre.
    pub c_per_m: f64,
    /// κ_c per metre.
    pub kappa_c_per_m: f64,
    /// t.
    pub t: f64,
    /// r.
    pub r: f64,
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{read_csv, write_csv};

    #[test]
    fn curves_round_trip_through_csv() {
        let dir = tempfile::tempdir().unwrap();
        let path = dir.path().join("curves.csv");
        let rows: Vec<CurvesRow> = [CurveQuantity::TMs, CurveQuantity::T0, CurveQuantity::R3Plus]
            .into_iter()
            .flat_map(|quantity| [CurveModel::Published, CurveModel::Fitted].map(|model| (quantity, model)))
            .map(|(quantity, model)| CurvesRow {
                theta_l_deg: 80.0,
                thickness_m: 0.1 + 0.2,
                quantity,
                model,
                value: -0.032,
            })
            .collect();
        write_csv(&path, &rows).unwrap();
        assert_eq!(read_csv::<CurvesRow>(&path).unwrap(), rows);
        let text = crate::read_text(&path).unwrap();
        assert!(text.starts_with("theta_l_deg,thickness_m,quantity,model,value\n"));
        for word in ["t_ms,published", "t_0,fitted", "r_3_plus,fitted"] {
            assert!(text.contains(word), "{word} in {text}");
        }
    }
}
