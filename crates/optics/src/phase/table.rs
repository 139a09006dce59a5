//! A phase function tabulated over Θ: piecewise linear in Θ between its nodes, and normalised.
//!
//! Every user of a table (tracer, solver, shaders) shares this definition. A repeated node is a jump: the first of
//! the two values belongs to the left, the second to the right and to the node itself. The cumulative is the closed
//! form of [`cell`](super::cell), its inversion exact to rounding.

use super::cell::Cell;
use super::chords::Chords;
use super::guide::Guide;
use super::{PhaseFunction, angle, linear, versine};
use crate::OpticsError;
use stratiform_quantities::Range;

/// How far ½∫P sinΘ dΘ of a table may be from 1.
pub const NORM: Range = Range::closed(0.999, 1.001);

/// P at nodes Θ from 0° to 180°.
#[derive(Clone, Debug, PartialEq)]
pub struct PhaseTable {
    theta_deg: Vec<f64>,
    theta: Vec<f64>,
    p: Vec<f64>,
    /// ½∫P sinΘ dΘ up to each node; the last is 1.
    cumulative: Vec<f64>,
    /// To the right of each node but the last; flat at a jump.
    pieces: Vec<Cell>,
    /// Where the cells of an angle and of a probability are.
    guides: [Guide; 2],
    /// The same P by half chords.
    chords: Chords,
}

/// What to do with a table whose norm is not 1 to 1e-3.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Norm {
    /// Refuse it.
    #[default]
    Strict,
    /// Divide by the norm whatever it is.
    Any,
}

impl PhaseTable {
    /// The table with values `p` at `theta_deg`, divided by its norm.
    ///
    /// # Errors
    /// [`OpticsError::Table`] unless the angles run from 0 to 180 without decreasing and repeat at most twice, and
    /// every value is finite and not negative; [`OpticsError::NotNormalised`] as `norm` says.
    pub fn new(theta_deg: Vec<f64>, p: Vec<f64>, norm: Norm) -> Result<Self, OpticsError> {
        check(&theta_deg, &p).map_err(|(row, message)| match row {
            Some(row) => OpticsError::Table(format!("row {}: {message}", row + 1)),
            None => OpticsError::Table(message),
        })?;
        let theta: Vec<f64> = theta_deg.iter().map(|t| t.to_radians()).collect();
        let guides = [Guide::new(&theta), Guide::new(&theta)];
        let (cumulative, pieces) = (vec![0.0; theta.len()], Vec::new());
        let chords = Chords::default();
        let mut table = Self { theta_deg, theta, p, cumulative, pieces, guides, chords };
        let integral = table.accumulate();
        if !(integral.is_finite() && integral > 0.0) || (norm == Norm::Strict && !NORM.contains(integral)) {
            return Err(OpticsError::NotNormalised { norm: integral });
        }
        table.divide_by(integral);
        table.guides[1] = Guide::new(&table.cumulative);
        table.chords = Chords::new(table.cells());
        Ok(table)
    }

    /// Fills the pieces, and the cumulative with the partial integrals, and returns the last.
    fn accumulate(&mut self) -> f64 {
        self.pieces = (0..self.theta.len() - 1).map(|i| self.piece(i)).collect();
        let mut sum = 0.0;
        for i in 1..self.theta.len() {
            sum += 0.5 * self.cell(i - 1).integral(self.width(i - 1));
            self.cumulative[i] = sum;
        }
        sum
    }

    /// Values that are normalised to rounding stay as they are, so that a table read back is the table written.
    fn divide_by(&mut self, norm: f64) {
        if (norm - 1.0).abs() > 1e-12 {
            self.p.iter_mut().for_each(|p| *p /= norm);
        }
        let rest = self.accumulate();
        self.cumulative.iter_mut().for_each(|f| *f = (*f / rest).min(1.0));
    }

    /// Θ of the nodes, degrees.
    pub fn theta_deg(&self) -> &[f64] {
        &self.theta_deg
    }

    /// Θ of the nodes, radians.
    pub fn theta_rad(&self) -> &[f64] {
        &self.theta
    }

    /// P at the nodes.
    pub fn values(&self) -> &[f64] {
        &self.p
    }

