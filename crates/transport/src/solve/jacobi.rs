//! Singular values and right singular vectors by one-sided Jacobi rotations (Hestenes 1958).
//!
//! Chosen over a QL iteration on XᵀX because the small singular values, the slowly decaying modes, then keep an
//! absolute error of rounding size instead of its square root.

use super::matrix::{Matrix, dot};

/// Most sweeps; convergence is quadratic and takes about eight.
const SWEEPS: usize = 40;

/// Singular values σⱼ and rows vⱼ with X vⱼ = σⱼ uⱼ, for X given by its columns as the rows of `columns`.
pub(crate) fn singular(mut columns: Matrix) -> (Vec<f64>, Matrix) {
    let n = columns.size();
    let mut vectors = Matrix::from_fn(n, |i, j| if i == j { 1.0 } else { 0.0 });
    for _ in 0..SWEEPS {
        let mut rotated = false;
        for i in 0..n {
            for j in i + 1..n {
                let (a, b) = columns.two_rows(i, j);
                if let Some((cosine, sine)) = rotation(a, b) {
                    rotate(a, b, cosine, sine);
                    let (a, b) = vectors.two_rows(i, j);
                    rotate(a, b, cosine, sine);
                    rotated = true;
                }
            }
        }
        if !rotated {
            break;
        }
    }
    let values = (0..n).map(|i| dot(columns.row(i), columns.row(i)).sqrt()).collect();
    (values, vectors)
}

/// Cosine and sine of the rotation that makes `a` and `b` orthogonal, unless they are.
fn rotation(a: &[f64], b: &[f64]) -> Option<(f64, f64)> {
    let (aa, bb, ab) = (dot(a, a), dot(b, b), dot(a, b));
    if ab.abs() <= 2e-15 * (aa * bb).sqrt() || ab == 0.0 {
        return None;
    }
    let zeta = (bb - aa) / (2.0 * ab);
    let tangent = zeta.signum() / (zeta.abs() + (1.0 + zeta * zeta).sqrt());
    let cosine = 1.0 / (1.0 + tangent * tangent).sqrt();
    Some((cosine, cosine * tangent))
}

fn rotate(a: &mut [f64], b: &mut [f64], cosine: f64, sine: f64) {
    for (x, y) in a.iter_mut().zip(b) {
        (*x, *y) = (cosine * *x - sine * *y, sine * *x + cosine * *y);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The second difference matrix has eigenvalues 4 sin²(jπ/2(n+1)).
    #[test]
    fn known_eigenvalues_are_found() {
        let n = 12;
        let second = Matrix::from_fn(n, |i, j| match i.abs_diff(j) {
            0 => 2.0,
            1 => -1.0,
            _ => 0.0,
        });
        let (mut values, vectors) = singular(second);
        values.sort_by(f64::total_cmp);
        for (j, value) in values.iter().enumerate() {
            let sine = libm::sin((j + 1) as f64 * std::f64::consts::PI / (2 * n + 2) as f64);
            assert!((value - 4.0 * sine * sine).abs() < 1e-13);
        }
        assert!((dot(vectors.row(0), vectors.row(0)) - 1.0).abs() < 1e-13);
        assert!(dot(vectors.row(0), vectors.row(5)).abs() < 1e-13);
    }
}
