//! FLIP's feature pipeline (Andersson et al. 2020, section 4.2): edges and points by first and second derivatives of a Gaussian of
//! width 0.082° (σ is half of it), on lightness in [0, 1]. A pixel's difference is (max of both differences/√2)^½.

use super::filter::{Kernel, Plane};

const WIDTH_DEG: f64 = 0.082;

/// Feature difference of every pixel, in [0, 1].
pub fn differences(truth: &Plane, picture: &Plane, pixels_per_degree: f64) -> Vec<f64> {
    let [a, b] = [truth, picture].map(|lightness| strengths(lightness, pixels_per_degree));
    let difference = |p: &[f64; 2], q: &[f64; 2]| {
        let larger = (p[0] - q[0]).abs().max((p[1] - q[1]).abs());
        (larger * std::f64::consts::FRAC_1_SQRT_2).sqrt()
    };
    a.iter().zip(&b).map(|(p, q)| difference(p, q)).collect()
}

/// Strength of edge and point at every pixel.
fn strengths(lightness: &Plane, pixels_per_degree: f64) -> Vec<[f64; 2]> {
    let sigma = 0.5 * WIDTH_DEG * pixels_per_degree;
    let gauss = |x: f64| libm::exp(-x * x / (2.0 * sigma * sigma));
    #[allow(clippy::cast_possible_truncation, reason = "a radius of some pixels")]
    let radius = libm::ceil(3.0 * sigma) as i32;
    let smooth = Kernel::new(radius, gauss).normalised();
    let first = Kernel::new(radius, |x| -x * gauss(x)).balanced();
    let second = Kernel::new(radius, |x| (x * x / (sigma * sigma) - 1.0) * gauss(x)).balanced();
    let strength = |derivative: &Kernel| {
        let across = lightness.filtered(derivative, &smooth);
        let down = lightness.filtered(&smooth, derivative);
        let both = across.values().iter().zip(down.values());
        // Lightness Y spans -16 to 100: its derivatives are those of [0, 1] times 116.
        both.map(|(a, b)| (a * a + b * b).sqrt() / 116.0).collect::<Vec<_>>()
    };
    strength(&first).into_iter().zip(strength(&second)).map(|(edge, point)| [edge, point]).collect()
}
