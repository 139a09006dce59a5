//! A small dense matrix, stored by columns.

use std::ops::Range;

/// Rows of a product worked out side by side.
const BLOCK: usize = 32;

/// Dense `rows` × `columns` matrix of f64.
#[derive(Clone, Debug, PartialEq)]
pub struct Matrix {
    rows: usize,
    columns: usize,
    data: Vec<f64>,
}

impl Matrix {
    /// All zeros.
    pub fn zeros(rows: usize, columns: usize) -> Self {
        Self { rows, columns, data: vec![0.0; rows * columns] }
    }

    /// The square matrix whose element (i, j) is `element(i, j)`.
    pub fn square(size: usize, mut element: impl FnMut(usize, usize) -> f64) -> Self {
        let mut matrix = Self::zeros(size, size);
        for j in 0..size {
            for i in 0..size {
                matrix.data[j * size + i] = element(i, j);
            }
        }
        matrix
    }

    /// Number of rows.
    pub fn rows(&self) -> usize {
        self.rows
    }

    /// Number of columns.
    pub fn columns(&self) -> usize {
        self.columns
    }

    /// Element (i, j).
    pub fn get(&self, i: usize, j: usize) -> f64 {
        self.data[j * self.rows + i]
    }

    /// Sets element (i, j).
    pub fn set(&mut self, i: usize, j: usize, value: f64) {
        self.data[j * self.rows + i] = value;
    }

    /// Column j.
    pub fn column(&self, j: usize) -> &[f64] {
        &self.data[j * self.rows..(j + 1) * self.rows]
    }

    /// Column j, to be written.
    pub fn column_mut(&mut self, j: usize) -> &mut [f64] {
        &mut self.data[j * self.rows..(j + 1) * self.rows]
    }

    /// Two columns at once; `a` < `b`.
    pub(crate) fn two_columns(&mut self, a: usize, b: usize) -> (&[f64], &mut [f64]) {
        let (left, right) = self.data.split_at_mut(b * self.rows);
        (&left[a * self.rows..(a + 1) * self.rows], &mut right[..self.rows])
    }

    /// The listed columns, each times its factor.
    pub(crate) fn scaled_columns(&self, which: &[usize], factor: impl Fn(usize) -> f64) -> Self {
        let mut out = Self::zeros(self.rows, which.len());
        for (k, &j) in which.iter().enumerate() {
            for (to, from) in out.column_mut(k).iter_mut().zip(self.column(j)) {
                *to = from * factor(j);
            }
        }
        out
    }

    /// A·v.
    pub fn times(&self, v: &[f64]) -> Vec<f64> {
        let mut out = vec![0.0; self.rows];
        for (j, factor) in v.iter().enumerate() {
            for (sum, element) in out.iter_mut().zip(self.column(j)) {
                *sum += element * factor;
            }
        }
        out
    }

    /// Aᵀ·v.
    pub fn transposed_times(&self, v: &[f64]) -> Vec<f64> {
        (0..self.columns).map(|j| dot(self.column(j), v)).collect()
    }

    /// A·B.
    pub(crate) fn product(&self, other: &Self) -> Self {
        let mut out = Self::zeros(self.rows, other.columns);
        for first in (0..self.rows).step_by(BLOCK) {
            let rows = first..self.rows.min(first + BLOCK);
            for j in 0..other.columns {
                let mut sums = [0.0; BLOCK];
                for (k, factor) in other.column(j).iter().enumerate() {
                    let column = &self.column(k)[rows.clone()];
                    sums.iter_mut().zip(column).for_each(|(sum, element)| *sum += element * factor);
                }
                out.column_mut(j)[rows.clone()].copy_from_slice(&sums[..rows.len()]);
            }
        }
        out
    }

    /// Whether every element is finite.
    pub fn is_finite(&self) -> bool {
        self.data.iter().all(|value| value.is_finite())
    }
}

/// Sums side by side.
const LANES: usize = 8;

/// Σ aᵢbᵢ, in lanes.
pub(crate) fn dot(a: &[f64], b: &[f64]) -> f64 {
    let (a, a_rest) = a.as_chunks::<LANES>();
    let (b, b_rest) = b.as_chunks::<LANES>();
    let mut sums = [0.0; LANES];
    for (a, b) in a.iter().zip(b) {
        (0..LANES).for_each(|i| sums[i] += a[i] * b[i]);
    }
    let rest = a_rest.iter().zip(b_rest).fold(0.0, |sum, (a, b)| sum + a * b);
    sums.iter().fold(rest, |sum, lane| sum + lane)
}

/// Squares of lengths that neither overflow nor underflow.
const PLAIN: Range<f64> = 1e-200..1e200;

/// Euclidean norm, scaled so that no square overflows or underflows.
pub(crate) fn norm(v: &[f64]) -> f64 {
    let square = dot(v, v);
    if PLAIN.contains(&square) {
        return square.sqrt();
    }
    let largest = v.iter().fold(0.0_f64, |m, x| if x.is_nan() { f64::NAN } else { m.max(x.abs()) });
    if largest == 0.0 || !largest.is_finite() {
        return largest;
    }
    largest * v.iter().fold(0.0, |sum, x| sum + (x / largest) * (x / largest)).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_product_is_one_of_its_columns() {
        let element = |i: usize, j: usize| (1 + i * i + 3 * j) as f64 / (2 + i + j) as f64;
        let mut a = Matrix::zeros(2 * BLOCK + 3, 4);
        (0..a.rows).for_each(|i| (0..4).for_each(|j| a.set(i, j, element(i, j))));
        let b = Matrix::square(4, element);
        let product = a.product(&b);
        (0..4).for_each(|j| assert_eq!(product.column(j), a.times(b.column(j))));
    }

    #[test]
    fn norms_neither_overflow_nor_hide_nan() {
        assert!((norm(&[3e200, 4e200]) / 5e200 - 1.0).abs() < 1e-15);
        assert!((norm(&[3e-200, 4e-200]) / 5e-200 - 1.0).abs() < 1e-15);
        assert!(norm(&[1.0, f64::NAN, 2.0]).is_nan());
        assert_eq!(norm(&[]), 0.0);
    }
}
