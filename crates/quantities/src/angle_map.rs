//! The angle map of tabulated phase functions: dense at the forward peak and at the glory.
//!
//! The coordinate is u = √(Θ/2π) up to 90° and 1 - √((π-Θ)/2π) beyond: of n equal steps the first and the last
//! are 360°/n² wide, those at 90° 360°/n. Every file and every emitted function samples Θ at equal steps of u.

/// The map's name in files.
pub const NAME: &str = "double-ended square root";

/// The coordinate as files state it.
pub const COORDINATE_FORMULA: &str =
    "u = sqrt(theta_deg/360) for theta_deg < 90, u = 1 - sqrt((180 - theta_deg)/360) from 90 on";

/// Its inverse as files state it.
pub const ANGLE_FORMULA: &str =
    "theta_deg = 360 u^2 for u < 0.5, theta_deg = 180 - 360 (1 - u)^2 from 0.5 on";

/// Θ in degrees at the coordinate u ∈ \[0, 1\].
pub fn angle_deg(coordinate: f64) -> f64 {
    let back = 1.0 - coordinate;
    if coordinate < 0.5 { 360.0 * coordinate * coordinate } else { 180.0 - 360.0 * back * back }
}

/// The coordinate u ∈ \[0, 1\] of Θ in degrees: the inverse of [`angle_deg`].
pub fn coordinate(theta_deg: f64) -> f64 {
    let half = |degrees: f64| (degrees / 360.0).sqrt();
    if theta_deg < 90.0 { half(theta_deg) } else { 1.0 - half(180.0 - theta_deg) }
}

/// Where Θ lies among `texels` values at equal steps of u: the left one, and the share of the right one.
pub fn place(theta_deg: f64, texels: usize) -> (usize, f64) {
    let place = coordinate(theta_deg) * (texels - 1) as f64;
    let cell = (place as usize).min(texels - 2);
    (cell, place - cell as f64)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn angle_and_coordinate_are_inverse() {
        for i in 0..=1000 {
            let u = f64::from(i) / 1000.0;
            assert!((coordinate(angle_deg(u)) - u).abs() < 1e-7, "{u}");
        }
        assert_eq!((angle_deg(0.0), angle_deg(0.5), angle_deg(1.0)), (0.0, 90.0, 180.0));
    }
}
