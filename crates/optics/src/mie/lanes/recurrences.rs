//! The recurrences of [`coefficients`](crate::mie::coefficients) over lanes; each function's loop over the orders is compiled for
//! every instruction set.

use super::{LANES, Lanes, Row, Sizes};
use num_complex::Complex64;

/// D_{n-1} = n/z - 1/(D_n + n/z), from each lane's start.
#[multiversion::multiversion(targets("x86_64+avx512f+avx512dq+avx512vl", "x86_64+avx2"))]
pub(super) fn logarithmic_derivatives(sizes: &Sizes, m: Complex64, rows: &mut [Row]) {
    let z = sizes.x.map(|x| m * x);
    let (starts, first) = sizes.starts(z.map(|z| z.norm_sqr().sqrt()));
    let (inverse_re, inverse_im) = (z.map(|z| z.inv().re), z.map(|z| z.inv().im));
    let [mut re, mut im] = [[0.0; LANES]; 2];
    for n in (1..=first).rev() {
        let count = n as f64;
        for l in 0..LANES {
            let (over_re, over_im) = (inverse_re[l] * count, inverse_im[l] * count);
            let (sum_re, sum_im) = (re[l] + over_re, im[l] + over_im);
            let norm = sum_re * sum_re + sum_im * sum_im;
            let next = [over_re - sum_re / norm, over_im - -sum_im / norm];
            let started = count <= starts[l];
            re[l] = if started { next[0] } else { 0.0 };
            im[l] = if started { next[1] } else { 0.0 };
        }
        if let Some(row) = rows.get_mut(n - 1) {
            (row.d_re, row.d_im) = (Lanes(re), Lanes(im));
        }
    }
}

/// r_n = (2n+1)/x - 1/r_{n+1}, from each lane's start; 0 where n ≤ x.
#[multiversion::multiversion(targets("x86_64+avx512f+avx512dq+avx512vl", "x86_64+avx2"))]
pub(super) fn psi_ratios(sizes: &Sizes, rows: &mut [Row]) {
    let x = &sizes.x;
    let (starts, first) = sizes.starts(*x);
    let least = x.iter().copied().fold(f64::INFINITY, f64::min);
    let mut ratio: [f64; LANES] = std::array::from_fn(|l| (2.0 * starts[l] + 1.0) / x[l]);
    for n in (1..first).rev().take_while(|&n| n as f64 > least) {
        let count = n as f64;
        let odd = 2.0 * count + 1.0;
        for l in 0..LANES {
            let next = odd / x[l] - 1.0 / ratio[l];
            ratio[l] = if count < starts[l] { next } else { ratio[l] };
        }
        if let Some(row) = rows.get_mut(n) {
            for l in 0..LANES {
                row.ratio.0[l] = if count > x[l] { ratio[l] } else { 0.0 };
            }
        }
    }
}

/// ψ_n and χ_n upwards; ψ_n by its ratio where n > x.
#[multiversion::multiversion(targets("x86_64+avx512f+avx512dq+avx512vl", "x86_64+avx2"))]
pub(super) fn riccati_bessel(sizes: &Sizes, rows: &mut [Row]) {
    let x = &sizes.x;
    let (mut psi, mut chi) = (x.map(libm::sin), x.map(libm::cos));
    // ψ_{-1} = cos x and χ_{-1} = -sin x.
    let (mut psi_before, mut chi_before) = (chi, psi.map(|s| -s));
    (rows[0].psi, rows[0].chi) = (Lanes(psi), Lanes(chi));
    for (n, row) in rows.iter_mut().enumerate().skip(1) {
        let (count, odd) = (n as f64, (2 * n - 1) as f64);
        for l in 0..LANES {
            let factor = odd / x[l];
            let (by_ratio, upwards) = (psi[l] / row.ratio.0[l], factor * psi[l] - psi_before[l]);
            let next = factor * chi[l] - chi_before[l];
            (psi_before[l], chi_before[l]) = (psi[l], chi[l]);
            psi[l] = if count > x[l] { by_ratio } else { upwards };
            chi[l] = next;
        }
        (row.psi, row.chi) = (Lanes(psi), Lanes(chi));
    }
}

#[multiversion::multiversion(targets("x86_64+avx512f+avx512dq+avx512vl", "x86_64+avx2"))]
pub(super) fn coefficients(sizes: &Sizes, m: Complex64, rows: &[Row], orders: &mut [[Lanes; 4]]) {
    let (x, inverse) = (&sizes.x, m.inv());
    let last = sizes.last.map(|n| n as f64);
    for (i, ([before, row], parts)) in rows.array_windows().zip(orders).enumerate() {
        let n = (i + 1) as f64;
        for l in 0..LANES {
            let outside = Outside {
                n,
                x: x[l],
                psi: [before.psi.0[l], row.psi.0[l]],
                chi: [before.chi.0[l], row.chi.0[l]],
                ratio: row.ratio.0[l],
            };
            let d = [row.d_re.0[l], row.d_im.0[l]];
            let a = outside.coefficient(product(d, inverse));
            let b = outside.coefficient(product(d, m));
            let within = n <= last[l];
            for (part, value) in parts.iter_mut().zip([a[0], a[1], b[0], b[1]]) {
                part.0[l] = if within { value } else { 0.0 };
            }
        }
    }
}

#[inline(always)]
fn product(d: [f64; 2], m: Complex64) -> [f64; 2] {
    [d[0] * m.re - d[1] * m.im, d[0] * m.im + d[1] * m.re]
}

/// What one lane's coefficient of order n needs from outside the sphere; the first of two values is that of n-1.
struct Outside {
    n: f64,
    x: f64,
    psi: [f64; 2],
    chi: [f64; 2],
    ratio: f64,
}

impl Outside {
    /// a_n for `d` = D_n(mx)/m, b_n for `d` = mD_n(mx).
    #[inline(always)]
    fn coefficient(&self, d: [f64; 2]) -> [f64; 2] {
        let n_over_x = self.n / self.x;
        let ([psi_before, psi], [chi_before, chi]) = (self.psi, self.chi);
        let beyond = (d[0] - (self.ratio - n_over_x)) * psi;
        let below = (d[0] + n_over_x) * psi - psi_before;
        let p = [if self.n > self.x { beyond } else { below }, d[1] * psi];
        let q = [(d[0] + n_over_x) * chi - chi_before, d[1] * chi];
        let (re, im) = (p[0] + q[1], p[1] - q[0]);
        let norm = re * re + im * im;
        [(p[0] * re + p[1] * im) / norm, (p[1] * re - p[0] * im) / norm]
    }
}
