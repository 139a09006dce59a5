//! What emitted code uses of `parameters.json`, as values of the crate `model`.

use stratiform_artifact::{ParameterRow, ParameterTable};
use stratiform_model::Values;
use stratiform_model::table::Angle;

/// Of one row.
pub(crate) fn values(table: &ParameterTable, row: &ParameterRow) -> Values<f64> {
    Values {
        beta: table.beta.value,
        b: row.b.emitted,
        c: row.c.emitted,
        kappa_c: row.kappa_c.emitted,
        t: row.t.emitted,
        r: row.r.emitted,
        kappa_s: table.kappa_s,
    }
}

/// Of the rows that hold for an angle.
pub(crate) fn angles(table: &ParameterTable) -> Vec<Angle> {
    let angle = |row: &ParameterRow| {
        row.theta_l_deg.degrees().map(|theta_l_deg| Angle { theta_l_deg, values: values(table, row) })
    };
    table.rows.iter().filter_map(angle).collect()
}
