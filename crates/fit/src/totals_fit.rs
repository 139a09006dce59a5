//! β, b and c of every row, with errors.
//!
//! One β is fitted to the rows up to the config's angle; the rows beyond it and the diffuse row are fitted
//! with that β held, whose error enters theirs. Where c is [not identifiable](crate::identifiable) its table
//! entry is empty: c is then held at the value interpolated between the neighbours (log c over μ_l), and b
//! fitted again with this c and the shared β, so that the emitted (b, c) is the best pair with a c continuous
//! in θ_l. The errors of β and of that c enter b's. β and the other rows stay as they are.

use crate::config::{FitConfig, ParameterBounds};
use crate::identifiable::{Curve, interpolated};
use crate::least_squares::{Outcome, Solution};
use crate::multiple::{Held, Totals, place_of_b};
use crate::sandwich::{Covariance, Sensitivity};
use crate::{FitError, Reference};
use stratiform_artifact::{FittedParameter, Flag};
use stratiform_stats::Estimate;

/// The fit of T_ms.
pub(crate) struct TotalsFit {
    pub beta: Estimate,
    pub rows: Vec<TotalsRow>,
}

/// Its part of one row.
pub(crate) struct TotalsRow {
    pub b: FittedParameter,
    pub c: FittedParameter,
    pub correlation: Option<f64>,
    pub residuals: Vec<f64>,
    pub flags: Vec<Flag>,
    pub outcome: Outcome,
}

/// Rows fitted together, as indices of the references.
struct Group {
    members: Vec<usize>,
    beta_fixed: bool,
}

struct GroupFit {
    group: Group,
    solution: Solution,
    covariance: Option<Covariance>,
}

/// Fits every row, then once more those whose c is not identifiable.
pub(crate) fn fit_totals(
    config: &FitConfig,
    tau: &[f64],
    references: &[Reference],
) -> Result<TotalsFit, FitError> {
    let fits = fit_groups(config, tau, references)?;
    let beta = beta(&fits[0]);
    let identifiable = |i: usize| find(&fits, i).doubt(i, tau) <= 1.0;
    let c: Vec<Option<Estimate>> =
        (0..references.len()).map(|i| identifiable(i).then(|| find(&fits, i).c(i, tau))).collect();
    let held = interpolated(references, &c, config.bounds.c)?;
    let mut rows = Vec::with_capacity(references.len());
    for (i, held) in held.into_iter().enumerate() {
        let first = find(&fits, i);
        rows.push(match held {
            Some(c) => {
                let group = Group { members: vec![i], beta_fixed: first.group.beta_fixed };
                fit_group(&config.bounds, tau, references, group, Some(beta), Some(c))?.row(i, tau, true)
            }
            None => first.row(i, tau, c[i].is_none()),
        });
    }
    Ok(TotalsFit { beta, rows })
}

fn find(fits: &[GroupFit], reference: usize) -> &GroupFit {
    let own = fits.iter().find(|fit| fit.group.members.contains(&reference));
    own.unwrap_or(&fits[0])
}

fn beta(fit: &GroupFit) -> Estimate {
    let std_error = fit.covariance.as_ref().and_then(|c| c.std_error(0)).unwrap_or(0.0);
    Estimate { value: fit.solution.parameters[0], std_error }
}

/// The rows that share β, then each of the others.
fn groups(config: &FitConfig, references: &[Reference]) -> Vec<Group> {
    let shares = |r: &Reference| r.incidence.degrees().is_some_and(|d| d <= config.shared_beta_up_to_deg);
    let (shared, alone): (Vec<usize>, Vec<usize>) =
        (0..references.len()).partition(|&i| shares(&references[i]));
    let single = |i| Group { members: vec![i], beta_fixed: true };
    std::iter::once(Group { members: shared, beta_fixed: false })
        .chain(alone.into_iter().map(single))
        .collect()
}

fn fit_groups(config: &FitConfig, tau: &[f64], references: &[Reference]) -> Result<Vec<GroupFit>, FitError> {
    let mut fits: Vec<GroupFit> = Vec::new();
    for group in groups(config, references) {
        let supplied = fits.first().map(beta);
        fits.push(fit_group(&config.bounds, tau, references, group, supplied, None)?);
    }
    Ok(fits)
}

