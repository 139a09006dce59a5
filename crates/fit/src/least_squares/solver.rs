//! Levenberg–Marquardt as an [`argmin::core::Solver`]: one iteration tries one step.
//!
//! The trust radius follows Moré 1978: a ratio of actual to predicted decrease below ¼ shrinks it (to a tenth
//! at most, by a parabola through both), above ¾ or for a full step it becomes twice the step; ratios below
//! 1e-4 reject the step.
//!
//! Sums of squares resolve parameters only to the square root of the rounding error. Once the predicted
//! decrease is below that, full steps are taken as long as each shrinks the decrease predicted after it; the
//! first that does not is the end.

use super::linear_model::{LinearModel, Step};
use super::problem::column_norms;
use super::{Bounds, Criterion, Options, Outcome};
use crate::Matrix;
use crate::matrix::{dot, norm};
use argmin::core::{
    Error, IterState, Jacobian, KV, Operator, Problem, Solver, State, TerminationReason, TerminationStatus,
};

/// Below this predicted relative decrease sums of squares do not tell a good step from a bad one.
const RESOLUTION: f64 = 1e-13;
/// Least factor by which a step taken without their help must shrink the predicted decrease.
const POLISH: f64 = 0.5;
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

    fn has_collapsed(&self, point: &[f64]) -> bool {
        self.radius <= f64::EPSILON * self.scaled_length(point) || self.radius < f64::MIN_POSITIVE
    }

    /// The model at `point`; `None` where residuals or derivatives are not finite.
    fn linearise<O: Differentiable>(
        problem: &mut Problem<O>,
        point: &[f64],
        residuals: Vec<f64>,
    ) -> Result<Option<LinearModel>, Error> {
        if !norm(&residuals).is_finite() {
            return Ok(None);
        }
        let jacobian = problem.jacobian(&point.to_vec())?;
        Ok(jacobian.is_finite().then(|| LinearModel::new(point.to_vec(), residuals, jacobian)))
    }

    /// Takes the full step if the next one promises much less; otherwise the search is over.
    fn polish<O: Differentiable>(
        &mut self,
        problem: &mut Problem<O>,
        model: LinearModel,
        full: &Step,
    ) -> Result<LinearModel, Error> {
        let residuals = problem.apply(&full.target)?;
        if let Some(next) = Self::linearise(problem, &full.target, residuals)? {
            let promised = next.step(&self.bounds, &self.scale, f64::INFINITY).predicted;
            if promised < POLISH * full.predicted {
                return Ok(next);
            }
        }
        self.outcome = Some(Outcome::Converged(Criterion::Ftol));
        Ok(model)
    }

    /// Tries a step inside the trust radius; returns the point where the search stands after it.
    fn attempt<O: Differentiable>(
        &mut self,
        problem: &mut Problem<O>,
        model: LinearModel,
        full: Step,
        first: bool,
    ) -> Result<LinearModel, Error> {
        let step = if full.length <= self.radius {
            full
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
            if let Some(next) = Self::linearise(problem, &step.target, residuals)? {
                self.rescale(&next.jacobian);
                return Ok(next);
            }
            self.radius = 0.1 * step.length;
        }
        if self.has_collapsed(&model.point) {
            self.outcome = Some(Outcome::Stalled);
        }
        Ok(model)
    }
}

/// What the solver asks of a problem.
pub(super) trait Differentiable:
    Operator<Param = Vec<f64>, Output = Vec<f64>> + Jacobian<Param = Vec<f64>, Jacobian = Matrix>
{
}

impl<O> Differentiable for O where
    O: Operator<Param = Vec<f64>, Output = Vec<f64>> + Jacobian<Param = Vec<f64>, Jacobian = Matrix>
{
}

/// (|r|² - |new|²)/|r|², without the cancellation of the squares; -∞ where `new` is not finite.
fn relative_decrease(old: &[f64], new: &[f64]) -> f64 {
    if !norm(new).is_finite() {
        return f64::NEG_INFINITY;
    }
    let product = old.iter().zip(new).fold(0.0, |sum, (a, b)| sum + (a - b) * (a + b));
    product / dot(old, old)
}

impl<O: Differentiable> Solver<O, Iterate> for LevenbergMarquardt {
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
        state: Iterate,
    ) -> Result<(Iterate, Option<KV>), Error> {
        let model = self.model.take().ok_or_else(|| Error::msg("the solver was not initialised"))?;
        let full = model.step(&self.bounds, &self.scale, f64::INFINITY);
        self.outcome = self.criterion(&model, &full).map(Outcome::Converged);
        let next = if self.outcome.is_some() {
            model
        } else if full.predicted <= RESOLUTION {
            self.polish(problem, model, &full)?
        } else {
            self.attempt(problem, model, full, state.get_iter() == 0)?
        };
        let cost = 0.5 * dot(&next.residuals, &next.residuals);
        let state = state.param(next.point.clone()).cost(cost);
        self.model = Some(next);
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
