//! Distribution of Kolmogorov's D_n = sup|F_n - F| and Smirnov's D_{m,n} = sup|F_m - G_n|, for continuous F = G.
//!
//! One sample, n ≤ 1000: exact, by the matrix form of Durbin's recursion (Marsaglia, Tsang & Wang 2003, J. Stat. Softw. 8(18));
//! twice the one-sided tail of Birnbaum & Tingey (1951, Ann. Math. Stat. 22, 592), small p without cancellation, where d ≥ ½
//! (exact) or n d² > 2.25 (p < 0.022; too large by a factor of at most 1 + 2e-6). Larger n: Kolmogorov's limit at
//! √n d + 1/(6√n) + (√n d - 1)/4n (Vrbik 2020, Mathematica J. 22), within 1 % of p and 3e-5.
//!
//! Two samples: exact while m n ≤ 10⁷, by counting the lattice paths that leave the band |i/m - j/n| < d (Hodges 1958, Ark.
//! Mat. 3, 469); beyond, for m = n by the reflection principle (Gnedenko & Korolyuk 1951, Dokl. Akad. Nauk SSSR 80, 525), for
//! other sizes the one-sample tail of the whole number k nearest to mn/(m+n) at the same √k d, not below the probability
//! 2/C(m+n, m) of samples without overlap: within 3 % of p down to p = 1e-5, and the better the more the sizes differ.

use std::f64::consts::PI;

/// Largest sample for Durbin's matrix.
const MATRIX_SAMPLE: usize = 1000;
/// n d² from which both one-sided deviations at once have no weight.
const TAIL: f64 = 2.25;
/// Largest m n for which lattice paths are counted.
const LATTICE: u128 = 10_000_000;

/// P(D_n ≥ d), n ≥ 1.
pub fn one_sample_tail(n: usize, d: f64) -> f64 {
    let size = n as f64;
    if d >= 1.0 {
        0.0
    } else if 2.0 * size * d <= 1.0 {
        1.0
    } else if d >= 0.5 || size * d * d > TAIL {
        2.0 * one_sided_tail(n, d)
    } else if n <= MATRIX_SAMPLE {
        1.0 - durbin(n, d)
    } else {
        let x = size.sqrt() * d;
        limit_tail(x + 1.0 / (6.0 * size.sqrt()) + (x - 1.0) / (4.0 * size))
    }
}

/// P(sup(F_n - F) ≥ d) = d Σ_j C(n,j) (d + j/n)^{j-1} (1 - d - j/n)^{n-j} over j ≤ n(1-d): every term positive.
fn one_sided_tail(n: usize, d: f64) -> f64 {
    let size = n as f64;
    let log_factorial = |k: f64| libm::lgamma(k + 1.0);
    let term = |j: usize| {
        let j = j as f64;
        let (up, down) = (d + j / size, 1.0 - d - j / size);
        let choose = log_factorial(size) - log_factorial(j) - log_factorial(size - j);
        if down <= 0.0 {
            return 0.0;
        }
        libm::exp(choose + (j - 1.0) * libm::log(up) + (size - j) * libm::log(down))
    };
    d * (0..n).map(term).fold(0.0, |sum, term| sum + term)
}

/// P(D_n < d) = n!/nⁿ (Hⁿ)_{kk} with H of order 2k - 1, k = ⌊nd⌋ + 1.
fn durbin(n: usize, d: f64) -> f64 {
    let k = (n as f64 * d) as usize + 1;
    let (m, h) = (2 * k - 1, k as f64 - n as f64 * d);
    let mut result = Scaled::power(&Scaled { entries: durbin_matrix(m, h), exponent: 0 }, m, n);
    let mut value = result.entries[(k - 1) * m + k - 1];
    for i in 1..=n {
        value *= i as f64 / n as f64;
        if value < RESCALE.recip() {
            value *= RESCALE;
            result.exponent -= RESCALE_EXPONENT;
        }
    }
    libm::ldexp(value, result.exponent)
}

