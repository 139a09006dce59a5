//! Sums over photons of what each adds to one number.

use stratiform_stats::Estimate;

/// Σx, Σx² and max x over photons; photons that add nothing need not be entered.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Score {
    sum: f64,
    square: f64,
    largest: f64,
}

impl Score {
    /// Enters one photon.
    pub fn add(&mut self, x: f64) {
        self.sum += x;
        self.square += x * x;
        self.largest = self.largest.max(x);
    }

    /// Adds the photons of `other`.
    pub fn merge(&mut self, other: &Self) {
        self.sum += other.sum;
        self.square += other.square;
        self.largest = self.largest.max(other.largest);
    }

    /// Mean over `photons` with the standard error of the scatter met.
    pub fn scatter(&self, photons: u64) -> Estimate {
        let n = photons as f64;
        let value = self.sum / n;
        Estimate { value, std_error: ((self.square / n - value * value).max(0.0) / (n - 1.0)).sqrt() }
    }

    /// Share of the sum that one photon brought; 0 of nothing.
    pub fn largest_share(&self) -> f64 {
        if self.sum > 0.0 { self.largest / self.sum } else { 0.0 }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// 1, 2, 3 and two zeros: mean 1.2, variance of the sample 1.7, of the mean 0.34.
    #[test]
    fn mean_and_error_are_those_of_the_textbook() {
        let (mut a, mut b) = (Score::default(), Score::default());
        a.add(1.0);
        b.add(2.0);
        b.add(3.0);
        a.merge(&b);
        let estimate = a.scatter(5);
        assert!((estimate.value - 1.2).abs() < 1e-15 && (estimate.std_error - 0.34_f64.sqrt()).abs() < 1e-15);
        assert_eq!((a.largest_share(), Score::default().largest_share()), (0.5, 0.0));
    }
}
