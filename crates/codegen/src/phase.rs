//! The phase functions: source tables, the shader's warped grid, and its look-up.

use crate::text::{banner, fill, literal};
use crate::{CodegenError, Inputs, PhaseRow, error_card::spread};
use serde::Serialize;
use stratiform_artifact::to_csv;
use stratiform_quantities::angle_map::{angle_deg, coordinate};

/// Values of each function on the warped grid.
const COUNT: usize = 1024;

#[derive(Serialize)]
struct WarpedRow {
    index: usize,
    theta_deg: f64,
    p: f64,
    p_squared: f64,
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

fn warped(inputs: &Inputs) -> Vec<WarpedRow> {
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

/// The warped grid at Θ, linear in the coordinate.
fn looked_up(grid: &[f64], theta_deg: f64) -> f64 {
    let place = coordinate(theta_deg) * (COUNT - 1) as f64;
    let cell = (place as usize).min(COUNT - 2);
    grid[cell] + (grid[cell + 1] - grid[cell]) * (place - cell as f64)
}

/// Relative error of the grid at the rows of the table.
fn resampling(name: &str, rows: &[PhaseRow], grid: &[f64]) -> String {
    let errors = rows.iter().filter(|row| row.p > 0.0);
    let errors = errors.map(|row| (looked_up(grid, row.theta_deg) / row.p - 1.0).abs()).collect();
    spread(name, errors).map_or(String::new(), |card| {
        format!(
            "//   {name:<10} median {:.1e}, 95 % {:.1e}, worst {:.1e}\n",
            card.median, card.percentile_95, card.worst
        )
    })
}

fn module(inputs: &Inputs, grid: &[WarpedRow]) -> String {
    let medium = &inputs.parameters.medium;
    let sine = libm::sin(0.5 * medium.theta_f_deg.to_radians());
    let (p, squared): (Vec<_>, Vec<_>) = grid.iter().map(|row| (row.p, row.p_squared)).unzip();
    let places = [
        ("COUNT", COUNT.to_string()),
        ("WIDE_SCALE", literal(1.0 / (1.0 - medium.forward_fraction))),
        ("WIDE_EDGE", literal(2.0 * sine * sine)),
    ];
    banner(inputs, "Phase functions of the cloud, looked up in a storage buffer.")
        + "//\n\
           // Units      v = 1 - cosTheta, cosTheta = +1 is forward. Take v, not cosTheta, near the forward direction:\n\
           //            v = |a - b|^2 / 2 of two unit directions of flight keeps the digits that cosTheta loses.\n\
           // Norm       1/2 integral of P over cosTheta is 1; P/(4 pi) is the density per steradian.\n\
           // Domain     v in [0, 2].\n\
           // Grid's error relative to the tables at their own angles:\n"
        + &resampling("full", &inputs.phase.full, &p)
        + &resampling("squared", &inputs.phase.squared, &squared)
        + "\n"
        + &fill(include_str!("wgsl/phase.wgsl"), &places)
}

/// stratiform_phase.wgsl and the four tables.
pub(crate) fn files(inputs: &Inputs) -> Result<Vec<(String, String)>, CodegenError> {
    let grid = warped(inputs);
    Ok(vec![
        ("stratiform_phase.wgsl".to_owned(), module(inputs, &grid)),
        ("phase_full.csv".to_owned(), to_csv(&inputs.phase.full)?),
        ("phase_modified.csv".to_owned(), to_csv(&inputs.phase.modified)?),
        ("phase_squared.csv".to_owned(), to_csv(&inputs.phase.squared)?),
        ("phase_warped.csv".to_owned(), to_csv(&grid)?),
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