/// 1/(i-j+1)! on and below the superdiagonal; the first column and the last row take off what leaves the band.
fn durbin_matrix(m: usize, h: f64) -> Vec<f64> {
    let mut inverse_factorials = vec![1.0; m + 2];
    let mut powers = vec![1.0; m + 1];
    for i in 1..=m {
        inverse_factorials[i + 1] = inverse_factorials[i] / (i + 1) as f64;
        powers[i] = powers[i - 1] * h;
    }
    let inverse = |k: usize| inverse_factorials[k];
    let mut entries = vec![0.0; m * m];
    for i in 0..m {
        for j in 0..m.min(i + 2) {
            entries[i * m + j] = inverse(i + 1 - j);
        }
    }
    for i in 0..m {
        entries[i * m] -= powers[i + 1] * inverse(i + 1);
        entries[(m - 1) * m + i] -= powers[m - i] * inverse(m - i);
    }
    let twice = (0..m).fold(1.0, |product, _| product * (2.0 * h - 1.0).max(0.0));
    entries[(m - 1) * m] += twice * inverse(m);
    entries
}

const RESCALE_EXPONENT: i32 = 400;
/// 2⁴⁰⁰.
const RESCALE: f64 = f64::from_bits(((1023 + RESCALE_EXPONENT as i64) << 52) as u64);

/// A square matrix times 2^exponent.
#[derive(Clone)]
struct Scaled {
    entries: Vec<f64>,
    exponent: i32,
}

impl Scaled {
    /// The `n`-th power of a matrix of order `m`, n ≥ 1, by squaring.
    fn power(base: &Self, m: usize, n: usize) -> Self {
        if n == 1 {
            return base.clone();
        }
        let half = Self::power(base, m, n / 2);
        let square = half.times(&half, m);
        if n.is_multiple_of(2) { square } else { square.times(base, m) }
    }

    fn times(&self, other: &Self, m: usize) -> Self {
        let mut product = vec![0.0; m * m];
        for (row, left) in product.chunks_exact_mut(m).zip(self.entries.chunks_exact(m)) {
            for (a, right) in left.iter().zip(other.entries.chunks_exact(m)) {
                row.iter_mut().zip(right).for_each(|(sum, b)| *sum += a * b);
            }
        }
        let mut exponent = self.exponent + other.exponent;
        if product[m / 2 * (m + 1)] > RESCALE.sqrt() {
            product.iter_mut().for_each(|entry| *entry /= RESCALE);
            exponent += RESCALE_EXPONENT;
        }
        Self { entries: product, exponent }
    }
}

/// P(D_{m,n} ≥ steps/(mn)), m and n ≥ 1.
pub fn two_sample_tail(m: usize, n: usize, steps: u128) -> f64 {
    let cells = m as u128 * n as u128;
    if cells <= LATTICE {
        return paths_that_leave(m, n, steps);
    }
    if m == n {
        return reflected_paths(n, (steps.div_ceil(n as u128)) as usize);
    }
    let effective = cells as f64 / (m as f64 + n as f64);
    let whole = libm::round(effective).max(1.0);
    let tail = one_sample_tail(whole as usize, (effective / whole).sqrt() * (steps as f64 / cells as f64));
    tail.max(separate(m as f64, n as f64))
}

/// P(D_{m,n} = 1): all of one sample below all of the other.
fn separate(m: f64, n: f64) -> f64 {
    let log_choose = libm::lgamma(m + n + 1.0) - libm::lgamma(m + 1.0) - libm::lgamma(n + 1.0);
    2.0 * libm::exp(-log_choose)
}

/// P(D_{n,n} ≥ k/n) = 2Σ(-1)^{j-1} C(2n, n-jk)/C(2n, n).
fn reflected_paths(n: usize, k: usize) -> f64 {
    if k == 0 {
        return 1.0;
    }
    // C(2n, n-shift)/C(2n, n)
    let ratio = |shift: usize| -> f64 {
        (0..shift).fold(1.0, |product, i| product * (n - i) as f64 / (n + shift - i) as f64)
    };
    let mut sum = 0.0;
    for j in 1..=n / k {
        let term = ratio(j * k);
        sum += if j % 2 == 1 { term } else { -term };
        if term < f64::EPSILON * sum.abs() {
            break;
        }
    }
    (2.0 * sum).clamp(0.0, 1.0)
}

