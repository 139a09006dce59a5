//! The problem to solve, its solution, and how argmin is driven.

use super::solver::LevenbergMarquardt;
use super::{Bounds, Options, Outcome};
use crate::{FitError, Matrix, qr::PivotedQr};
use argmin::core::{Error, Executor, IterState, Jacobian, Operator};

/// Residuals r(p) and their derivatives.
pub trait LeastSquares {
    /// Number of residuals; not smaller than that of the parameters.
    fn residual_count(&self) -> usize;

    /// Writes r(p). A point where the model has no value yields NaN, which the optimiser steps back from.
    ///
    /// # Errors
    /// Whatever makes further search pointless.
    fn residuals(&self, p: &[f64], out: &mut [f64]) -> Result<(), FitError>;

    /// Writes ∂rᵢ/∂pⱼ to row i, column j.
    ///
    /// # Errors
    /// As for the residuals.
    fn jacobian(&self, p: &[f64], out: &mut Matrix) -> Result<(), FitError>;
}

/// Where the search ended.
#[derive(Clone, Debug)]
pub struct Solution {
    /// p.
    pub parameters: Vec<f64>,
    /// r(p).
    pub residuals: Vec<f64>,
    /// ∂r/∂p.
    pub jacobian: Matrix,
    /// Why it ended.
    pub outcome: Outcome,
    /// Steps tried.
    pub iterations: u64,
    /// Which parameters sit on a bound.
    pub on_bound: Vec<bool>,
}

impl Solution {
    /// Σr².
    pub fn sum_of_squares(&self) -> f64 {
        self.residuals.iter().fold(0.0, |sum, r| sum + r * r)
    }

    /// F with F·Fᵀ = (JᵀJ)⁻¹, from QR of the column-scaled Jacobian; `None` where J has not full rank.
    pub fn covariance_factor(&self) -> Option<Matrix> {
        let scale = column_norms(&self.jacobian);
        let all: Vec<usize> = (0..scale.len()).collect();
        let qr = PivotedQr::new(self.jacobian.scaled_columns(&all, |j| 1.0 / scale[j]));
        let mut factor = qr.covariance_factor()?;
        for j in 0..scale.len() {
            for (value, s) in factor.column_mut(j).iter_mut().zip(&scale) {
                *value /= s;
            }
        }
        Some(factor)
    }

    /// Standard errors from the residuals' own scatter: √(Σr²/(m - n) · diag (JᵀJ)⁻¹). `None` where m = n or
    /// J has not full rank.
    pub fn scatter_errors(&self) -> Option<Vec<f64>> {
        let (m, n) = (self.residuals.len(), self.parameters.len());
        let factor = self.covariance_factor().filter(|_| m > n)?;
        let variance = self.sum_of_squares() / (m - n) as f64;
        let row = |i: usize| (0..n).fold(0.0, |sum, k| sum + factor.get(i, k) * factor.get(i, k));
        Some((0..n).map(|i| (variance * row(i)).sqrt()).collect())
    }
}

/// Norms of the columns, 1 for zero columns.
pub(super) fn column_norms(jacobian: &Matrix) -> Vec<f64> {
    let norm = |j| Some(crate::matrix::norm(jacobian.column(j))).filter(|n| *n > 0.0).unwrap_or(1.0);
    (0..jacobian.columns()).map(norm).collect()
}

/// The problem in argmin's words.
struct Adapter<'a, L: ?Sized>(&'a L);

impl<L: LeastSquares + ?Sized> Operator for Adapter<'_, L> {
    type Param = Vec<f64>;
    type Output = Vec<f64>;

    fn apply(&self, p: &Vec<f64>) -> Result<Vec<f64>, Error> {
        let mut out = vec![0.0; self.0.residual_count()];
        self.0.residuals(p, &mut out)?;
        Ok(out)
    }
}

impl<L: LeastSquares + ?Sized> Jacobian for Adapter<'_, L> {
    type Param = Vec<f64>;
    type Jacobian = Matrix;

    fn jacobian(&self, p: &Vec<f64>) -> Result<Matrix, Error> {
        let mut out = Matrix::zeros(self.0.residual_count(), p.len());
        self.0.jacobian(p, &mut out)?;
        Ok(out)
    }
}

/// Minimises ½Σr² from `start` inside `bounds`.
///
/// # Errors
/// [`FitError`] for a start outside the bounds, fewer residuals than parameters, or an error of the problem
/// itself. Not reaching a minimum is no error but an [`Outcome`].
pub fn solve<L: LeastSquares + ?Sized>(
    problem: &L,
    start: &[f64],
    bounds: &Bounds,
    options: &Options,
) -> Result<Solution, FitError> {
    bounds.check(start)?;
    if problem.residual_count() < start.len() {
        let (m, n) = (problem.residual_count(), start.len());
        return Err(FitError::Inconsistent(format!("{m} residuals cannot determine {n} parameters")));
    }
    let solver = LevenbergMarquardt::new(bounds.clone(), *options);
    let first = |state: IterState<Vec<f64>, (), Matrix, (), Vec<f64>, f64>| {
        state.param(start.to_vec()).max_iters(options.max_iterations)
    };
    let run = Executor::new(Adapter(problem), solver).configure(first).ctrlc(false).timer(false).run();
    let result = run.map_err(|error| match error.downcast::<FitError>() {
        Ok(own) => own,
        Err(other) => FitError::Optimiser(other.to_string()),
    })?;
    let iterations = result.state.iter;
    let (model, outcome) =
        result.solver.finish().ok_or_else(|| FitError::Optimiser("no step was taken".into()))?;
    let on_bound = model.point.iter().enumerate().map(|(i, &p)| bounds.holds(i, p)).collect();
    Ok(Solution {
        parameters: model.point,
        residuals: model.residuals,
        jacobian: model.jacobian,
        outcome,
        iterations,
        on_bound,
    })
}
