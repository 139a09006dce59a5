//! Derivatives by differences, for problems without analytic ones and for checking those that have them.

use super::LeastSquares;
use crate::{FitError, Matrix};

/// The Jacobian by the five-point central rule: error O(h⁴), with h = ε^{1/5}·max(|p|, `scale`), which leaves
/// about 3e-13 of the residuals' size. Evaluates up to 2h beyond `p` to either side, bounds or not.
///
/// # Errors
/// Those of [`LeastSquares::residuals`].
pub fn numerical_jacobian<L: LeastSquares + ?Sized>(
    problem: &L,
    p: &[f64],
    scale: f64,
    out: &mut Matrix,
) -> Result<(), FitError> {
    const RELATIVE_STEP: f64 = 7.4e-4;
    let mut at = p.to_vec();
    let mut residuals = vec![0.0; problem.residual_count()];
    for j in 0..p.len() {
        let h = RELATIVE_STEP * p[j].abs().max(scale);
        out.column_mut(j).fill(0.0);
        for (offset, weight) in [(-2.0, 1.0), (-1.0, -8.0), (1.0, 8.0), (2.0, -1.0)] {
            at[j] = p[j] + offset * h;
            problem.residuals(&at, &mut residuals)?;
            for (sum, r) in out.column_mut(j).iter_mut().zip(&residuals) {
                *sum += weight * r / (12.0 * h);
            }
        }
        at[j] = p[j];
    }
    Ok(())
}
