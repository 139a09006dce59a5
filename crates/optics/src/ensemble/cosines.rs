//! The functions π_n as cosine series, and the series of many spheres' amplitudes.
//!
//! With c_n = (2n+1)/(n(n+1)), A = Σ c_n a_n π_n and B = Σ c_n b_n π_n, the amplitudes are S1 = A + DB and S2 = B + DA, because
//! τ_n = d/dΘ (sinΘ π_n) (Bohren & Huffman 1983, eq. 4.46): D takes Σ A_k cos kΘ to Σ ½k(A_{k-1} - A_{k+1}) cos kΘ, A_0
//! counting twice. In c_n π_n = Σ t_nk cos kΘ only k = n-1, n-3, … stand. The recurrence of π_n holds for its series as it does
//! at an angle; a factor cosΘ moves each term half to both neighbours. The rounding error of a term is at most that at the
//! worst angle.

use crate::mie::{LANES, Lanes};

/// Terms of a series that are summed together: `TILE` times every other k.
const TILE: usize = 4;

/// A_k and B_k: Re A, Im A, Re B, Im B.
pub(super) type Term = [Lanes; 4];

/// t_nk of every order.
pub(super) struct CosineTerms {
    /// Tile T of even or odd k holds 2·`TILE`·T, … or one more, for n = k+1, k+3, … of its first k; terms beyond k = n-1 are 0.
    tiles: [Vec<Vec<[f64; TILE]>>; 2],
}

impl CosineTerms {
    /// Orders 1 to `last`.
    pub(super) fn new(last: usize) -> Self {
        let mut tiles = [vec![Vec::new(); last / (2 * TILE) + 1], vec![Vec::new(); last / (2 * TILE) + 1]];
        let mut pi = vec![0.0; last + 2 * TILE + 1];
        let mut before = pi.clone();
        pi[0] = 1.0;
        for order in 1..=last {
            let (n, odd) = (order as f64, (order - 1) % 2);
            let c = (2.0 * n + 1.0) / (n * (n + 1.0));
            for (i, tile) in tiles[odd].iter_mut().enumerate().take((order - 1 - odd) / (2 * TILE) + 1) {
                tile.push(std::array::from_fn(|j| c * pi[odd + 2 * (TILE * i + j)]));
            }
            for k in (order % 2..=order).step_by(2) {
                let s = times_cosine(&pi, k);
                before[k] = s + (n + 1.0) / n * (s - before[k]);
            }
            std::mem::swap(&mut pi, &mut before);
        }
        Self { tiles }
    }

    /// The series of spheres with coefficients `orders` (Re a, Im a, Re b, Im b), and two zeros after their last term.
    #[inline(always)]
    pub(super) fn series(&self, orders: &[Term], series: &mut Vec<Term>) {
        const ZERO: Term = [Lanes([0.0; LANES]); 4];
        series.resize(orders.len() + 2 * TILE, ZERO);
        series[orders.len()..].fill(ZERO);
        for (odd, tiles) in self.tiles.iter().enumerate() {
            for (tile, first) in tiles.iter().zip((odd..orders.len()).step_by(2 * TILE)) {
                for part in [0, 1, 2, 3] {
                    let sums = tile_sums(tile, &orders[first..], part);
                    sums.iter().enumerate().for_each(|(j, sum)| series[first + 2 * j][part] = Lanes(*sum));
                }
            }
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
fn tile_sums(tile: &[[f64; TILE]], orders: &[Term], part: usize) -> [[f64; LANES]; TILE] {
    let mut sums = [[0.0; LANES]; TILE];
    for (terms, order) in tile.iter().zip(orders.iter().step_by(2)) {
        let row = &order[part].0;
        for (sum, t) in sums.iter_mut().zip(terms) {
            for l in 0..LANES {
                sum[l] += t * row[l];
            }
        }
    }
    sums
}

#[cfg(test)]
mod tests {
    use super::*;

    /// π_1 = 1, π_2 = 3μ, π_3 = (15μ²-3)/2 (Bohren & Huffman 1983, section 4.3.1) as cosines, times 3/2, 5/6, 7/12.
    #[test]
    fn the_first_series_are_those_by_hand() {
        let terms = CosineTerms::new(4);
        let of = |odd: usize, row: usize| terms.tiles[odd][0][row];
        let close = |found: [f64; TILE], expected: [f64; 2]| {
            (0..TILE).all(|j| (found[j] - expected.get(j).unwrap_or(&0.0)).abs() < 1e-15)
        };
        assert!(close(of(0, 0), [1.5, 0.0]));
        assert!(close(of(1, 0), [2.5, 0.0]));
        assert!(close(of(0, 1), [2.25 * 7.0 / 12.0, 3.75 * 7.0 / 12.0]));
    }
}
