//! κ_c, t and r of one row, with errors.

use crate::config::ParameterBounds;
use crate::least_squares::Outcome;
use crate::orders::Orders;
use crate::sandwich::Sensitivity;
use crate::{FitError, Reference};
use stratiform_artifact::{FittedParameter, Flag};

/// The fit of T_1, T_2, R_1, R_2.
pub(crate) struct OrdersFit {
    /// κ_c, t, r.
    pub parameters: [FittedParameter; 3],
    /// Of (κ_c, t), (κ_c, r), (t, r).
    pub correlations: Option<[f64; 3]>,
    /// Quantity after quantity.
    pub residuals: Vec<f64>,
    pub flags: Vec<Flag>,
    pub outcome: Outcome,
}

/// Fits one row.
pub(crate) fn fit_orders(
    bounds: &ParameterBounds,
    tau: &[f64],
    reference: &Reference,
) -> Result<OrdersFit, FitError> {
    let orders = Orders { tau, data: &reference.orders };
    let solution = orders.fit(bounds)?;
    let sensitivity = Sensitivity::new(&orders, &solution, &Orders::allowed(bounds), &[], &[])?;
    let block = reference.orders_covariance()?;
    let covariance = sensitivity.map(|s| s.covariance(std::slice::from_ref(&block)));
    let fitted = |i: usize| {
        let value = solution.parameters[i];
        let std_error = covariance.as_ref().and_then(|c| c.std_error(i));
        FittedParameter { value: Some(value), std_error, emitted: value }
    };
    let correlation = |a, b| covariance.as_ref().and_then(|c| c.correlation(a, b));
    let correlations = [correlation(0, 1), correlation(0, 2), correlation(1, 2)];
    let bounds = [Flag::KappaCOnBound, Flag::TOnBound, Flag::ROnBound];
    let mut flags: Vec<Flag> = (0..3).filter(|&i| solution.on_bound[i]).map(|i| bounds[i]).collect();
    if !solution.outcome.has_converged() {
        flags.push(Flag::NotConverged);
    }
    Ok(OrdersFit {
        parameters: [fitted(0), fitted(1), fitted(2)],
        correlations: if let [Some(a), Some(b), Some(c)] = correlations { Some([a, b, c]) } else { None },
        residuals: solution.residuals.clone(),
        flags,
        outcome: solution.outcome,
    })
}
