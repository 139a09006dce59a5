//! How a picture's light runs with an angle or any other coordinate of its pixels: means over equal steps, maxima, contrast.
//!
//! A maximum is where a mean exceeds both neighbours, or the middle of a plateau does; its place is the vertex of the parabola through the
//! three points. Contrast is Michelson's (1927), (max - min)/(max + min).

use crate::ImagingError;
use stratiform_quantities::Range;

/// Equal steps of a coordinate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Steps {
    /// Where the first begins.
    pub start: f64,
    /// Width of each.
    pub width: f64,
    /// How many.
    pub count: usize,
}

impl Steps {
    /// The step that holds a coordinate.
    #[allow(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "from 0 to the number of steps"
    )]
    fn index(&self, coordinate: f64) -> Option<usize> {
        let step = (coordinate - self.start) / self.width;
        (step >= 0.0 && step < self.count as f64).then_some(step as usize)
    }
}

/// Mean coordinate and mean value of each step that has pixels, in order.
#[derive(Clone, Debug, PartialEq)]
pub struct Profile {
    points: Vec<(f64, f64)>,
}

impl Profile {
    /// Of pixels as (coordinate, value); those outside the steps are left out.
    ///
    /// # Errors
    /// [`ImagingError::Domain`] for a value that is not finite.
    pub fn new(steps: &Steps, pixels: impl IntoIterator<Item = (f64, f64)>) -> Result<Self, ImagingError> {
        let finite = Range::closed(f64::MIN, f64::MAX);
        let mut sums = vec![(0.0, 0.0, 0.0); steps.count];
        for (coordinate, value) in pixels {
            if let Some(i) = steps.index(coordinate) {
                let (sum, coordinates, number) = &mut sums[i];
                *sum += finite.check("a value of a profile", value)?;
                *coordinates += coordinate;
                *number += 1.0;
            }
        }
        let mean = |(sum, coordinates, number): (f64, f64, f64)| (coordinates / number, sum / number);
        Ok(Self { points: sums.into_iter().filter(|(_, _, number)| *number > 0.0).map(mean).collect() })
    }

    /// (coordinate, value).
    pub fn points(&self) -> &[(f64, f64)] {
        &self.points
    }

    /// The part from `low` to `high`.
    #[must_use]
    pub fn between(&self, low: f64, high: f64) -> Self {
        let inside = |(x, _): &(f64, f64)| (low..=high).contains(x);
        Self { points: self.points.iter().copied().filter(inside).collect() }
    }

    /// Its maxima, ends left out, as (coordinate, value), the highest first.
    pub fn maxima(&self) -> Vec<(f64, f64)> {
        let p = &self.points;
        let mut found = Vec::new();
        let mut at = 1;
        while at + 1 < p.len() {
            let end = (at..p.len()).take_while(|i| p[*i].1 == p[at].1).last().unwrap_or(at);
            if end + 1 < p.len() && p[at].1 > p[at - 1].1 && p[end].1 > p[end + 1].1 {
                let middle = usize::midpoint(at, end);
                found.push(vertex([p[middle - 1], p[middle], p[middle + 1]]));
            }
            at = end + 1;
        }
        found.sort_by(|a, b| b.1.total_cmp(&a.1));
        found
    }

    /// Contrast of its values; `None` if there are none or they sum to nothing.
    pub fn contrast(&self) -> Option<f64> {
        contrast(self.points.iter().map(|(_, value)| *value))
    }
}

/// (max - min)/(max + min); `None` if there are no values or they sum to nothing.
pub fn contrast(values: impl IntoIterator<Item = f64>) -> Option<f64> {
    let start = (f64::INFINITY, f64::NEG_INFINITY);
    let (least, most) = values.into_iter().fold(start, |(least, most), v| (v.min(least), v.max(most)));
    let sum = least + most;
    (sum.is_finite() && sum != 0.0).then(|| (most - least) / sum)
}

/// The highest point of the parabola through three.
fn vertex([(x0, y0), (x1, y1), (x2, y2)]: [(f64, f64); 3]) -> (f64, f64) {
    let (left, right) = ((y1 - y0) / (x1 - x0), (y2 - y1) / (x2 - x1));
    let bend = (right - left) / (x2 - x0);
    if bend >= 0.0 {
        return (x1, y1);
    }
    let x = 0.5 * (x0 + x1 - left / bend);
    (x, y0 + (x - x0) * (left + bend * (x - x1)))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Pixels of a square picture round a point off its grid, with a bright ring of radius `ring`.
    fn picture(ring: f64) -> Vec<(f64, f64)> {
        let radius = |i: usize| libm::hypot((i % 101) as f64 - 50.3, (i / 101) as f64 - 49.6);
        let value = |r: f64| 1.0 + 0.5 * libm::exp(-(r - ring) * (r - ring) / 18.0);
        (0..101 * 101).map(|i| (radius(i), value(radius(i)))).collect()
    }

    const STEPS: Steps = Steps { start: 0.0, width: 1.0, count: 50 };

    #[test]
    fn a_ring_is_found_within_a_tenth_of_a_pixel() {
        for ring in [12.0, 20.37, 33.8] {
            let profile = Profile::new(&STEPS, picture(ring)).unwrap();
            let (radius, height) = profile.maxima()[0];
            assert!((radius - ring).abs() < 0.1, "{radius} {ring}");
            assert!((height - 1.5).abs() < 0.01);
            assert!((profile.contrast().unwrap() - 0.2).abs() < 0.005);
        }
    }

    #[test]
    fn the_highest_comes_first_and_ends_are_no_maxima() {
        let waves = (0..100).map(|i| (f64::from(i), libm::cos(0.2 * f64::from(i)) - 0.001 * f64::from(i)));
        let profile = Profile::new(&Steps { count: 100, ..STEPS }, waves).unwrap();
        let places: Vec<f64> = profile.maxima().iter().map(|m| libm::round(m.0 / 31.416)).collect();
        assert_eq!(places, [1.0, 2.0, 3.0]);
        assert_eq!(profile.between(35.0, 58.0).maxima(), []);
    }

    #[test]
    fn a_parabola_is_met_and_a_plateau_counts_once() {
        let (x, y) = vertex([1.0, 1.5, 3.0].map(|x| (x, 4.0 - (x - 1.8) * (x - 1.8))));
        assert!((x - 1.8).abs() < 1e-14 && (y - 4.0).abs() < 1e-14);
        let flat = [0.0, 1.0, 1.0, 1.0, 0.0].into_iter().enumerate().map(|(i, y)| (i as f64, y));
        let profile = Profile::new(&STEPS, flat).unwrap();
        assert_eq!(profile.maxima(), [(2.0, 1.0)]);
    }

    #[test]
    fn nothing_has_no_contrast_and_nan_is_refused() {
        assert_eq!(contrast([]), None);
        assert_eq!(contrast([0.0, 0.0]), None);
        assert_eq!(contrast([1.0, 3.0]), Some(0.5));
        assert!(matches!(Profile::new(&STEPS, [(1.0, f64::NAN)]), Err(ImagingError::Domain(_))));
        assert_eq!(Profile::new(&STEPS, [(f64::NAN, 1.0), (-1.0, 1.0)]).unwrap().points(), []);
    }
}
