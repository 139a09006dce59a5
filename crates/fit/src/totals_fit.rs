//! β, b and c of every row, with errors.
//!
//! One β is fitted to the rows up to the config's angle; the rows beyond it and the diffuse row are fitted with that β
//! held, whose error enters theirs. Where c is [not identifiable](crate::identifiable) its table entry is empty: c is
//! then held at the value interpolated between the neighbours (log c over μ_l) and everything fitted again, so that the
//! emitted (b, c) is the best pair with a c continuous in θ_l.

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

/// Fits every row; while some c are not identifiable, the worst of them is held and everything fitted again.
pub(crate) fn fit_totals(
    config: &FitConfig,
    tau: &[f64],
    references: &[Reference],
) -> Result<TotalsFit, FitError> {
    let rows = 0..references.len();
    let mut without_c = vec![false; references.len()];
    let mut held = vec![None; references.len()];
    loop {
        let fits = fit_groups(config, tau, references, &held)?;
        let judged = rows.clone().filter(|&i| !without_c[i]).map(|i| (i, find(&fits, i).doubt(i, tau)));
        let worst = judged.fold((0, 0.0), |worst, next| if next.1 > worst.1 { next } else { worst });
        if worst.1 <= 1.0 {
            let row = |i| find(&fits, i).row(i, tau, without_c[i]);
            return Ok(TotalsFit { beta: beta(&fits[0]), rows: rows.map(row).collect() });
        }
        without_c[worst.0] = true;
        let c = rows.clone().map(|i| (!without_c[i]).then(|| find(&fits, i).c(i, tau)));
        held = interpolated(references, &c.collect::<Vec<_>>(), config.bounds.c)?;
    }
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

fn fit_groups(
    config: &FitConfig,
    tau: &[f64],
    references: &[Reference],
    held_c: &[Option<f64>],
) -> Result<Vec<GroupFit>, FitError> {
    let mut fits: Vec<GroupFit> = Vec::new();
    for group in groups(config, references) {
        let supplied = if group.beta_fixed { fits.first().map(beta) } else { None };
        let c = group.members.iter().map(|&i| held_c[i]).collect();
        let held = Held { beta: supplied.map(|beta| beta.value), c };
        fits.push(fit_group(&config.bounds, tau, references, group, &held, supplied)?);
    }
    Ok(fits)
}

fn fit_group(
    bounds: &ParameterBounds,
    tau: &[f64],
    references: &[Reference],
    group: Group,
    held: &Held,
    beta: Option<Estimate>,
) -> Result<GroupFit, FitError> {
    let members = || group.members.iter().map(|&i| &references[i]);
    let totals = Totals { tau, rows: members().map(|r| r.t_ms.as_slice()).collect() };
    let solution = totals.fit(bounds, held)?;
    let supplied: Vec<(usize, f64)> = beta.iter().map(|b| (0, b.std_error * b.std_error)).collect();
    let allowed = Totals::allowed(bounds, held);
    let sensitivity = Sensitivity::new(&totals, &solution, &allowed, &supplied)?;
    let blocks = members().map(Reference::t_ms_covariance).collect::<Result<Vec<_>, _>>()?;
    let covariance = sensitivity.map(|s| s.covariance(&blocks));
    Ok(GroupFit { group, solution, covariance })
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

    fn c(&self, reference: usize, tau: &[f64]) -> f64 {
        self.solution.parameters[self.of(reference, tau).0 + 1]
    }

    /// Doubt about c of a reference.
    fn doubt(&self, reference: usize, tau: &[f64]) -> f64 {
        let (b, residuals) = self.of(reference, tau);
        let p = &self.solution.parameters;
        Curve { tau, beta: p[0], b: p[b], c: p[b + 1] }.doubt(self.std_error(b + 1), residuals)
    }

    fn row(&self, reference: usize, tau: &[f64], c_held: bool) -> TotalsRow {
        let (b, residuals) = self.of(reference, tau);
        let on_bound = |place: usize| self.solution.on_bound[place];
        let flags = [
            (c_held, Flag::CNotIdentifiable),
            (on_bound(b), Flag::BOnBound),
            (on_bound(b + 1) && !c_held, Flag::COnBound),
            (self.group.beta_fixed, Flag::BetaFixed),
            (!self.solution.outcome.has_converged(), Flag::NotConverged),
        ];
        let [at_b, at_c] = [self.solution.parameters[b], self.solution.parameters[b + 1]];
        let error_of_c = if c_held { None } else { self.std_error(b + 1) };
        TotalsRow {
            b: FittedParameter { value: Some(at_b), std_error: self.std_error(b), emitted: at_b },
            c: FittedParameter { value: (!c_held).then_some(at_c), std_error: error_of_c, emitted: at_c },
            correlation: self.covariance.as_ref().and_then(|c| c.correlation(b, b + 1)),
            residuals: residuals.to_vec(),
            flags: flags.into_iter().filter(|f| f.0).map(|f| f.1).collect(),
            outcome: self.solution.outcome,
        }
    }
}
