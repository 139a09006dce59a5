//! The phase functions: source tables, and the same on the angle map of the look-up.

use crate::{CodegenError, Inputs, PhaseRow};
use serde::Serialize;
use stratiform_artifact::to_csv;
use stratiform_quantities::angle_map::angle_deg;

/// Values of each function on the warped grid.
pub const COUNT: usize = 1024;

#[derive(Serialize)]
pub(crate) struct WarpedRow {
    index: usize,
    theta_deg: f64,
    pub p: f64,
    pub p_squared: f64,
}

/// A table at Θ, linear between rows.
fn at(rows: &[PhaseRow], theta_deg: f64) -> f64 {
    let i = rows.partition_point(|row| row.theta_deg <= theta_deg).clamp(1, rows.len() - 1);
    let (a, b) = (rows[i - 1], rows[i]);
    if b.theta_deg <= a.theta_deg {
        return b.p;
    }
    a.p + (b.p - a.p) * ((theta_deg - a.theta_deg) / (b.theta_deg - a.theta_deg))
}

/// The functions on the angle map.
pub(crate) fn warped(inputs: &Inputs) -> Vec<WarpedRow> {
    let row = |index: usize| {
        let theta_deg = angle_deg(index as f64 / (COUNT - 1) as f64);
        WarpedRow {
            index,
            theta_deg,
            p: at(&inputs.phase.full, theta_deg),
            p_squared: at(&inputs.phase.squared, theta_deg),
        }
    };
    (0..COUNT).map(row).collect()
}

/// The four tables.
pub(crate) fn files(inputs: &Inputs) -> Result<Vec<(String, String)>, CodegenError> {
    Ok(vec![
        ("phase_full.csv".to_owned(), to_csv(&inputs.phase.full)?),
        ("phase_modified.csv".to_owned(), to_csv(&inputs.phase.modified)?),
        ("phase_squared.csv".to_owned(), to_csv(&inputs.phase.squared)?),
        ("phase_warped.csv".to_owned(), to_csv(&warped(inputs))?),
    ])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_table_is_linear_between_rows_and_may_jump() {
        let row = |theta_deg, p| PhaseRow { theta_deg, p };
        let rows = [row(0.0, 0.0), row(5.0, 0.0), row(5.0, 4.0), row(180.0, 1.0)];
        assert_eq!(
            (at(&rows, 0.0), at(&rows, 4.999), at(&rows, 5.0), at(&rows, 180.0)),
            (0.0, 0.0, 4.0, 1.0)
        );
        assert!((at(&rows, 92.5) - 2.5).abs() < 1e-15);
    }
}