/// Fits rows together; β, and c of a single row, may be supplied with their errors.
fn fit_group(
    bounds: &ParameterBounds,
    tau: &[f64],
    references: &[Reference],
    group: Group,
    beta: Option<Estimate>,
    c: Option<Estimate>,
) -> Result<GroupFit, FitError> {
    let members: Vec<&Reference> = group.members.iter().map(|&i| &references[i]).collect();
    let totals = Totals { tau, rows: members.iter().map(|r| r.t_ms.as_slice()).collect() };
    let held = Held { beta: beta.map(|b| b.value), c: vec![c.map(|c| c.value); members.len()] };
    let solution = totals.fit(bounds, &held)?;
    let place_of_c = place_of_b(0) + 1;
    let supplied: Vec<(usize, f64)> = [(0, beta), (place_of_c, c)]
        .into_iter()
        .filter_map(|(place, estimate)| estimate.map(|e| (place, e.std_error * e.std_error)))
        .collect();
    let allowed = Totals::allowed(bounds, &held);
    let blocks = members.iter().map(|r| r.t_ms_covariance()).collect::<Result<Vec<_>, _>>()?;
    let mut fit = GroupFit { group, solution, covariance: None };
    let mut sensitivity = Sensitivity::new(&totals, &fit.solution, &allowed, &supplied, &[])?;
    if sensitivity.is_none() {
        let without = fit.doubtful(tau);
        sensitivity = Sensitivity::new(&totals, &fit.solution, &allowed, &supplied, &without)?;
    }
    fit.covariance = sensitivity.map(|s| s.covariance(&blocks));
    Ok(fit)
}

impl GroupFit {
    /// Place of b in the parameters, and the residuals, of a reference.
    fn of(&self, reference: usize, tau: &[f64]) -> (usize, &[f64]) {
        let row = self.group.members.iter().position(|&i| i == reference).unwrap_or(0);
        (place_of_b(row), &self.solution.residuals[row * tau.len()..(row + 1) * tau.len()])
    }

    fn std_error(&self, place: usize) -> Option<f64> {
        self.covariance.as_ref().and_then(|c| c.std_error(place))
    }

    fn c(&self, reference: usize, tau: &[f64]) -> Estimate {
        let place = self.of(reference, tau).0 + 1;
        let std_error = self.std_error(place).unwrap_or(0.0);
        Estimate { value: self.solution.parameters[place], std_error }
    }

    /// Places of the c that are not identifiable.
    fn doubtful(&self, tau: &[f64]) -> Vec<usize> {
        let members = self.group.members.iter();
        members.filter(|&&i| self.doubt(i, tau) > 1.0).map(|&i| self.of(i, tau).0 + 1).collect()
    }

    /// Doubt about c of a reference.
    fn doubt(&self, reference: usize, tau: &[f64]) -> f64 {
        let (b, residuals) = self.of(reference, tau);
        let p = &self.solution.parameters;
        Curve { tau, beta: p[0], b: p[b], c: p[b + 1] }.doubt(self.std_error(b + 1), residuals)
    }

    fn row(&self, reference: usize, tau: &[f64], without_c: bool) -> TotalsRow {
        let (b, residuals) = self.of(reference, tau);
        let on_bound = |place: usize| self.solution.on_bound[place];
        let flags = [
            (without_c, Flag::CNotIdentifiable),
            (on_bound(b), Flag::BOnBound),
            (on_bound(b + 1) && !without_c, Flag::COnBound),
            (self.group.beta_fixed, Flag::BetaFixed),
            (!self.solution.outcome.has_converged(), Flag::NotConverged),
        ];
        let [at_b, at_c] = [self.solution.parameters[b], self.solution.parameters[b + 1]];
        let error_of_c = if without_c { None } else { self.std_error(b + 1) };
        TotalsRow {
            b: FittedParameter { value: Some(at_b), std_error: self.std_error(b), emitted: at_b },
            c: FittedParameter { value: (!without_c).then_some(at_c), std_error: error_of_c, emitted: at_c },
            correlation: self.covariance.as_ref().and_then(|c| c.correlation(b, b + 1)),
            residuals: residuals.to_vec(),
            flags: flags.into_iter().filter(|f| f.0).map(|f| f.1).collect(),
            outcome: self.solution.outcome,
        }
    }
}
