//! A slab cut into panels, and transport along one direction cosine through a panel.
//!
//! Panels start at twice the smallest stream cosine at both surfaces, double in width up to 3, and are
//! mirror images about the middle. In each, μ dI/dt + I = J is collocated at Chebyshev–Lobatto points x_i =
//! (1 - cos πi/p)/2, i = 1…p, with I(x_0) given: I = r(D + r)⁻¹J - (D + r)⁻¹d_0 I(x_0), r = width/μ (Canuto
//! et al. 2006, ch. 3). The last point is collocated, so that streams far thinner than a panel follow J
//! instead of ringing.

use super::matrix::{Matrix, eliminate};
use std::f64::consts::PI;

/// Widest panel, in optical thickness.
const WIDEST: f64 = 3.0;

/// Panels of a slab with p + 1 points each, ends shared.
#[derive(Clone, Debug)]
pub(crate) struct Grid {
    pub(crate) intervals: usize,
    /// Different widths.
    pub(crate) widths: Vec<f64>,
    /// Which width each panel has, from the top.
    pub(crate) panels: Vec<usize>,
}

impl Grid {
    pub(crate) fn new(tau: f64, smallest_mu: f64, intervals: usize) -> Self {
        let half = 0.5 * tau;
        let (mut widths, mut top, mut depth) = (Vec::new(), Vec::new(), 0.0);
        for width in doublings(smallest_mu) {
            if depth + width >= half {
                break;
            }
            top.push(widths.len());
            widths.push(width);
            depth += width;
        }
        let rest = half - depth;
        let next = 2.0 * widths.last().copied().unwrap_or(smallest_mu);
        let pieces = (rest / next.min(WIDEST)).ceil().max(1.0);
        top.extend(std::iter::repeat_n(widths.len(), pieces as usize));
        widths.push(rest / pieces);
        let panels = top.iter().chain(top.iter().rev()).copied().collect();
        Self { intervals, widths, panels }
    }

    pub(crate) fn points(&self) -> usize {
        self.panels.len() * self.intervals + 1
    }
}

/// Widths that all slabs share, from the surfaces.
pub(crate) fn doublings(smallest_mu: f64) -> impl Iterator<Item = f64> {
    std::iter::successors(Some(2.0 * smallest_mu), |width| Some(2.0 * width))
        .take_while(|width| *width < WIDEST)
}

/// Chebyshev–Lobatto point `i` of 0…p.
pub(crate) fn lobatto(i: usize, p: usize) -> f64 {
    let sine = libm::sin(0.5 * PI * i as f64 / p as f64);
    sine * sine
}

/// The differentiation matrix on the Chebyshev–Lobatto points of \[0, 1\], p + 1 of them.
#[derive(Clone, Debug)]
pub(crate) struct Collocation {
    derivative: Matrix,
}

impl Collocation {
    pub(crate) fn new(intervals: usize) -> Self {
        let p = intervals;
        let at = |i: usize| lobatto(i, p);
        let end = |i: usize| if i == 0 || i == p { 0.5 } else { 1.0 };
        let sign = |i: usize| if i.is_multiple_of(2) { 1.0 } else { -1.0 };
        let off = |i: usize, j: usize| sign(i) * sign(j) * end(j) / (end(i) * (at(i) - at(j)));
        let derivative = Matrix::from_fn(p + 1, |i, j| {
            if i == j { -(0..=p).filter(|m| *m != i).fold(0.0, |sum, m| sum + off(i, m)) } else { off(i, j) }
        });
        Self { derivative }
    }

    pub(crate) fn intervals(&self) -> usize {
        self.derivative.size() - 1
    }

    /// Rows: what each source at points 1…p, then radiance at point 0, gives at points 1…p.
    pub(crate) fn through(&self, ratio: f64) -> impl Iterator<Item = f64> {
        let p = self.intervals();
        let row = |i: usize| {
            let source = (0..p).map(move |j| if i == j { ratio } else { 0.0 });
            self.shifted(ratio, i).chain(source).chain([-self.derivative[(i + 1, 0)]])
        };
        let mut rows: Vec<f64> = (0..p).flat_map(row).collect();
        let width = 2 * p + 1;
        eliminate(&mut rows, (p, width));
        (0..p * (p + 1)).map(move |place| rows[place / (p + 1) * width + p + place % (p + 1)])
    }

    /// Only the last row of [`through`](Self::through): the radiance that leaves. At infinity it is the last source.
    pub(crate) fn leaving(&self, ratio: f64) -> Vec<f64> {
        let p = self.intervals();
        let unit = (0..p).map(|j| if j + 1 == p { 1.0 } else { 0.0 });
        if ratio == f64::INFINITY {
            return unit.chain([0.0]).collect();
        }
        let transposed =
            Matrix::from_fn(p, |i, j| self.derivative[(j + 1, i + 1)] + if i == j { ratio } else { 0.0 });
        let row = transposed.solve(unit.collect());
        let from_start = (0..p).fold(0.0, |sum, j| sum - row[j] * self.derivative[(j + 1, 0)]);
        row.iter().map(|value| ratio * value).chain([from_start]).collect()
    }

    /// Row `i` of D + r without point 0.
    fn shifted(&self, ratio: f64, i: usize) -> impl Iterator<Item = f64> {
        let row = self.derivative.row(i + 1)[1..].iter().enumerate();
        row.map(move |(j, value)| value + if i == j { ratio } else { 0.0 })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// J = t: I = I_0 e^{-rx} + x - (1 - e^{-rx})/r.
    #[test]
    fn a_linear_source_is_carried_through() {
        let collocation = Collocation::new(12);
        for ratio in [1e-6, 0.1, 1.0, 4.0] {
            let row = collocation.leaving(ratio);
            let x = |j: usize| libm::pow(libm::sin(0.5 * PI * (j + 1) as f64 / 12.0), 2.0);
            let found = (0..12).fold(0.7 * row[12], |sum, j| sum + row[j] * x(j));
            let decay = libm::exp(-ratio);
            let expected = 0.7 * decay + 1.0 + libm::expm1(-ratio) / ratio;
            assert!((found - expected).abs() < 1e-10, "{ratio}: {:e}", found - expected);
            let last: Vec<f64> = collocation.through(ratio).skip(11 * 13).collect();
            assert!(row.iter().zip(&last).all(|(a, b)| (a - b).abs() < 1e-10 * (1.0 + a.abs())), "{ratio}");
        }
    }

    #[test]
    fn panels_fill_the_slab() {
        for tau in [1e-6, 0.01, 1.0, 7.3, 200.0] {
            let grid = Grid::new(tau, 1e-3, 8);
            let sum = grid.panels.iter().fold(0.0, |sum, panel| sum + grid.widths[*panel]);
            assert!(
                (sum / tau - 1.0).abs() < 1e-12 && grid.widths.iter().all(|w| *w <= 3.0 && *w > 0.0),
                "{tau}"
            );
        }
    }
}