/// Share of the lattice paths from (0, 0) to (m, n) that touch |i n - j m| ≥ `steps`.
///
/// A random path to (i, j) has its last step from (i-1, j) with probability i/(i+j).
fn paths_that_leave(m: usize, n: usize, steps: u128) -> f64 {
    let mut share = vec![0.0; n + 1];
    for i in 0..=m {
        for j in 0..=n {
            let left = (i as u128 * n as u128).abs_diff(j as u128 * m as u128) >= steps;
            share[j] = if left {
                1.0
            } else {
                let below = if j > 0 { share[j - 1] } else { 0.0 };
                (i as f64 * share[j] + j as f64 * below) / ((i + j) as f64).max(1.0)
            };
        }
    }
    share[n]
}

/// lim P(√n D_n ≥ x) = 2Σ(-1)^{j-1} e^{-2j²x²} (Kolmogorov 1933), below x = 1 through the theta function's other series.
pub fn limit_tail(x: f64) -> f64 {
    if x < 0.05 {
        return 1.0;
    }
    if x < 1.0 {
        let term = |j: u32| libm::exp(-f64::from((2 * j + 1) * (2 * j + 1)) * PI * PI / (8.0 * x * x));
        return 1.0 - (2.0 * PI).sqrt() / x * (0..4).map(term).fold(0.0, |sum, term| sum + term);
    }
    let term = |j: i32| f64::from(1 - 2 * (j % 2)) * libm::exp(-2.0 * f64::from((j + 1) * (j + 1)) * x * x);
    2.0 * (0..5).map(term).fold(0.0, |sum, term| sum + term)
}

#[cfg(test)]
mod tests {
    use super::*;
    use stratiform_reference_data::rows;

    fn close(value: f64, exact: f64, relative: f64) {
        assert!((value - exact).abs() <= relative * exact.abs(), "{value:e} against {exact:e}");
    }

    /// n! (2d - 1/n)ⁿ for 1/2n ≤ d ≤ 1/n, and 1 - 2(1-d)ⁿ for d ≥ 1 - 1/n.
    #[test]
    fn ends_are_the_closed_forms() {
        let power = |x: f64, n: usize| (0..n).fold(1.0, |product, _| product * x);
        for n in [1, 2, 3, 5, 8] {
            let size = n as f64;
            let factorial = (1..=n).fold(1.0, |product, k| product * k as f64);
            for t in [0.01, 0.3, 0.7, 0.999] {
                let d = (1.0 + t) / (2.0 * size);
                close(durbin(n, d), factorial * power(2.0 * d - 1.0 / size, n), 1e-11);
                let d = 1.0 - t / size.max(2.0);
                close(one_sample_tail(n, d), 2.0 * power(1.0 - d, n), 1e-12);
            }
        }
        assert_eq!([one_sample_tail(4, 0.125), one_sample_tail(4, 1.0)], [1.0, 0.0]);
    }

    /// A unit of the fifth decimal brackets every percentage point.
    #[test]
    fn percentage_points_are_millers() {
        let table: Vec<(usize, [f64; 4])> = rows("miller-1956", "percentage-points.csv").unwrap();
        assert_eq!(table.len(), 70);
        for (n, points) in table {
            for (d, alpha) in points.into_iter().zip([0.1, 0.05, 0.02, 0.01]) {
                let [below, above] = [d - 1.1e-5, d + 1.1e-5].map(|d| one_sample_tail(n, d));
                assert!(above < alpha && alpha < below, "n {n}, alpha {alpha}: {below} to {above}");
                // Five units are seen: the comparison is no formality.
                assert!(one_sample_tail(n, d + 5e-5) < alpha && one_sample_tail(n, d - 5e-5) > alpha);
            }
        }
    }

    #[test]
    fn probabilities_are_those_of_marsaglia_tsang_and_wang() {
        let table: Vec<(usize, f64, f64)> = rows("marsaglia-tsang-wang-2003", "probabilities.csv").unwrap();
        for (n, d, probability) in table {
            close(1.0 - one_sample_tail(n, d), probability, 2e-10);
        }
        close(durbin(2000, 0.04), 0.996_769_431_917_132_5, 1e-12);
    }

