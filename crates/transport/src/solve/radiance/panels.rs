//! Composite Gauss rules whose panels shrink towards given points.

use std::f64::consts::SQRT_2;

/// A point that panels end at and shrink towards, down to width `least`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Break {
    pub(super) at: f64,
    pub(super) least: f64,
}

/// A Gauss rule of \[0, 1\].
#[derive(Clone, Debug)]
pub(super) struct Rule {
    points: Vec<f64>,
    weights: Vec<f64>,
}

/// A panel halved until no wider than its distance to a break is half as wide on average; this lets it be as wide.
const WIDTH: f64 = SQRT_2;

impl Rule {
    pub(super) fn new(points: usize) -> Self {
        let (points, weights) = super::legendre::gauss(points);
        Self { points, weights }
    }

    /// Σ weight · f(point) over \[`start`, `end`\], panels about as wide as their distance to any break or as `widest`.
    pub(super) fn visit(
        &self,
        [start, end]: [f64; 2],
        widest: f64,
        breaks: &[Break],
        mut f: impl FnMut(f64, f64),
    ) {
        let mut ends: Vec<f64> =
            breaks.iter().map(|b| b.at).filter(|at| *at > start && *at < end).chain([start, end]).collect();
        ends.sort_by(f64::total_cmp);
        // Points further away than the widest panel, or that allow it, narrow none.
        let near = |b: &&Break| b.at > start - widest && b.at < end + widest && b.least < widest;
        let breaks: Vec<Break> = breaks.iter().filter(near).copied().collect();
        for pair in ends.windows(2) {
            self.split([pair[0], pair[1]], widest, &breaks, &mut f);
        }
    }

    fn split(&self, [a, b]: [f64; 2], widest: f64, breaks: &[Break], f: &mut impl FnMut(f64, f64)) {
        let width = b - a;
        if width <= 0.0 {
            return;
        }
        let allowed = breaks.iter().fold(widest, |allowed, point| {
            let distance = (a - point.at).max(point.at - b).max(0.0);
            allowed.min(distance.max(point.least))
        });
        if width > WIDTH * allowed {
            let middle = 0.5 * (a + b);
            self.split([a, middle], widest, breaks, f);
            self.split([middle, b], widest, breaks, f);
        } else {
            self.points.iter().zip(&self.weights).for_each(|(x, w)| f(a + width * x, width * w));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_peak_is_integrated() {
        let rule = Rule::new(8);
        let breaks = [Break { at: 0.3, least: 1e-4 }];
        let mut sum = 0.0;
        rule.visit([-1.0, 2.0], 1.0, &breaks, |x, w| sum += w * 1e-3 / ((x - 0.3) * (x - 0.3) + 1e-6));
        let expected = libm::atan(1.7e3) + libm::atan(1.3e3);
        assert!((sum / expected - 1.0).abs() < 1e-7, "{:e}", sum / expected - 1.0);
    }
}
