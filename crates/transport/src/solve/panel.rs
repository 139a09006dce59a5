//! One panel of a slab, ready for light to cross it: in all streams, and along all beams.

use super::grid::{Collocation, lobatto};
use super::matrix::add_products;

/// Coefficients for one width; streams, or beams, innermost.
#[derive(Debug)]
pub(crate) struct Panel {
    /// For point i = 1…p and source j = 1…p (the last: radiance at point 0) a row of streams.
    through: Vec<f64>,
    /// For point p alone a row of beams.
    leaving: Vec<f64>,
    /// e^{-t/μ} at points 0…p: a row of streams each.
    pub(crate) fading: Vec<f64>,
}

impl Panel {
    pub(crate) fn new(collocation: &Collocation, width: f64, streams: &[f64], beams: &[f64]) -> Self {
        let p = collocation.intervals();
        let mut through = vec![0.0; p * (p + 1) * streams.len()];
        for (m, mu) in streams.iter().enumerate() {
            for (place, value) in collocation.through(width / mu).enumerate() {
                through[place * streams.len() + m] = value;
            }
        }
        let mut leaving = vec![0.0; (p + 1) * beams.len()];
        for (m, mu) in beams.iter().enumerate() {
            for (j, value) in collocation.leaving(width / mu).iter().enumerate() {
                leaving[j * beams.len() + m] = *value;
            }
        }
        let fading = |i: usize| streams.iter().map(move |mu| libm::exp(-width * lobatto(i, p) / mu));
        Self { through, leaving, fading: (0..=p).flat_map(fading).collect() }
    }

    /// Points 1…p of `field` from the `source` there and the radiance at point 0; `at` finds a point's row among
    /// rows of `count` streams.
    #[inline(always)]
    pub(crate) fn cross(&self, source: &[f64], field: &mut [f64], count: usize, at: impl Fn(usize) -> usize) {
        let start = field[at(0) * count..][..count].to_vec();
        for (i, rows) in self.through.chunks_exact(self.through.len() / self.intervals(count)).enumerate() {
            let target = &mut field[at(i + 1) * count..][..count];
            arrive(rows, source, &start, target, &at);
        }
    }

    /// Radiances along the beams at point p from those at point 0.
    #[inline(always)]
    pub(crate) fn leave(&self, source: &[f64], radiance: &mut [f64], at: impl Fn(usize) -> usize) {
        let start = radiance.to_vec();
        radiance.fill(0.0);
        arrive(&self.leaving, source, &start, radiance, &at);
    }

    fn intervals(&self, count: usize) -> usize {
        self.fading.len() / count - 1
    }
}

/// Adds Σ_j row_j source_j + row_p start.
#[inline(always)]
fn arrive(rows: &[f64], source: &[f64], start: &[f64], target: &mut [f64], at: &impl Fn(usize) -> usize) {
    let count = target.len();
    let last = rows.len() - count;
    for (j, row) in rows[..last].chunks_exact(count).enumerate() {
        add_products(target, row, &source[at(j + 1) * count..][..count]);
    }
    add_products(target, &rows[last..], start);
}
