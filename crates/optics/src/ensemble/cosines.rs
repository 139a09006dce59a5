//! The functions p_n = π_n + τ_n as cosine series, and the series of many spheres' amplitudes.
//!
//! p_n(cosΘ) = Σ_{k≤n} t_nk cos kΘ. The recurrences of π_n and τ_n hold for the series as they do at an angle; a factor
//! cosΘ moves each term half to both neighbours. The rounding error of a term is at most that at the worst angle.

use crate::mie::{LANES, Lanes};

/// Terms of a series that are summed together.
const TILE: usize = 4;

/// t_nk of every order.
pub(super) struct CosineTerms {
    /// Tile T holds k = `TILE`·T …, from order max(1, `TILE`·T) on; terms beyond k = n are 0.
    tiles: Vec<Vec<[f64; TILE]>>,
}

impl CosineTerms {
    /// Orders 1 to `last`.
    pub(super) fn new(last: usize) -> Self {
        let mut tiles: Vec<Vec<[f64; TILE]>> = vec![Vec::new(); last / TILE + 1];
        let mut pi = vec![0.0; last + 2 * TILE];
        let mut before = pi.clone();
        let mut term = pi.clone();
        pi[0] = 1.0;
        for order in 1..=last {
            let n = order as f64;
            for k in 0..=order {
                let s = times_cosine(&pi, k);
                let t = s - before[k];
                term[k] = pi[k] + (n * t - before[k]);
                before[k] = s + (n + 1.0) / n * t;
            }
            std::mem::swap(&mut pi, &mut before);
            for (tile, terms) in tiles.iter_mut().zip(term.as_chunks().0).take(order / TILE + 1) {
                tile.push(*terms);
            }
        }
        Self { tiles }
    }

    /// Calls `at` with each k up to the last order and X_k = Σ_n t_nk x_n, where x_n is the complex number at `part` and
    /// `part` + 1 of every order.
    #[inline(always)]
    pub(super) fn series(
        &self,
        orders: &[[Lanes; 4]],
        part: usize,
        mut at: impl FnMut(usize, &Lanes, &Lanes),
    ) {
        for (i, tile) in self.tiles.iter().enumerate().take(orders.len() / TILE + 1) {
            let orders = &orders[(TILE * i).max(1) - 1..];
            let (re, im) = (tile_sums(tile, orders, part), tile_sums(tile, orders, part + 1));
            re.iter().zip(&im).enumerate().for_each(|(k, (re, im))| at(TILE * i + k, re, im));
        }
    }
}

/// Term `k` of cosΘ Σ a_k cos kΘ.
fn times_cosine(a: &[f64], k: usize) -> f64 {
    match k {
        0 => 0.5 * a[1],
        1 => a[0] + 0.5 * a[2],
        _ => 0.5 * (a[k - 1] + a[k + 1]),
    }
}

#[inline(always)]
fn tile_sums(tile: &[[f64; TILE]], orders: &[[Lanes; 4]], part: usize) -> [Lanes; TILE] {
    let mut sums = [[0.0; LANES]; TILE];
    for (terms, order) in tile.iter().zip(orders) {
        let row = &order[part].0;
        for (sum, t) in sums.iter_mut().zip(terms) {
            for l in 0..LANES {
                sum[l] += t * row[l];
            }
        }
    }
    sums.map(Lanes)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// π_2 = 3μ, τ_2 = 6μ²-3 and π_3 = (15μ²-3)/2, τ_3 = (45μ³-33μ)/2 (Bohren & Huffman 1983, section 4.3.1) as cosines.
    #[test]
    fn the_first_series_are_those_by_hand() {
        let terms = CosineTerms::new(4);
        let term = |n: usize, k: usize| terms.tiles[k / TILE][n - (TILE * (k / TILE)).max(1)][k % TILE];
        let of = |n: usize| (0..=n).map(|k| term(n, k)).collect::<Vec<_>>();
        assert_eq!(of(1), [1.0, 1.0]);
        assert_eq!(of(2), [0.0, 3.0, 3.0]);
        assert_eq!(of(3), [2.25, 0.375, 3.75, 5.625]);
    }
}
