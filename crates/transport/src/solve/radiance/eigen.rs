//! Eigenvalues and eigenvectors of a symmetric matrix: Householder's tridiagonal form, then the implicit QL
//! iteration (Golub & Van Loan 2013, §8.3; Wilkinson & Reinsch 1971, II/2 and II/4).
//!
//! One reduction where Jacobi's rotations need several sweeps. Its absolute error is ε times the largest eigenvalue, which
//! the azimuthal mean of a lossless medium (smallest eigenvalue 0) does not bear and every other mode does.
//! Vectors are rows, so that all inner loops run along memory. Elements should grow towards the last row.

use crate::solve::matrix::{Matrix, add_scaled, dot};

/// Most QL steps for one eigenvalue; two or three are usual.
const STEPS: usize = 60;

/// Singular values σ_j of X and left vectors, from XXᵀ, `x` given by rows: the same answer as `jacobi::singular`.
pub(super) fn singular(x: &Matrix) -> (Vec<f64>, Matrix) {
    let (values, vectors) = symmetric(x.times(&x.transposed()));
    (values.into_iter().map(|value| value.max(0.0).sqrt()).collect(), vectors)
}

/// Eigenvalues, unsorted, and eigenvectors as rows.
pub(super) fn symmetric(mut a: Matrix) -> (Vec<f64>, Matrix) {
    let n = a.size();
    let (mut off, heights) = reduce(&mut a);
    let mut diagonal: Vec<f64> = (0..n).map(|i| a[(i, i)]).collect();
    let mut vectors = accumulate(&a, &heights);
    iterate(&mut diagonal, &mut off, &mut vectors);
    (diagonal, vectors)
}

/// Tridiagonal form: returns the elements below the diagonal (element i in row i+1) and uᵀu/2 of each reflector u,
/// which replaces its row of `a`.
#[multiversion::multiversion(targets("x86_64+avx512f+avx512dq+avx512vl", "x86_64+avx2"))]
fn reduce(a: &mut Matrix) -> (Vec<f64>, Vec<f64>) {
    let n = a.size();
    let (mut off, mut heights) = (vec![0.0; n], vec![0.0; n]);
    for i in (1..n).rev() {
        let mut u = a.row(i)[..i].to_vec();
        let last = u[i - 1];
        let square = dot(&u, &u);
        if square == last * last {
            off[i - 1] = last;
            continue;
        }
        let image = if last > 0.0 { -square.sqrt() } else { square.sqrt() };
        off[i - 1] = image;
        let height = square - last * image;
        u[i - 1] = last - image;
        let mut q: Vec<f64> = (0..i).map(|r| dot(&a.row(r)[..i], &u) / height).collect();
        let middle = dot(&u, &q) / (2.0 * height);
        add_scaled(&mut q, -middle, &u);
        for r in 0..i {
            let row = &mut a.row_mut(r)[..i];
            add_scaled(row, -u[r], &q);
            add_scaled(row, -q[r], &u);
        }
        a.row_mut(i)[..i].copy_from_slice(&u);
        heights[i] = height;
    }
    (off, heights)
}

/// The product of the reflectors.
#[multiversion::multiversion(targets("x86_64+avx512f+avx512dq+avx512vl", "x86_64+avx2"))]
fn accumulate(a: &Matrix, heights: &[f64]) -> Matrix {
    let n = a.size();
    let mut product = Matrix::from_fn(n, |i, j| if i == j { 1.0 } else { 0.0 });
    for i in (1..n).filter(|i| heights[*i] > 0.0) {
        let u = &a.row(i)[..i];
        for r in 0..i {
            let row = &mut product.row_mut(r)[..i];
            let factor = -dot(row, u) / heights[i];
            add_scaled(row, factor, u);
        }
    }
    product
}

/// Diagonalises the tridiagonal matrix and turns the rows of `vectors` along.
#[multiversion::multiversion(targets("x86_64+avx512f+avx512dq+avx512vl", "x86_64+avx2"))]
fn iterate(diagonal: &mut [f64], off: &mut [f64], vectors: &mut Matrix) {
    for low in 0..diagonal.len() {
        for _ in 0..STEPS {
            let high = block_end(diagonal, off, low);
            if high == low {
                break;
            }
            step(diagonal, off, vectors, low, high);
        }
    }
}

/// The last row coupled to row `low`.
fn block_end(diagonal: &[f64], off: &[f64], low: usize) -> usize {
    let coupled = |i: usize| off[i].abs() > f64::EPSILON * (diagonal[i].abs() + diagonal[i + 1].abs());
    (low..diagonal.len() - 1).find(|i| !coupled(*i)).unwrap_or(diagonal.len() - 1)
}

/// One implicit QL step with Wilkinson's shift on rows `low`…`high`.
#[inline]
fn step(diagonal: &mut [f64], off: &mut [f64], vectors: &mut Matrix, low: usize, high: usize) {
    let ratio = (diagonal[low + 1] - diagonal[low]) / (2.0 * off[low]);
    let root = (ratio * ratio + 1.0).sqrt();
    let shift = off[low] / (ratio + if ratio < 0.0 { -root } else { root });
    let mut bulge = diagonal[high] - diagonal[low] + shift;
    let (mut sine, mut cosine, mut moved) = (1.0, 1.0, 0.0);
    for i in (low..high).rev() {
        let (far, near) = (sine * off[i], cosine * off[i]);
        let radius = (far * far + bulge * bulge).sqrt();
        off[i + 1] = radius;
        if radius == 0.0 {
            diagonal[i + 1] -= moved;
            off[high] = 0.0;
            return;
        }
        (sine, cosine) = (far / radius, bulge / radius);
        let rest = diagonal[i + 1] - moved;
        let change = (diagonal[i] - rest) * sine + 2.0 * cosine * near;
        moved = sine * change;
        diagonal[i + 1] = rest + moved;
        bulge = cosine * change - near;
        let (a, b) = vectors.two_rows(i, i + 1);
        for (x, y) in a.iter_mut().zip(b) {
            (*x, *y) = (cosine * *x - sine * *y, sine * *x + cosine * *y);
        }
    }
    diagonal[low] -= moved;
    off[low] = bulge;
    off[high] = 0.0;
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::solve::matrix::eigenvalues_are_off;

    /// A graded matrix: A v = λ v, and the vectors are orthonormal.
    #[test]
    fn vectors_are_those_of_the_values() {
        for n in [1, 2, 3, 17, 40] {
            let a = Matrix::from_fn(n, |i, j| {
                let same = if i == j { (i + 1) as f64 } else { 0.0 };
                (same + 1.0 / (1 + i + j) as f64) * ((i + 1) * (j + 1)) as f64
            });
            let (values, vectors) = symmetric(a.clone());
            let most = values.iter().fold(0.0_f64, |most, value| most.max(value.abs()));
            for (j, value) in values.iter().enumerate() {
                let v = vectors.row(j);
                for i in 0..n {
                    assert!((dot(a.row(i), v) - value * v[i]).abs() < 1e-13 * most, "{n} {j}");
                    let expected = if i == j { 1.0 } else { 0.0 };
                    assert!((dot(vectors.row(i), v) - expected).abs() < 1e-13);
                }
            }
        }
    }

    #[test]
    fn known_eigenvalues_are_found() {
        let (values, _) = symmetric(Matrix::second_difference(12));
        assert!(eigenvalues_are_off(values) < 1e-13);
    }
}
