//! `ladder.csv`: what each approximation between the solver and the emitted shader loses.

use serde::{Deserialize, Serialize};

/// One rung of the ladder, the set of its points, and one flux: a row of `ladder.csv`. A rung that could not be measured
/// is one row without numbers whose note says why.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct LadderRow {
    /// `solver`, `monte-carlo`, `model`, `f32`, `interpolation`, `shader`; `together` for all of them at once.
    pub rung: String,
    /// `to-80`: angles up to 80 degrees; `all`: those beyond and diffuse light too.
    pub angles: String,
    /// One of T_ms, T_0, T_1, T_2, T_3+, R_1, R_2, R_3+ as `t_ms`, `t_0` … `r_3_plus`.
    pub quantity: String,
    /// Root mean square of the difference from the rung before.
    pub rms: Option<f64>,
    /// Largest magnitude of that difference.
    pub worst: Option<f64>,
    /// Where: angle in degrees, or `diffuse`.
    pub worst_theta_l_deg: String,
    /// Where: optical thickness.
    pub worst_tau: Option<f64>,
    /// Number of points.
    pub points: u64,
    /// Root mean square that chance alone explains, where there is chance.
    pub expected_rms: Option<f64>,
    /// What measured it, or `not measured: ` and the reason.
    pub note: String,
}

impl LadderRow {
    /// The fluxes compared. R_ms is left out: it is 1 - T_ms on every rung.
    pub const QUANTITIES: [&str; 8] = ["t_ms", "t_0", "t_1", "t_2", "t_3_plus", "r_1", "r_2", "r_3_plus"];

    /// Angles up to 80 degrees.
    pub const TO_80: &str = "to-80";
    /// Every angle of the rung, and diffuse light where it has it.
    pub const ALL: &str = "all";
}
