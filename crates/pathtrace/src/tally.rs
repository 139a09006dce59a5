//! Sums over the paths of one pixel.

use crate::light::Light;
use stratiform_imaging::srgb::luminance;
use stratiform_stats::Estimate;

/// Σx and Σx² of one number.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Sum {
    sum: f64,
    square: f64,
}

impl Sum {
    fn add(&mut self, x: f64) {
        self.sum += x;
        self.square += x * x;
    }

    fn estimate(&self, count: u64) -> Estimate {
        let n = count as f64;
        let value = self.sum / n;
        Estimate { value, std_error: ((self.square / n - value * value).max(0.0) / (n - 1.0)).sqrt() }
    }
}

/// One pixel.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Tally {
    count: u64,
    parts: [[Sum; 3]; 7],
    total: [Sum; 3],
    luminance: Sum,
    /// Luminance of the brightest path.
    largest: f64,
}

impl Tally {
    /// Enters one path.
    pub(crate) fn add(&mut self, light: &Light) {
        let total = light.total();
        let bright = luminance(total);
        self.count += 1;
        for (sums, part) in self.parts.iter_mut().zip(&light.0) {
            sums.iter_mut().zip(part).for_each(|(sum, x)| sum.add(*x));
        }
        self.total.iter_mut().zip(total).for_each(|(sum, x)| sum.add(x));
        self.luminance.add(bright);
        self.largest = self.largest.max(bright);
    }

    /// All light.
    pub(crate) fn total(&self) -> [Estimate; 3] {
        self.total.map(|sum| sum.estimate(self.count))
    }

    /// One contribution.
    pub(crate) fn part(&self, index: usize) -> [Estimate; 3] {
        self.parts[index].map(|sum| sum.estimate(self.count))
    }

    /// Luminance.
    pub(crate) fn luminance(&self) -> Estimate {
        self.luminance.estimate(self.count)
    }

    /// Share of the light that one path brought; 0 of darkness.
    pub(crate) fn largest_share(&self) -> f64 {
        if self.luminance.sum > 0.0 { self.largest / self.luminance.sum } else { 0.0 }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// 1, 2, 3 and two zeros: mean 1.2, variance of the sample 1.7, of the mean 0.34.
    #[test]
    fn mean_and_error_are_those_of_the_textbook() {
        let mut tally = Tally::default();
        for x in [1.0, 2.0, 3.0, 0.0, 0.0] {
            let mut light = Light::default();
            light.0[4] = [x, 0.0, x];
            tally.add(&light);
        }
        let [red, green, _] = tally.total();
        assert!((red.value - 1.2).abs() < 1e-15 && (red.std_error - 0.34_f64.sqrt()).abs() < 1e-15);
        assert_eq!((green.value, green.std_error), (0.0, 0.0));
        assert_eq!(tally.part(4), tally.total());
        assert_eq!(tally.largest_share(), 0.5);
        assert_eq!(Tally::default().largest_share(), 0.0);
    }
}