    #[test]
    fn the_limit_is_smirnovs() {
        let table: Vec<(f64, String)> = rows("smirnov-1948", "limit.csv").unwrap();
        for (x, printed) in table {
            let decimals = printed.len() - 2;
            assert_eq!(format!("{:.decimals$}", 1.0 - limit_tail(x)), printed, "{x}");
        }
        close(limit_tail(1.0 - 1e-12), limit_tail(1.0), 1e-10);
        assert_eq!(limit_tail(0.04), 1.0);
    }

    /// Both sides of every change of method.
    #[test]
    fn methods_meet_within_their_stated_accuracy() {
        for n in [20, 100, 1000] {
            let d = (TAIL / n as f64).sqrt();
            close(2.0 * one_sided_tail(n, d), 1.0 - durbin(n, d), 2e-6);
        }
        for x in [0.4, 0.7, 1.0, 1.3, 1.49] {
            let d = x / 1001.0_f64.sqrt();
            let (approximate, exact) = (one_sample_tail(1001, d), 1.0 - durbin(1001, d));
            assert!((approximate - exact).abs() < (0.01 * exact).min(3e-5), "{x}: {approximate} {exact}");
        }
    }

    /// Lattice paths of sizes for which they are no longer counted, and of those below.
    #[test]
    fn large_samples_are_within_three_percent() {
        let sizes = [
            (10, 1_000_001),
            (100, 100_001),
            (1000, 10_007),
            (2001, 6003),
            (2300, 4600),
            (3100, 3300),
            (3200, 3201),
        ];
        for (m, n) in sizes {
            let (a, b) = (m as f64, n as f64);
            for x in [0.8, 1.2, 1.6, 2.0, 2.2] {
                let steps = (x / (1.0 / a + 1.0 / b).sqrt().recip() * a * b) as u128;
                for (m, n) in [(m, n), (n, m)] {
                    let (stated, exact) = (two_sample_tail(m, n, steps), paths_that_leave(m, n, steps));
                    if exact > 1e-5 {
                        close(stated, exact, 0.03);
                    }
                }
                // Kolmogorov's limit, without regard to the smaller sample, is told from it.
                let exact = paths_that_leave(m, n, steps);
                assert!(m > 100 || limit_tail(x) > 1.04 * exact, "{m} {n} {x}");
            }
        }
        for (n, k) in [(3200, 80), (3200, 120), (10_000, 1), (10_000, 141)] {
            let exact = if n == 3200 { paths_that_leave(n, n, (k * n) as u128) } else { 0.0 };
            let stated = two_sample_tail(n, n, (k * n) as u128);
            let limit = limit_tail(k as f64 / (2.0 * n as f64).sqrt());
            close(stated, limit, 0.01);
            assert!(n > 3200 || (stated / exact - 1.0).abs() < 1e-9, "{n} {k}: {stated} {exact}");
        }
        // One value beside many: p is that of its rank.
        let n = 20_000_000_usize;
        close(two_sample_tail(1, n, n as u128), 2.0 / (n as f64 + 1.0), 1e-6);
    }

    /// Every order in which m + n values can fall.
    #[test]
    fn few_values_are_counted_one_by_one() {
        for (m, n) in [(1_usize, 1_usize), (2, 5), (5, 7), (6, 6), (4, 9)] {
            let orders: Vec<u32> =
                (0..1_u32 << (m + n)).filter(|bits| bits.count_ones() as usize == m).collect();
            let steps = |bits: u32| {
                let distance = |k: usize| {
                    let i = (bits & ((1 << k) - 1)).count_ones() as usize;
                    (i * n).abs_diff((k - i) * m)
                };
                (0..=m + n).map(distance).max().unwrap_or(0)
            };
            for limit in [1, n, m * n / 2, m * n * 3 / 4, m * n] {
                let leaving = orders.iter().filter(|bits| steps(**bits) >= limit).count();
                let share = leaving as f64 / orders.len() as f64;
                close(two_sample_tail(m, n, limit as u128), share, 1e-13);
            }
        }
    }

    #[test]
    fn equal_sizes_are_the_reflection_principle() {
        for (n, k) in [(10_usize, 4_usize), (50, 14), (200, 40), (1000, 60)] {
            close(two_sample_tail(n, n, (k * n) as u128), reflected_paths(n, k), 1e-11);
        }
    }
}
