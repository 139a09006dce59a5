//! The search: Nelder and Mead's simplex (argmin) over parameters mapped to the whole line, from fixed starts.
//!
//! w = 1/(1+e^-x) and g = tanh x reach the open intervals, α = e^x up to 1e3. The simplex knows no derivative, which
//! the total variation does not have where P = Q. The best of all starts is returned; nothing is random.

use super::measure::Sphere;
use super::{Blend, BlendPhase, Family::*};
use crate::TablesError;
use argmin::core::{CostFunction, Error, Executor, State};
use argmin::solver::neldermead::NelderMead;
use stratiform_optics::phase::{PhaseFunction, PhaseTable};

/// What is free.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Family {
    /// g.
    HenyeyGreenstein,
    /// w, g1, g2.
    TwoLobe,
    /// w, g1, g2, α.
    HgDraine,
}

/// What is made small.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Objective {
    /// Total variation.
    Scattered,
    /// Root mean square of ln(Q/P) over the sphere.
    Seen,
}

impl Family {
    /// For files.
    pub const fn name(self) -> &'static str {
        match self {
            HenyeyGreenstein => "henyey-greenstein",
            TwoLobe => "two-lobe",
            HgDraine => "hg-draine",
        }
    }

    fn blend(self, x: &[f64]) -> Blend {
        // tanh and the logistic function round to their limits far out; the limits themselves are no phase functions.
        let g = |x: f64| libm::tanh(x).clamp(-0.999_999, 0.999_999);
        let w = |x: f64| 1.0 / (1.0 + libm::exp(-x));
        match (self, x) {
            (HenyeyGreenstein, [a, ..]) => Blend::henyey_greenstein(g(*a)),
            (TwoLobe, [a, b, c, ..]) => Blend::two_lobe(w(*a), g(*b), g(*c)),
            (HgDraine, [a, b, c, d, ..]) => {
                Blend { w: w(*a), g1: g(*b), g2: g(*c), alpha: libm::exp(*d).min(1e3) }
            }
            _ => Blend::henyey_greenstein(0.0),
        }
    }

    /// Where the search begins: a sharp peak with a wide lobe, at several widths; a lobe with a weak backward one.
    fn starts(self, asymmetry: f64) -> Vec<Vec<f64>> {
        let g = |g: f64| libm::atanh(g.clamp(-0.99, 0.99));
        let w = |w: f64| libm::log(w / (1.0 - w));
        match self {
            HenyeyGreenstein => vec![vec![g(asymmetry)], vec![g(0.5 * asymmetry)]],
            TwoLobe => [(0.5, 0.97, 0.7), (0.5, 0.99, 0.8), (0.05, asymmetry, -0.4)]
                .map(|(a, b, c)| vec![w(a), g(b), g(c)])
                .to_vec(),
            HgDraine => [(0.45, 0.97, 0.55, 20.0), (0.5, 0.99, 0.6, 30.0), (0.5, 0.95, 0.3, 2.0)]
                .map(|(a, b, c, d)| vec![w(a), g(b), g(c), libm::log(d)])
                .to_vec(),
        }
    }
}

impl Objective {
    /// For files.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Scattered => "total-variation",
            Self::Seen => "log-least-squares",
        }
    }

    /// The distance.
    pub(super) fn of(self, sphere: &Sphere, phase: &BlendPhase) -> f64 {
        match self {
            Self::Scattered => sphere.total_variation(phase),
            Self::Seen => sphere.log_rms(phase),
        }
    }
}

struct Distance<'a> {
    sphere: &'a Sphere,
    family: Family,
    objective: Objective,
}

impl CostFunction for Distance<'_> {
    type Param = Vec<f64>;
    type Output = f64;

    fn cost(&self, x: &Vec<f64>) -> Result<f64, Error> {
        let phase = self.family.blend(x).phase()?;
        Ok(self.objective.of(self.sphere, &phase))
    }
}

/// Iterations of one search; it stops earlier when the simplex is level to 1e-9.
const ITERATIONS: u64 = 600;

/// The blend of `family` nearest to `table` by `objective`.
///
/// # Errors
/// [`TablesError::Container`] if the search itself fails.
pub fn fit(table: &PhaseTable, family: Family, objective: Objective) -> Result<Blend, TablesError> {
    let sphere = Sphere::new(table);
    let fault =
        |error: Error| TablesError::Container { format: "nearest phase function", reason: error.to_string() };
    let mut best: Option<(f64, Vec<f64>)> = None;
    for start in family.starts(table.asymmetry()) {
        let distance = Distance { sphere: &sphere, family, objective };
        let solver = NelderMead::new(simplex(&start)).with_sd_tolerance(1e-9).map_err(fault)?;
        let run = Executor::new(distance, solver).configure(|state| state.max_iters(ITERATIONS)).ctrlc(false);
        let state = run.run().map_err(fault)?.state;
        let cost = state.get_best_cost();
        if let Some(x) =
            state.get_best_param().filter(|_| best.as_ref().is_none_or(|(least, _)| cost < *least))
        {
            best = Some((cost, x.clone()));
        }
    }
    let (_, x) = best.ok_or_else(|| fault(Error::msg("no start has a distance")))?;
    Ok(family.blend(&x))
}

/// The start and one point a step away along every axis.
fn simplex(start: &[f64]) -> Vec<Vec<f64>> {
    let moved = |axis: usize| {
        let mut point = start.to_vec();
        point[axis] += 0.3;
        point
    };
    std::iter::once(start.to_vec()).chain((0..start.len()).map(moved)).collect()
}
