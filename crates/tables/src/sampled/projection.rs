//! The texels whose look-up is nearest to a table: least squares over the sphere.
//!
//! With hat functions h_i of the coordinate the values solve Σ_j M_ij v_j = ½∫h_i P sinΘ dΘ, M_ij = ½∫h_i h_j sinΘ dΘ:
//! a tridiagonal system. Since Σh_i = 1 the look-up has the table's integral. Next to a jump least squares would
//! swing below 0. There M is lumped: a cell's off-diagonal entries go to the diagonal, which keeps the integral, and
//! if no cell couples makes each value an average of P. Cells beside a jump are lumped from the start, those
//! beside a negative value until there is none.

use super::Quadrature;
use crate::tridiagonal;
use stratiform_optics::phase::PhaseTable;
use stratiform_quantities::angle_map::place;

/// ½∫ over each cell, between texel i and i+1.
#[derive(Clone, Copy, Default)]
struct Cell {
    /// h_i², h_i h_{i+1}, h_{i+1}².
    mass: [f64; 3],
    /// h_i P, h_{i+1} P.
    load: [f64; 2],
    lumped: bool,
}

/// The values.
pub(super) fn nearest(table: &PhaseTable, quadrature: &Quadrature, texels: usize) -> Vec<f64> {
    let mut cells = integrate(table, quadrature, texels);
    for pair in table.theta_deg().windows(2).filter(|pair| pair[0] == pair[1]) {
        let (cell, share) = place(pair[0], texels);
        lump(&mut cells, cell.saturating_sub(1)..=cell + 1);
        if share == 0.0 {
            lump(&mut cells, cell.saturating_sub(2)..=cell);
        }
    }
    loop {
        let values = solve(&cells);
        let negative: Vec<usize> = (0..texels).filter(|&i| values[i] < 0.0).collect();
        let before = cells.iter().filter(|cell| cell.lumped).count();
        for i in negative {
            lump(&mut cells, i.saturating_sub(1)..=i);
        }
        if cells.iter().filter(|cell| cell.lumped).count() == before {
            return values.into_iter().map(|value| value.max(0.0)).collect();
        }
    }
}

fn lump(cells: &mut [Cell], range: std::ops::RangeInclusive<usize>) {
    for i in range {
        if let Some(cell) = cells.get_mut(i) {
            cell.lumped = true;
        }
    }
}

fn integrate(table: &PhaseTable, quadrature: &Quadrature, texels: usize) -> Vec<Cell> {
    let mut cells = vec![Cell::default(); texels - 1];
    for &(theta_deg, weight) in &quadrature.points {
        let (i, right) = place(theta_deg, texels);
        let (left, p) = (1.0 - right, table.at(theta_deg.to_radians()));
        let cell = &mut cells[i];
        cell.mass[0] += weight * left * left;
        cell.mass[1] += weight * left * right;
        cell.mass[2] += weight * right * right;
        cell.load[0] += weight * left * p;
        cell.load[1] += weight * right * p;
    }
    cells
}

/// The values that fulfil the system of `cells`.
fn solve(cells: &[Cell]) -> Vec<f64> {
    let count = cells.len() + 1;
    let (mut diagonal, mut values) = (vec![0.0; count], vec![0.0; count]);
    let mut beside = vec![0.0; cells.len()];
    for (i, cell) in cells.iter().enumerate() {
        let [left, off, right] = cell.mass;
        let moved = if cell.lumped { off } else { 0.0 };
        diagonal[i] += left + moved;
        diagonal[i + 1] += right + moved;
        beside[i] = off - moved;
        values[i] += cell.load[0];
        values[i + 1] += cell.load[1];
    }
    tridiagonal::solve(diagonal, &beside, values)
}
