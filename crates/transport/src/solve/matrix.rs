//! Dense real matrices of a few dozen rows, and the factorisations the solver needs.
//!
//! Own code, because a general library (faer: 43 crates, 90 s to build) buys nothing at this size, picks
//! its kernels by processor and with them its last bits. Row-major; every loop runs in a fixed order.

use super::product::product;
use std::ops::{Index, IndexMut};

/// A square matrix.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Matrix {
    size: usize,
    data: Vec<f64>,
}

impl Matrix {
    pub(crate) fn zeros(size: usize) -> Self {
        Self { size, data: vec![0.0; size * size] }
    }

    pub(crate) fn from_fn(size: usize, f: impl Fn(usize, usize) -> f64) -> Self {
        let mut data = Vec::with_capacity(size * size);
        for i in 0..size {
            data.extend((0..size).map(|j| f(i, j)));
        }
        Self { size, data }
    }

    pub(crate) fn size(&self) -> usize {
        self.size
    }

    pub(crate) fn row(&self, i: usize) -> &[f64] {
        &self.data[i * self.size..(i + 1) * self.size]
    }

    pub(crate) fn row_mut(&mut self, i: usize) -> &mut [f64] {
        &mut self.data[i * self.size..(i + 1) * self.size]
    }

    /// Rows `i` and `j`, i < j, both to be changed.
    #[inline]
    pub(crate) fn two_rows(&mut self, i: usize, j: usize) -> (&mut [f64], &mut [f64]) {
        let (head, tail) = self.data.split_at_mut(j * self.size);
        (&mut head[i * self.size..(i + 1) * self.size], &mut tail[..self.size])
    }

    pub(crate) fn transposed(&self) -> Self {
        Self::from_fn(self.size, |i, j| self[(j, i)])
    }

    pub(crate) fn times(&self, other: &Self) -> Self {
        Self { size: self.size, data: product(&self.data, &other.data, (self.size, self.size)) }
    }

    /// Row vector times matrix.
    #[cfg(test)]
    fn times_row(&self, row: &[f64]) -> Vec<f64> {
        let mut product = vec![0.0; self.size];
        for (i, factor) in row.iter().enumerate() {
            add_scaled(&mut product, *factor, self.row(i));
        }
        product
    }

    /// Upper triangular U with UᵀU = self, of which the lower half is not read; a pivot that rounding made negative counts as zero.
    pub(crate) fn cholesky(self) -> Self {
        factor(self)
    }

    /// Solution of self · x = `right`, by elimination with row pivots. Destroys the matrix.
    pub(crate) fn solve(self, right: Vec<f64>) -> Vec<f64> {
        self.solve_each(vec![right]).swap_remove(0)
    }

    /// The same for several right sides.
    pub(crate) fn solve_each(self, rights: Vec<Vec<f64>>) -> Vec<Vec<f64>> {
        let (n, width) = (self.size, self.size + rights.len());
        let row = |i: usize| self.row(i).iter().copied().chain(rights.iter().map(move |right| right[i]));
        let mut rows: Vec<f64> = (0..n).flat_map(row).collect();
        eliminate(&mut rows, (n, width));
        (n..width).map(|column| rows.chunks_exact(width).map(|row| row[column]).collect()).collect()
    }

    /// Solution of self · X = `right`, this matrix being upper triangular.
    pub(crate) fn solve_upper(&self, right: Self) -> Self {
        substitute(self, right)
    }
}

#[multiversion::multiversion(targets("x86_64+avx512f+avx512dq+avx512vl", "x86_64+avx2"))]
fn factor(mut u: Matrix) -> Matrix {
    for i in 0..u.size {
        u.row_mut(i)[..i].fill(0.0);
        for k in 0..i {
            let (above, row) = u.two_rows(k, i);
            add_scaled(&mut row[i..], -above[i], &above[i..]);
        }
        let pivot = u[(i, i)].max(0.0).sqrt();
        let scale = |value: &mut f64| *value = if pivot > 0.0 { *value / pivot } else { 0.0 };
        u.row_mut(i)[i..].iter_mut().for_each(scale);
    }
    u
}

#[multiversion::multiversion(targets("x86_64+avx512f+avx512dq+avx512vl", "x86_64+avx2"))]
fn substitute(upper: &Matrix, mut right: Matrix) -> Matrix {
    for k in (0..right.size).rev() {
        for j in k + 1..right.size {
            let (row, below) = right.two_rows(k, j);
            add_scaled(row, -upper[(k, j)], below);
        }
        let pivot = upper[(k, k)];
        right.row_mut(k).iter_mut().for_each(|value| *value /= pivot);
    }
    right
}

