//! Composite Gauss rules whose panels shrink towards given points.

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
    /// Widest panel.
    widest: f64,
}

impl Rule {
    pub(super) fn new(points: usize, widest: f64) -> Self {
        let (points, weights) = super::legendre::gauss(points);
        Self { points, weights, widest }
    }

    /// Σ weight · f(point) over \[`start`, `end`\], panels no wider than their distance to any break.
    pub(super) fn visit(&self, start: f64, end: f64, breaks: &[Break], mut f: impl FnMut(f64, f64)) {
        let mut ends: Vec<f64> =
            breaks.iter().map(|b| b.at).filter(|at| *at > start && *at < end).chain([start, end]).collect();
        ends.sort_by(f64::total_cmp);
        // Points further away than the widest panel, or that allow it, narrow none.
        let near =
            |b: &&Break| b.at > start - self.widest && b.at < end + self.widest && b.least < self.widest;
        let breaks: Vec<Break> = breaks.iter().filter(near).copied().collect();
        for pair in ends.windows(2) {
            self.split(pair[0], pair[1], &breaks, &mut f);
        }
    }

    fn split(&self, a: f64, b: f64, breaks: &[Break], f: &mut impl FnMut(f64, f64)) {
        let width = b - a;
        if width <= 0.0 {
            return;
        }
        let allowed = breaks.iter().fold(self.widest, |allowed, point| {
            let distance = (a - point.at).max(point.at - b).max(0.0);
            allowed.min(distance.max(point.least))
        });
        // A part in a thousand for rounding.
        if width > 1.001 * allowed {
            let middle = 0.5 * (a + b);
            self.split(a, middle, breaks, f);
            self.split(middle, b, breaks, f);
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
        let rule = Rule::new(8, 1.0);
        let breaks = [Break { at: 0.3, least: 1e-4 }];
        let mut sum = 0.0;
        rule.visit(-1.0, 2.0, &breaks, |x, w| sum += w * 1e-3 / ((x - 0.3) * (x - 0.3) + 1e-6));
        let expected = libm::atan(1.7e3) + libm::atan(1.3e3);
        assert!((sum / expected - 1.0).abs() < 1e-7, "{:e}", sum / expected - 1.0);
    }
}
