//! Composite Gauss rules whose panels shrink towards given points.

use super::legendre::gauss;
use std::f64::consts::SQRT_2;
use std::sync::LazyLock;

/// A point that panels end at and shrink towards, down to width `least`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Break {
    pub(super) at: f64,
    pub(super) least: f64,
}

/// Gauss rules of \[0, 1\] with 1 to 32 points.
static GAUSS: LazyLock<Vec<(Vec<f64>, Vec<f64>)>> = LazyLock::new(|| (1..=32).map(gauss).collect());

/// A Gauss rule of \[0, 1\].
#[derive(Clone, Copy, Debug)]
pub(super) struct Rule {
    points: &'static [f64],
    weights: &'static [f64],
}

/// A panel halved until no wider than its distance to a break is half as wide on average; this lets it be as wide.
const WIDTH: f64 = SQRT_2;

impl Rule {
    /// The rule of 1 to 32 points.
    pub(super) fn new(points: usize) -> Self {
        let (points, weights) = &GAUSS[points - 1];
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
        let mut from = start;
        while from < end {
            let inside = breaks.iter().map(|point| point.at).filter(|at| *at > from);
            let to = inside.fold(end, f64::min);
            self.split([from, to], widest, breaks, &mut f);
            from = to;
        }
    }

    fn split(&self, [a, b]: [f64; 2], widest: f64, breaks: &[Break], f: &mut impl FnMut(f64, f64)) {
        let width = b - a;
        if width <= 0.0 {
            return;
        }
        let allowed = breaks.iter().fold(widest, |allowed, point| {
            let distance = larger(larger(a - point.at, point.at - b), point.least);
            if distance < allowed { distance } else { allowed }
        });
        if width > WIDTH * allowed {
            let middle = 0.5 * (a + b);
            self.split([a, middle], widest, breaks, f);
            self.split([middle, b], widest, breaks, f);
        } else {
            self.points.iter().zip(self.weights).for_each(|(x, w)| f(a + width * x, width * w));
        }
    }
}

/// Without a NaN's detours.
fn larger(a: f64, b: f64) -> f64 {
    if a > b { a } else { b }
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
