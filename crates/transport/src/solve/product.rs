//! Rows times a matrix, in a processor's lanes.
//!
//! Each element is summed in the order of the matrix's rows, nothing fused: the bits are the same on every processor.

/// Elements side by side in one tile of the product.
const LANES: usize = 8;

/// Rows of one tile.
const ROWS: usize = 8;

/// Each row of `rows`, `count` numbers long, times the matrix of `count` rows and `width` columns.
#[multiversion::multiversion(targets("x86_64+avx512f+avx512dq+avx512vl", "x86_64+avx2"))]
pub(crate) fn product(rows: &[f64], matrix: &[f64], (count, width): (usize, usize)) -> Vec<f64> {
    let mut product = vec![0.0; rows.len() / count * width];
    if width == 0 {
        return product;
    }
    let tiles = rows.chunks(ROWS * count).zip(product.chunks_mut(ROWS * width));
    for (rows, product) in tiles {
        if product.len() == ROWS * width {
            band::<ROWS>(rows, matrix, (count, width), product);
        } else {
            let each = rows.chunks_exact(count).zip(product.chunks_exact_mut(width));
            each.for_each(|(row, product)| band::<1>(row, matrix, (count, width), product));
        }
    }
    product
}

/// `R` rows of the product.
#[inline(always)]
fn band<const R: usize>(rows: &[f64], matrix: &[f64], (count, width): (usize, usize), product: &mut [f64]) {
    let rows: [&[f64]; R] = std::array::from_fn(|r| &rows[r * count..(r + 1) * count]);
    let whole = width - width % LANES;
    for column in (0..whole).step_by(LANES) {
        tile::<R, LANES>(rows, matrix, (column, width), product);
    }
    for column in whole..width {
        tile::<R, 1>(rows, matrix, (column, width), product);
    }
}

/// `L` columns of them.
#[inline(always)]
fn tile<const R: usize, const L: usize>(
    rows: [&[f64]; R],
    matrix: &[f64],
    (column, width): (usize, usize),
    product: &mut [f64],
) {
    let mut sums = [[0.0; L]; R];
    for (j, line) in matrix.chunks_exact(width).enumerate() {
        let line = &line[column..column + L];
        for (sums, row) in sums.iter_mut().zip(rows) {
            let factor = row[j];
            sums.iter_mut().zip(line).for_each(|(sum, value)| *sum += factor * value);
        }
    }
    for (sums, product) in sums.iter().zip(product.chunks_exact_mut(width)) {
        product[column..column + L].copy_from_slice(sums);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_is_the_sum_over_the_inner_index() {
        for (rows, count, width) in [(1, 1, 1), (3, 5, 7), (8, 12, 8), (21, 4, 19)] {
            let left: Vec<f64> = (0..rows * count).map(|i| 1.0 / (i + 1) as f64).collect();
            let right: Vec<f64> = (0..count * width).map(|i| (i as f64 - 3.5) * 0.3).collect();
            let found = product(&left, &right, (count, width));
            for (place, value) in found.iter().enumerate() {
                let (i, k) = (place / width, place % width);
                let expected =
                    (0..count).fold(0.0, |sum, j| sum + left[i * count + j] * right[j * width + k]);
                assert_eq!(*value, expected, "{rows} {count} {width}: {i} {k}");
            }
            assert_eq!(found.len(), rows * width);
        }
    }
}
