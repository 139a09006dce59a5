//! Form factors between parallel planes at distance h, as seen from a point of one: the share of its hemisphere, weighted by the cosine,
//! that an area of the other fills. Lengths in any one unit; results in [0, 1].
//!
//! Kernel: cosθ cosθ'/(π r²) = h²/(π (r² + h²)²), r the horizontal distance (Siegel & Howell, *Thermal Radiation Heat Transfer*,
//! configurations of a differential element and a parallel rectangle, a parallel disc).

use std::f64::consts::PI;

/// Of a disc of radius `radius`, the point below its centre: R²/(h² + R²).
pub fn disc(radius: f64, h: f64) -> f64 {
    let (square, height) = (radius * radius, h * h);
    square / (height + square)
}

/// Of the rectangle between the point's foot and `(x, y)`; odd in both, so that any rectangle is a sum of four.
pub(super) fn corner(x: f64, y: f64, h: f64) -> f64 {
    let side = |a: f64, b: f64| {
        let slant = (a * a + h * h).sqrt();
        a / slant * libm::atan(b / slant)
    };
    (side(x, y) + side(y, x)) / (2.0 * PI)
}

/// Of the rectangle from `low` to `high`, the point's foot being the origin.
pub fn rectangle(low: [f64; 2], high: [f64; 2], h: f64) -> f64 {
    let at = |x, y| corner(x, y, h);
    (at(high[0], high[1]) - at(low[0], high[1])) - (at(high[0], low[1]) - at(low[0], low[1]))
}

/// Of a square of this side, the point below its centre.
pub fn square(side: f64, h: f64) -> f64 {
    let half = 0.5 * side;
    rectangle([-half, -half], [half, half], h)
}
