//! Whether the totals determine c, and what stands in where they do not.
//!
//! T_ms depends on c only through (1-b)(1 - e^{-cτ}). Two errors are held against c, either of which makes it
//! unidentifiable above c/2: the standard error from the reference's covariance, and the misfit's own,
//! √(Σr²/(n-2) · [(JᵀJ)⁻¹]_cc) with J by (b, c) of this row. The second says that c could be moved by half its value with a
//! change of the curve no larger than what the form fails to follow anyhow. In the published cloud this happens near 44°.

use crate::matrix::{dot, norm};
use crate::qr::PivotedQr;
use crate::{FitError, Matrix, Reference};
use stratiform_quantities::Incidence;

/// Above this error relative to c it is not identifiable.
pub(crate) const LARGEST_RELATIVE_ERROR: f64 = 0.5;

/// The larger of both errors relative to c, from its standard error (absent on a bound), the row's residuals and its
/// derivatives by b and c.
pub(crate) fn relative_error(
    c: f64,
    std_error: Option<f64>,
    residuals: &[f64],
    by_b: &[f64],
    by_c: &[f64],
) -> f64 {
    std_error.unwrap_or(0.0).max(misfit_error(residuals, by_b, by_c)) / c
}

/// The error of c that the misfit supports; infinite where c has no influence of its own.
fn misfit_error(residuals: &[f64], by_b: &[f64], by_c: &[f64]) -> f64 {
    let lengths = [norm(by_b), norm(by_c)];
    if lengths[1] == 0.0 || residuals.len() < 3 {
        return f64::INFINITY;
    }
    let mut scaled = Matrix::zeros(residuals.len(), 2);
    for (j, column) in [by_b, by_c].into_iter().enumerate() {
        let length = if lengths[j] > 0.0 { lengths[j] } else { 1.0 };
        scaled.column_mut(j).iter_mut().zip(column).for_each(|(to, from)| *to = from / length);
    }
    let scatter = dot(residuals, residuals) / (residuals.len() - 2) as f64;
    let Some(factor) = PivotedQr::new(scaled).covariance_factor() else { return f64::INFINITY };
    let unit = norm(&[factor.get(1, 0), factor.get(1, 1)]);
    scatter.sqrt() * unit / lengths[1]
}

/// μ_l of a row; diffuse light counts as its mean cosine, 2/3.
fn cosine(reference: &Reference) -> Result<f64, FitError> {
    Ok(match reference.light()? {
        Incidence::Beam(mu) => mu.get(),
        Incidence::Diffuse => 2.0 / 3.0,
    })
}

/// For each row without c, the value to hold it at: log c interpolated over μ_l between the nearest angles that have one, the
/// nearest one's beyond them, and the middle of the bounds where none has.
pub(crate) fn interpolated(
    references: &[Reference],
    c: &[Option<f64>],
    [lower, upper]: [f64; 2],
) -> Result<Vec<Option<f64>>, FitError> {
    let mut nodes = Vec::new();
    for (reference, c) in references.iter().zip(c) {
        if let (Some(c), Some(_)) = (c, reference.incidence.degrees()) {
            nodes.push((cosine(reference)?, libm::log(*c)));
        }
    }
    let fill = |(reference, c): (&Reference, &Option<f64>)| -> Result<Option<f64>, FitError> {
        if c.is_some() {
            return Ok(None);
        }
        let mu = cosine(reference)?;
        let middle = 0.5 * libm::log(lower * upper);
        Ok(Some(libm::exp(between(&nodes, mu).unwrap_or(middle)).clamp(lower, upper)))
    };
    references.iter().zip(c).map(fill).collect()
}

/// Linear interpolation between the nearest nodes (in any order) on either side.
fn between(nodes: &[(f64, f64)], mu: f64) -> Option<f64> {
    let below = nodes.iter().filter(|n| n.0 <= mu).max_by(|a, b| a.0.total_cmp(&b.0));
    let above = nodes.iter().filter(|n| n.0 >= mu).min_by(|a, b| a.0.total_cmp(&b.0));
    match (below, above) {
        (Some(a), Some(b)) if b.0 > a.0 => Some(a.1 + (b.1 - a.1) * (mu - a.0) / (b.0 - a.0)),
        (a, b) => a.or(b).map(|node| node.1),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn c_is_judged_by_both_errors() {
        let (by_b, by_c) = ([0.0, 0.5, 1.0, 1.0], [0.0, 0.2, 0.1, 0.0]);
        let judge = |misfit: f64, error| {
            relative_error(1.0, error, &[misfit, -misfit, misfit, -misfit], &by_b, &by_c)
        };
        assert_eq!(judge(1e-3, Some(0.6)), 0.6);
        assert!(judge(1e-3, None) < 0.1 && judge(0.2, Some(0.1)) > 0.5);
        assert_eq!(relative_error(1.0, None, &[0.0; 4], &by_b, &[0.0; 4]), f64::INFINITY, "no influence");
        let same = relative_error(1.0, None, &[1e-9; 4], &by_b, &by_b.map(|b| 2.0 * b));
        assert_eq!(same, f64::INFINITY, "indistinguishable from b");
    }

    #[test]
    fn gaps_are_filled_between_neighbours() {
        let nodes = [(1.0, 0.0), (0.5, 1.0), (0.0, 5.0)];
        assert_eq!(between(&nodes, 0.75), Some(0.5));
        assert_eq!(between(&nodes[..2], 0.1), Some(1.0));
        assert_eq!(between(&nodes, 0.5), Some(1.0));
        assert_eq!(between(&[], 0.5), None);
    }
}
