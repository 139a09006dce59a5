//! QR factorisation with column pivoting by Householder reflections: A·Π = Q·R, |R₀₀| ≥ |R₁₁| ≥ ….
//!
//! Businger & Golub, Numer. Math. 7 (1965) 269; Golub & Van Loan, Matrix Computations, 5.2 and 5.4.
//! The number of rows may not be smaller than that of columns. Rank is the number of diagonal elements above
//! max(m, n)·ε·|R₀₀|.

use crate::matrix::{Matrix, dot, norm};

/// The factors of A·Π = Q·R.
#[derive(Clone, Debug)]
pub struct PivotedQr {
    /// R above the diagonal; below and on it the reflection vectors.
    reflectors: Matrix,
    diagonal: Vec<f64>,
    /// 2/|v|² of each reflection 1 - 2vvᵀ/|v|².
    weights: Vec<f64>,
    pivot: Vec<usize>,
    rank: usize,
}

impl PivotedQr {
    /// Factorises `a`, which has at least as many rows as columns.
    pub fn new(a: Matrix) -> Self {
        let n = a.columns();
        let mut qr = Self {
            reflectors: a,
            diagonal: Vec::with_capacity(n),
            weights: Vec::with_capacity(n),
            pivot: (0..n).collect(),
            rank: 0,
        };
        for k in 0..n {
            qr.bring_longest_to(k);
            qr.reflect(k);
        }
        let floor = qr
            .diagonal
            .first()
            .map_or(0.0, |first| first.abs() * f64::EPSILON * qr.reflectors.rows().max(n) as f64);
        qr.rank = qr.diagonal.iter().take_while(|d| d.abs() > floor).count();
        qr
    }

    fn bring_longest_to(&mut self, k: usize) {
        let n = self.pivot.len();
        let mut longest = (k, -1.0);
        for j in k..n {
            let length = norm(&self.reflectors.column(j)[k..]);
            if length > longest.1 {
                longest = (j, length);
            }
        }
        if longest.0 > k {
            for i in 0..self.reflectors.rows() {
                let (a, b) = (self.reflectors.get(i, k), self.reflectors.get(i, longest.0));
                self.reflectors.set(i, k, b);
                self.reflectors.set(i, longest.0, a);
            }
            self.pivot.swap(k, longest.0);
        }
    }

    /// Maps column k below row k onto the k-th axis, and the later columns with it.
    fn reflect(&mut self, k: usize) {
        let column = &mut self.reflectors.column_mut(k)[k..];
        let length = norm(column);
        if length == 0.0 {
            self.diagonal.push(0.0);
            self.weights.push(0.0);
            return;
        }
        let signed = if column[0] > 0.0 { -length } else { length };
        for value in column.iter_mut() {
            *value /= length;
        }
        column[0] -= signed / length;
        self.diagonal.push(signed);
        self.weights.push(2.0 / dot(column, column));
        for j in k + 1..self.pivot.len() {
            let (v, target) = self.reflectors.two_columns(k, j);
            apply(&v[k..], self.weights[k], &mut target[k..]);
        }
    }

    /// Numerical rank.
    #[cfg(test)]
    fn rank(&self) -> usize {
        self.rank
    }

    /// Whether every column is independent of the others.
    pub fn has_full_rank(&self) -> bool {
        self.rank == self.pivot.len()
    }

    /// The first n elements of Qᵀ·v.
    pub fn project(&self, v: &[f64]) -> Vec<f64> {
        let mut v = v.to_vec();
        for (k, weight) in self.weights.iter().enumerate() {
            apply(&self.reflectors.column(k)[k..], *weight, &mut v[k..]);
        }
        v.truncate(self.pivot.len());
        v
    }

    /// The x of least |A·x - v| given `project`ed v; what the rank leaves open is zero.
    pub fn solve(&self, projected: &[f64]) -> Vec<f64> {
        let mut x = projected[..self.rank].to_vec();
        for k in (0..self.rank).rev() {
            x[k] /= self.diagonal[k];
            let solved = x[k];
            for (i, value) in x.iter_mut().enumerate().take(k) {
                *value -= self.reflectors.get(i, k) * solved;
            }
        }
        let mut out = vec![0.0; self.pivot.len()];
        for (value, &place) in x.iter().zip(&self.pivot) {
            out[place] = *value;
        }
        out
    }

