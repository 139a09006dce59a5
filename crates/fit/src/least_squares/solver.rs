//! Levenberg–Marquardt as an [`argmin::core::Solver`]: one iteration tries one step.
//!
//! The trust radius follows Moré 1978: a ratio of actual to predicted decrease below ¼ shrinks it (to a tenth at most,
//! by a parabola through both), above ¾ or for a full step it becomes twice the step; ratios below 1e-4 reject the step.

use super::linear_model::{LinearModel, Step};
use super::problem::column_norms;
use super::{Bounds, Criterion, Options, Outcome};
use crate::Matrix;
use crate::matrix::{dot, norm};
use argmin::core::{
    Error, IterState, Jacobian, KV, Operator, Problem, Solver, State, TerminationReason, TerminationStatus,
};

/// Below this predicted relative decrease a rejected step says nothing: sums of squares do not resolve it.
const RESOLUTION: f64 = 1e-14;
const LEAST_RATIO: f64 = 1e-4;

type Iterate = IterState<Vec<f64>, (), Matrix, (), Vec<f64>, f64>;

/// The solver and its memory between iterations.
pub(super) struct LevenbergMarquardt {
    bounds: Bounds,
    options: Options,
    model: Option<LinearModel>,
    /// Largest norm each column of the Jacobian has had.
    scale: Vec<f64>,
    radius: f64,
    outcome: Option<Outcome>,
}

impl LevenbergMarquardt {
    pub fn new(bounds: Bounds, options: Options) -> Self {
        Self { bounds, options, model: None, scale: Vec::new(), radius: 0.0, outcome: None }
    }

    /// The last accepted point, and why the search ended.
    pub fn finish(self) -> Option<(LinearModel, Outcome)> {
        let outcome = self.outcome.unwrap_or(Outcome::IterationLimit);
        self.model.map(|model| (model, outcome))
    }

    fn rescale(&mut self, jacobian: &Matrix) {
        let norms = column_norms(jacobian);
        if self.scale.is_empty() {
            self.scale = norms;
        } else {
            self.scale.iter_mut().zip(norms).for_each(|(s, n)| *s = s.max(n));
        }
    }

    fn scaled_length(&self, point: &[f64]) -> f64 {
        let scaled: Vec<f64> = point.iter().zip(&self.scale).map(|(p, s)| p * s).collect();
        norm(&scaled)
    }

    /// The criteria on the full step.
    fn criterion(&self, model: &LinearModel, full: &Step) -> Option<Criterion> {
        if model.largest_cosine(&self.bounds) <= self.options.gtol {
            Some(Criterion::Gtol)
        } else if full.predicted <= self.options.ftol {
            Some(Criterion::Ftol)
        } else if full.length <= self.options.xtol * self.scaled_length(&model.point) {
            Some(Criterion::Xtol)
        } else {
            None
        }
    }

    fn update_radius(&mut self, step: &Step, actual: f64) {
        let ratio = actual / step.predicted;
        if ratio <= 0.25 || ratio.is_nan() {
            let parabola = 0.5 * 2.0 * step.slope / (2.0 * step.slope + actual);
            let shrink = if actual >= 0.0 { 0.5 } else { parabola.max(0.1) };
            self.radius = shrink * self.radius.min(10.0 * step.length);
        } else if step.full || ratio >= 0.75 {
            self.radius = 2.0 * step.length;
        }
    }

    /// Ends a search whose radius has collapsed.
    fn judge_rejection(&mut self, full: &Step, point: &[f64]) {
        if full.predicted <= RESOLUTION {
            self.outcome = Some(Outcome::Converged(Criterion::Ftol));
        } else if self.radius <= f64::EPSILON * self.scaled_length(point) || self.radius < f64::MIN_POSITIVE {
            self.outcome = Some(Outcome::Stalled);
        }
    }
}

/// (|r|² - |new|²)/|r|², without the cancellation of the squares; -∞ where `new` is not finite.
fn relative_decrease(old: &[f64], new: &[f64]) -> f64 {
    if !norm(new).is_finite() {
        return f64::NEG_INFINITY;
    }
    let product = old.iter().zip(new).fold(0.0, |sum, (a, b)| sum + (a - b) * (a + b));
    product / dot(old, old)
}

impl<O> Solver<O, Iterate> for LevenbergMarquardt
where
    O: Operator<Param = Vec<f64>, Output = Vec<f64>> + Jacobian<Param = Vec<f64>, Jacobian = Matrix>,
{
    fn name(&self) -> &str {
        "Levenberg-Marquardt"
    }

    fn init(&mut self, problem: &mut Problem<O>, mut state: Iterate) -> Result<(Iterate, Option<KV>), Error> {
        let point = state.take_param().ok_or_else(|| Error::msg("no start was given"))?;
        let residuals = problem.apply(&point)?;
        let jacobian = problem.jacobian(&point)?;
        if !norm(&residuals).is_finite() || !jacobian.is_finite() {
            self.outcome = Some(Outcome::NotFinite);
        }
        self.rescale(&jacobian);
        let length = self.scaled_length(&point);
        self.radius = self.options.first_radius * if length > 0.0 { length } else { 1.0 };
        let cost = 0.5 * dot(&residuals, &residuals);
        self.model = Some(LinearModel::new(point.clone(), residuals, jacobian));
        Ok((state.param(point).cost(cost), None))
    }

    fn next_iter(
        &mut self,
        problem: &mut Problem<O>,
        mut state: Iterate,
    ) -> Result<(Iterate, Option<KV>), Error> {
        let model = self.model.take().ok_or_else(|| Error::msg("the solver was not initialised"))?;
        let full = model.step(&self.bounds, &self.scale, f64::INFINITY);
        self.outcome = self.criterion(&model, &full).map(Outcome::Converged);
        if self.outcome.is_some() {
            self.model = Some(model);
            return Ok((state, None));
        }
        let first = state.get_iter() == 0;
        let step = if full.length <= self.radius {
            full.clone()
        } else {
            model.step(&self.bounds, &self.scale, self.radius)
        };
        if first {
            self.radius = self.radius.min(step.length);
        }
        let residuals = problem.apply(&step.target)?;
        let actual = relative_decrease(&model.residuals, &residuals);
        self.update_radius(&step, actual);
        if step.predicted > 0.0 && actual >= LEAST_RATIO * step.predicted {
            let jacobian = problem.jacobian(&step.target)?;
            if jacobian.is_finite() {
                self.rescale(&jacobian);
                state = state.param(step.target.clone()).cost(0.5 * dot(&residuals, &residuals));
                self.model = Some(LinearModel::new(step.target, residuals, jacobian));
                return Ok((state, None));
            }
            self.radius = 0.1 * step.length;
        }
        self.judge_rejection(&full, &model.point);
        self.model = Some(model);
        Ok((state, None))
    }

    fn terminate(&mut self, _state: &Iterate) -> TerminationStatus {
        match self.outcome {
            None => TerminationStatus::NotTerminated,
            Some(Outcome::Converged(_)) => TerminationStatus::Terminated(TerminationReason::SolverConverged),
            Some(outcome) => {
                TerminationStatus::Terminated(TerminationReason::SolverExit(outcome.to_string()))
            }
        }
    }
}
