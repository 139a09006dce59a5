//! The linear model r + J·s of the residuals at one point, and the steps it proposes inside the box.

use super::Bounds;
use super::trust_region::damped_step;
use crate::Matrix;
use crate::matrix::{dot, norm};
use crate::qr::PivotedQr;

/// Residuals and derivatives at `point`.
#[derive(Clone, Debug)]
pub(super) struct LinearModel {
    pub point: Vec<f64>,
    pub residuals: Vec<f64>,
    pub jacobian: Matrix,
    /// Jᵀr.
    pub gradient: Vec<f64>,
}

/// A step that stays in the box, and what the linear model expects of it.
#[derive(Clone, Debug)]
pub(super) struct Step {
    pub target: Vec<f64>,
    /// Length in the scaled norm.
    pub length: f64,
    /// Relative decrease of the sum of squares.
    pub predicted: f64,
    /// Jᵀr·s / |r|².
    pub slope: f64,
    /// Whether no trust radius shortened it.
    pub full: bool,
}

impl LinearModel {
    pub fn new(point: Vec<f64>, residuals: Vec<f64>, jacobian: Matrix) -> Self {
        let gradient = jacobian.transposed_times(&residuals);
        Self { point, residuals, jacobian, gradient }
    }

    /// The parameters that a descent may move.
    pub fn free(&self, bounds: &Bounds) -> Vec<usize> {
        (0..self.point.len()).filter(|&i| !bounds.blocks(i, self.point[i], self.gradient[i])).collect()
    }

    /// The largest cosine between the residuals and a free column; 0 for zero residuals.
    pub fn largest_cosine(&self, bounds: &Bounds) -> f64 {
        let length = norm(&self.residuals);
        self.free(bounds).into_iter().fold(0.0, |largest: f64, i| {
            let product = norm(self.jacobian.column(i)) * length;
            if product > 0.0 { largest.max(self.gradient[i].abs() / product) } else { largest }
        })
    }

    /// The step of least r + J·s inside the box, |scale·s| ≤ `radius`. On the way to the minimiser over the
    /// free variables the first one to meet its bound stops there and is fixed; then the rest is solved
    /// again. Each leg descends, so the whole step does.
    pub fn step(&self, bounds: &Bounds, scale: &[f64], radius: f64) -> Step {
        let mut free = self.free(bounds);
        let mut moved = vec![0.0; self.point.len()];
        let mut target = self.point.clone();
        let mut full = true;
        while !free.is_empty() && free.len() <= self.residuals.len() {
            let mut fixed = moved.clone();
            free.iter().for_each(|&i| fixed[i] = 0.0);
            let minus: Vec<f64> =
                self.jacobian.times(&fixed).iter().zip(&self.residuals).map(|(a, r)| -a - r).collect();
            let qr = PivotedQr::new(self.jacobian.scaled_columns(&free, |i| 1.0 / scale[i]));
            let damped = damped_step(&qr, &qr.project(&minus), radius);
            full &= damped.damping == 0.0;
            let goal: Vec<f64> = free.iter().zip(&damped.step).map(|(&i, s)| s / scale[i]).collect();
            let hit = self.first_hit(bounds, &free, &moved, &goal);
            let share = hit.map_or(1.0, |(_, share, _)| share);
            for (&i, goal) in free.iter().zip(&goal) {
                moved[i] += share * (goal - moved[i]);
                target[i] = self.point[i] + moved[i];
            }
            let Some((place, _, bound)) = hit else { break };
            let i = free.remove(place);
            (moved[i], target[i]) = (bound - self.point[i], bound);
        }
        self.judge(target, &moved, scale, full)
    }

    /// Which of `free` meets its bound first on the way from `moved` to `goal`: place, share of the way,
    /// bound.
    fn first_hit(
        &self,
        bounds: &Bounds,
        free: &[usize],
        moved: &[f64],
        goal: &[f64],
    ) -> Option<(usize, f64, f64)> {
        let mut first: Option<(usize, f64, f64)> = None;
        for (place, (&i, &goal)) in free.iter().zip(goal).enumerate() {
            let Some(bound) = bounds.crossed(i, self.point[i], goal) else { continue };
            let share = ((bound - self.point[i] - moved[i]) / (goal - moved[i])).clamp(0.0, 1.0);
            if first.is_none_or(|(_, least, _)| share < least) {
                first = Some((place, share, bound));
            }
        }
        first
    }

    fn judge(&self, target: Vec<f64>, moved: &[f64], scale: &[f64], full: bool) -> Step {
        let square = dot(&self.residuals, &self.residuals);
        let change = self.jacobian.times(moved);
        let slope = dot(&self.gradient, moved) / square;
        let predicted = -(2.0 * slope + dot(&change, &change) / square);
        let scaled: Vec<f64> = moved.iter().zip(scale).map(|(m, s)| m * s).collect();
        Step { target, length: norm(&scaled), predicted, slope, full }
    }
}
