//! Singular values and right singular vectors by one-sided Jacobi rotations (Hestenes 1958).
//!
//! Chosen over a QL iteration on XᵀX because the small singular values, the slowly decaying modes, then
//! keep an absolute error of rounding size instead of its square root.

use super::matrix::{Matrix, dot};

/// Most sweeps; convergence is quadratic and takes about eight.
const SWEEPS: usize = 40;

/// Columns whose angle differs from 90° by less count as orthogonal.
const ORTHOGONAL: f64 = 1e-14;

/// Singular values σⱼ and rows vⱼ with X vⱼ = σⱼ uⱼ, for X given by its columns as the rows of `columns`.
pub(crate) fn singular(mut columns: Matrix) -> (Vec<f64>, Matrix) {
    let n = columns.size();
    let mut vectors = Matrix::from_fn(n, |i, j| if i == j { 1.0 } else { 0.0 });
    for _ in 0..SWEEPS {
        if !sweep(&mut columns, &mut vectors) {
            break;
        }
    }
    (squares(&columns).into_iter().map(f64::sqrt).collect(), vectors)
}

fn squares(columns: &Matrix) -> Vec<f64> {
    (0..columns.size()).map(|i| dot(columns.row(i), columns.row(i))).collect()
}

/// One round over all pairs; whether any was rotated. The same bits on every processor: nothing is fused or
/// reordered.
#[multiversion::multiversion(targets("x86_64+avx512f+avx512dq+avx512vl", "x86_64+avx2"))]
fn sweep(columns: &mut Matrix, vectors: &mut Matrix) -> bool {
    let mut squares = squares(columns);
    let mut rotated = false;
    for i in 0..squares.len() {
        for j in i + 1..squares.len() {
            let (a, b) = columns.two_rows(i, j);
            let product = dot(a, b);
            if product.abs() <= ORTHOGONAL * (squares[i] * squares[j]).sqrt() {
                continue;
            }
            let zeta = (squares[j] - squares[i]) / (2.0 * product);
            let tangent = zeta.signum() / (zeta.abs() + (1.0 + zeta * zeta).sqrt());
            squares[i] = (squares[i] - tangent * product).max(0.0);
            squares[j] += tangent * product;
            rotate(a, b, tangent);
            let (a, b) = vectors.two_rows(i, j);
            rotate(a, b, tangent);
            rotated = true;
        }
    }
    rotated
}

#[inline]
fn rotate(a: &mut [f64], b: &mut [f64], tangent: f64) {
    let cosine = 1.0 / (1.0 + tangent * tangent).sqrt();
    let sine = cosine * tangent;
    for (x, y) in a.iter_mut().zip(b) {
        (*x, *y) = (cosine * *x - sine * *y, sine * *x + cosine * *y);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::solve::matrix::eigenvalues_are_off;

    #[test]
    fn known_eigenvalues_are_found() {
        let (values, vectors) = singular(Matrix::second_difference(12));
        assert!(eigenvalues_are_off(values) < 1e-13);
        assert!((dot(vectors.row(0), vectors.row(0)) - 1.0).abs() < 1e-13);
        assert!(dot(vectors.row(0), vectors.row(5)).abs() < 1e-13);
    }
}