    /// y with Rᵀ·y = Πᵀ·v, for full rank: then |y|² = vᵀ(AᵀA)⁻¹v.
    pub fn solve_transposed(&self, v: &[f64]) -> Vec<f64> {
        let mut y: Vec<f64> = Vec::with_capacity(self.pivot.len());
        for (k, &place) in self.pivot.iter().enumerate() {
            let known = y.iter().enumerate().fold(0.0, |sum, (i, yi)| sum + self.reflectors.get(i, k) * yi);
            y.push((v[place] - known) / self.diagonal[k]);
        }
        y
    }

    /// F with F·Fᵀ = (AᵀA)⁻¹, or `None` below full rank.
    pub fn covariance_factor(&self) -> Option<Matrix> {
        if !self.has_full_rank() {
            return None;
        }
        let n = self.pivot.len();
        let mut factor = Matrix::zeros(n, n);
        for k in 0..n {
            let mut axis = vec![0.0; n];
            axis[k] = 1.0;
            factor.column_mut(k).copy_from_slice(&self.solve(&axis));
        }
        Some(factor)
    }

    /// R·Πᵀ: an n × n matrix with the same AᵀA.
    pub fn triangle(&self) -> Matrix {
        let n = self.pivot.len();
        let mut out = Matrix::zeros(n, n);
        for (k, &place) in self.pivot.iter().enumerate() {
            for i in 0..k {
                out.set(i, place, self.reflectors.get(i, k));
            }
            out.set(k, place, self.diagonal[k]);
        }
        out
    }
}

fn apply(v: &[f64], weight: f64, target: &mut [f64]) {
    let along = weight * dot(v, target);
    for (t, vi) in target.iter_mut().zip(v) {
        *t -= along * vi;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn example() -> Matrix {
        let mut a = Matrix::zeros(4, 3);
        for (j, column) in
            [[1.0, 2.0, 3.0, 4.0], [1e3, 0.0, -1e3, 5e2], [0.1, 0.4, -0.3, 0.2]].iter().enumerate()
        {
            a.column_mut(j).copy_from_slice(column);
        }
        a
    }

    #[test]
    fn an_exact_system_is_solved() {
        let (a, x) = (example(), [2.0, -0.003, 7.0]);
        let qr = PivotedQr::new(a.clone());
        let solved = qr.solve(&qr.project(&a.times(&x)));
        for (s, x) in solved.iter().zip(x) {
            assert!((s / x - 1.0).abs() < 1e-13);
        }
    }

    #[test]
    fn the_residual_is_orthogonal_to_the_columns() {
        let (a, v) = (example(), [1.0, -1.0, 2.0, 0.5]);
        let qr = PivotedQr::new(a.clone());
        let fit = a.times(&qr.solve(&qr.project(&v)));
        let rest: Vec<f64> = v.iter().zip(&fit).map(|(v, f)| v - f).collect();
        for (j, along) in a.transposed_times(&rest).iter().enumerate() {
            assert!(along.abs() < 1e-14 * norm(a.column(j)), "{along}");
        }
    }

    #[test]
    fn dependent_columns_lower_the_rank() {
        let mut a = example();
        let sum: Vec<f64> = a.column(0).iter().zip(a.column(2)).map(|(x, y)| x - 2.0 * y).collect();
        a.column_mut(1).copy_from_slice(&sum);
        let qr = PivotedQr::new(a);
        assert_eq!(qr.rank(), 2);
        assert!(qr.covariance_factor().is_none());
    }

    #[test]
    fn the_covariance_factor_inverts_the_triangle() {
        let qr = PivotedQr::new(example());
        let (factor, triangle) = (qr.covariance_factor().unwrap(), qr.triangle());
        for k in 0..3 {
            let unit = triangle.times(factor.column(k));
            for (i, u) in unit.iter().enumerate() {
                assert!((u - f64::from(u8::from(i == k))).abs() < 1e-12);
            }
        }
        let v = [0.3, 2.0, -1.0];
        let (y, w) = (norm(&qr.solve_transposed(&v)), norm(&factor.transposed_times(&v)));
        assert!((y / w - 1.0).abs() < 1e-12);
    }
}