/// Gaussian elimination of `n` rows, each with its right sides behind it, which become the solutions. In a processor's lanes:
/// nothing is fused or reordered, the bits are the same on all.
#[multiversion::multiversion(targets("x86_64+avx512f+avx512dq+avx512vl", "x86_64+avx2"))]
pub(crate) fn eliminate(rows: &mut [f64], (n, width): (usize, usize)) {
    for k in 0..n {
        let (above, below) = rows.split_at_mut((k + 1) * width);
        let top = &mut above[k * width..];
        // The largest element of column k.
        let larger = |best: &[f64], row: &[f64]| row[k].abs() > best[k].abs();
        let pivot =
            below.chunks_exact_mut(width).reduce(|best, row| if larger(best, row) { row } else { best });
        if let Some(pivot) = pivot.filter(|pivot| larger(top, pivot)) {
            top.swap_with_slice(pivot);
        }
        let inverse = 1.0 / top[k];
        for row in below.chunks_exact_mut(width) {
            let factor = row[k] * inverse;
            add_scaled(&mut row[k + 1..], -factor, &top[k + 1..]);
        }
    }
    for k in (0..n).rev() {
        let (above, below) = rows.split_at_mut((k + 1) * width);
        let (left, right) = above[k * width..].split_at_mut(n);
        let below = below.chunks_exact(width);
        left[k + 1..].iter().zip(below).for_each(|(factor, row)| add_scaled(right, -factor, &row[n..]));
        right.iter_mut().for_each(|value| *value /= left[k]);
    }
}

#[cfg(test)]
impl Matrix {
    /// 2 on the diagonal, -1 beside it: eigenvalues 4 sin²(jπ/2(n+1)), j = 1…n.
    pub(crate) fn second_difference(size: usize) -> Self {
        Self::from_fn(size, |i, j| match i.abs_diff(j) {
            0 => 2.0,
            1 => -1.0,
            _ => 0.0,
        })
    }
}

/// Largest distance of `values`, in any order, from the eigenvalues of the second difference.
#[cfg(test)]
pub(crate) fn eigenvalues_are_off(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    let angle = std::f64::consts::PI / (2 * values.len() + 2) as f64;
    values.iter().enumerate().fold(0.0, |most, (j, value)| {
        let sine = libm::sin((j + 1) as f64 * angle);
        most.max((value - 4.0 * sine * sine).abs())
    })
}

impl Index<(usize, usize)> for Matrix {
    type Output = f64;
    fn index(&self, (i, j): (usize, usize)) -> &f64 {
        &self.data[i * self.size + j]
    }
}

impl IndexMut<(usize, usize)> for Matrix {
    fn index_mut(&mut self, (i, j): (usize, usize)) -> &mut f64 {
        &mut self.data[i * self.size + j]
    }
}

/// `target` += `factor` · `source`.
#[inline(always)]
pub(crate) fn add_scaled(target: &mut [f64], factor: f64, source: &[f64]) {
    target.iter_mut().zip(source).for_each(|(t, s)| *t += factor * s);
}

/// `target` += `a` · `b`, element by element.
#[inline(always)]
pub(crate) fn add_products(target: &mut [f64], a: &[f64], b: &[f64]) {
    target.iter_mut().zip(a.iter().zip(b)).for_each(|(t, (a, b))| *t += a * b);
}

/// Σ aᵢbᵢ in eight lanes.
#[inline]
pub(crate) fn dot(a: &[f64], b: &[f64]) -> f64 {
    let mut lanes = [0.0; 8];
    let (a8, b8) = (a.chunks_exact(8), b.chunks_exact(8));
    for (lane, (x, y)) in lanes.iter_mut().zip(a8.remainder().iter().zip(b8.remainder())) {
        *lane = x * y;
    }
    for (x, y) in a8.zip(b8) {
        for i in 0..8 {
            lanes[i] += x[i] * y[i];
        }
    }
    let [a, b, c, d, e, f, g, h] = lanes;
    ((a + e) + (c + g)) + ((b + f) + (d + h))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Hilbert-like but well conditioned: 1/(i+j+1) + δ.
    fn sample(n: usize) -> Matrix {
        Matrix::from_fn(n, |i, j| 1.0 / (i + j + 1) as f64 + if i == j { 1.0 } else { 0.0 })
    }

    #[test]
    fn elimination_and_cholesky_undo_multiplication() {
        for n in [1, 2, 5, 17] {
            let a = sample(n);
            let x: Vec<f64> = (0..n).map(|i| 1.0 - 0.3 * i as f64).collect();
            let solved = a.clone().solve(a.times_row(&x));
            assert!(solved.iter().zip(&x).all(|(s, x)| (s - x).abs() < 1e-12), "{n}");
            let u = a.clone().cholesky();
            let product = u.transposed().times(&u);
            assert!((0..n * n).all(|i| (product.data[i] - a.data[i]).abs() < 1e-13), "{n}");
            let solved = u.solve_upper(u.times(&a));
            assert!((0..n * n).all(|i| (solved.data[i] - a.data[i]).abs() < 1e-12), "{n}");
        }
    }
}