    /// P at Θ in radians.
    pub fn at(&self, theta: f64) -> f64 {
        let cell = self.cell(self.cell_of(theta));
        cell.value + cell.slope * (theta - cell.start)
    }

    /// Probability that the scattering angle is below `theta` radians.
    pub fn cumulative_at(&self, theta: f64) -> f64 {
        let i = self.cell_of(theta);
        let within = 0.5 * self.cell(i).integral((theta - self.theta[i]).clamp(0.0, self.width(i)));
        (self.cumulative[i] + within).min(1.0)
    }

    /// The Θ in radians below which the probability is `xi`.
    pub fn invert_theta(&self, xi: f64) -> f64 {
        let last = self.theta.len() - 2;
        let i = self.guides[1].place(&self.cumulative, xi).min(last);
        self.theta[i] + self.cell(i).invert(2.0 * (xi - self.cumulative[i]).max(0.0), self.width(i))
    }

    fn width(&self, i: usize) -> f64 {
        self.theta[i + 1] - self.theta[i]
    }

    /// The index of the cell that holds `theta`; at a node, the cell to its right.
    fn cell_of(&self, theta: f64) -> usize {
        let last = self.theta.len() - 2;
        let mut i = self.guides[0].place(&self.theta, theta).min(last);
        // Only the last node can have a jump to its right and hold the angle.
        while i == last && i > 0 && self.width(i) == 0.0 {
            i -= 1;
        }
        i
    }

    fn piece(&self, i: usize) -> Cell {
        let width = self.width(i);
        let slope = if width > 0.0 { (self.p[i + 1] - self.p[i]) / width } else { 0.0 };
        Cell { start: self.theta[i], value: self.p[i], slope }
    }

    fn cell(&self, i: usize) -> Cell {
        self.pieces[i]
    }

    pub(super) fn cells(&self) -> impl Iterator<Item = (Cell, f64)> {
        (0..self.theta.len() - 1).map(|i| (self.cell(i), self.width(i))).filter(|(_, width)| *width > 0.0)
    }
}

/// The first thing wrong with a table, and its row counted from 0.
pub(super) fn check(theta_deg: &[f64], p: &[f64]) -> Result<(), (Option<usize>, String)> {
    if theta_deg.len() != p.len() || theta_deg.len() < 2 {
        return Err((None, format!("{} angles with {} values are no table", theta_deg.len(), p.len())));
    }
    for (i, (&theta, &value)) in theta_deg.iter().zip(p).enumerate() {
        if !Range::closed(0.0, 180.0).contains(theta) {
            return Err((Some(i), format!("theta_deg = {theta} is outside [0, 180]")));
        }
        if !Range::at_least(0.0).contains(value) {
            return Err((Some(i), format!("p = {value} is outside [0, infinity)")));
        }
        if i > 0 && theta < theta_deg[i - 1] {
            return Err((Some(i), format!("theta_deg = {theta} is below the row before")));
        }
        if i > 1 && theta == theta_deg[i - 2] {
            return Err((Some(i), format!("theta_deg = {theta} stands a third time")));
        }
    }
    let (first, last) = (theta_deg[0], theta_deg[theta_deg.len() - 1]);
    if first != 0.0 || last != 180.0 {
        return Err((None, format!("theta_deg runs from {first} to {last}, not from 0 to 180")));
    }
    Ok(())
}

impl PhaseFunction for PhaseTable {
    fn value(&self, v: f64) -> f64 {
        self.at(angle(v))
    }

    fn values_at(&self, v: &mut [f64]) {
        self.chords.values_at(v);
    }

    fn cumulative(&self, v: f64) -> f64 {
        self.cumulative_at(angle(v))
    }

    fn invert(&self, xi: f64) -> f64 {
        versine(self.invert_theta(xi))
    }

    fn asymmetry(&self) -> f64 {
        self.cells().fold(0.0, |sum, (cell, width)| sum + 0.5 * cell.cosine_integral(width))
    }

    fn moments(&self, count: usize) -> Vec<f64> {
        linear::moments(self, count)
    }

    fn peak_moments(&self, edge: f64, count: usize) -> Vec<f64> {
        linear::below(self, angle(edge), count)
    }
}
