//! Random numbers of one path, and what is drawn with them.

use glam::DVec3;
use rand::Rng;
use rand_pcg::Pcg32;

/// A number in (0, 1) from 32 random bits.
#[inline]
pub(crate) fn uniform(rng: &mut Pcg32) -> f64 {
    (f64::from(rng.next_u32()) + 0.5) * (1.0 / 4_294_967_296.0)
}

/// An exponential variate of mean 1, from 52 bits: up to 36.7.
#[inline]
pub(crate) fn exponential(rng: &mut Pcg32) -> f64 {
    -libm::log(((rng.next_u64() >> 12) as f64 + 0.5) / 4_503_599_627_370_496.0)
}

/// A Poisson variate, `nothing` being e^{-mean}: uniform numbers are multiplied until the product is below it (Knuth).
#[inline]
pub(crate) fn poisson(nothing: f64, rng: &mut Pcg32) -> u32 {
    let (mut product, mut count) = (uniform(rng), 0);
    while product > nothing {
        product *= uniform(rng);
        count += 1;
    }
    count
}

/// A point on the unit circle, by rejection from the square (Marsaglia 1972).
#[inline]
fn circle(rng: &mut Pcg32) -> (f64, f64) {
    loop {
        let (x, y) = (2.0 * uniform(rng) - 1.0, 2.0 * uniform(rng) - 1.0);
        let square = x * x + y * y;
        if square <= 1.0 && square > 1e-12 {
            let scale = 1.0 / square.sqrt();
            return (x * scale, y * scale);
        }
    }
}

/// `direction` turned by the angle whose 1 - cosΘ is `v`, about a random azimuth; the length stays 1 to rounding.
#[inline]
pub(crate) fn turned(direction: DVec3, v: f64, rng: &mut Pcg32) -> DVec3 {
    let (across, up) = direction.any_orthonormal_pair();
    let (x, y) = circle(rng);
    let turned = direction * (1.0 - v) + (across * x + up * y) * (v * (2.0 - v)).sqrt();
    level(turned * (1.5 - 0.5 * turned.length_squared()))
}

/// A direction from a horizontal plane upwards, by the cosine of its angle to the normal.
pub(crate) fn cosine(rng: &mut Pcg32) -> DVec3 {
    let (x, y) = circle(rng);
    let square = uniform(rng);
    let radius = square.sqrt();
    DVec3::new(radius * x, radius * y, (1.0 - square).sqrt())
}

/// Directions nearer than this to the horizontal are lifted from it, so that every ray leaves the layer.
pub(crate) const LEVEL: f64 = 1e-9;

/// `direction`, not horizontal.
#[inline]
pub(crate) fn level(mut direction: DVec3) -> DVec3 {
    if direction.z.abs() < LEVEL {
        direction.z = LEVEL.copysign(direction.z);
    }
    direction
}

#[cfg(test)]
mod tests {
    use super::*;
    use stratiform_stats::{Purpose, key, photon_stream};

    fn stream(index: u64) -> Pcg32 {
        photon_stream(key(5, Purpose::Calibration), index)
    }

    /// Means of 4·10⁵ draws within 5 standard errors: one false alarm in 1.7 million each.
    #[test]
    fn means_are_those_of_the_distributions() {
        let mut rng = stream(0);
        let n = 400_000;
        let mean = |f: &mut dyn FnMut() -> f64| (0..n).fold(0.0, |sum, _| sum + f()) / f64::from(n);
        let bound = |deviation: f64| 5.0 * deviation / f64::from(n).sqrt();
        assert!((mean(&mut || exponential(&mut rng)) - 1.0).abs() < bound(1.0));
        let nothing = libm::exp(-1.7);
        assert!((mean(&mut || f64::from(poisson(nothing, &mut rng))) - 1.7).abs() < bound(1.7_f64.sqrt()));
        assert!((mean(&mut || cosine(&mut rng).z) - 2.0 / 3.0).abs() < bound(1.0 / 18.0_f64.sqrt()));
        let axis = DVec3::new(0.48, -0.6, 0.64);
        assert!((mean(&mut || turned(axis, 0.7, &mut rng).x) - 0.3 * axis.x).abs() < bound(0.7));
    }

    #[test]
    fn turning_keeps_angle_and_length() {
        let mut rng = stream(1);
        let mut direction = DVec3::new(0.6, 0.0, -0.8);
        for k in 0..10_000 {
            let v = 2.0 * f64::from(k % 1000) / 999.0;
            let next = turned(direction, v, &mut rng);
            assert!((1.0 - next.dot(direction) - v).abs() < 1e-12 && (next.length() - 1.0).abs() < 1e-15);
            direction = next;
        }
    }
}
