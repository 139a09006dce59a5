//! FLIP's colour pipeline (Andersson et al. 2020, section 4.1).
//!
//! Contrast sensitivity: Gaussians a √(π/b) exp(-π² x²/b) of the distance x in degrees, table 1 of the paper: lightness
//! (a, b) = (1, 0.0047), red-green (1, 0.0053), blue-yellow the sum of (34.1, 0.04) and (13.5, 0.025). Distance: |ΔL| + √(Δa² + Δb²)
//! with a, b times 0.01 L (Hunt), to the power 0.7; distances below 0.4 of the largest (green to blue) are stretched over [0, 0.95].

use super::Opponent;
use super::filter::Kernel;
use crate::srgb;
use std::f64::consts::PI;

/// White of D65 in XYZ, as the matrix below gives it for (1, 1, 1).
const WHITE: [f64; 3] = [
    (10_135_552.0 + 8_788_810.0 + 4_435_075.0) / 24_577_794.0,
    1.0,
    (1_425_312.0 + 8_788_810.0 + 70_074_185.0) / 73_733_382.0,
];
/// Linear sRGB to XYZ in exact fractions of the primaries.
const TO_XYZ: [[f64; 3]; 3] = [
    [10_135_552.0 / 24_577_794.0, 8_788_810.0 / 24_577_794.0, 4_435_075.0 / 24_577_794.0],
    [2_613_072.0 / 12_288_897.0, 8_788_810.0 / 12_288_897.0, 887_015.0 / 12_288_897.0],
    [1_425_312.0 / 73_733_382.0, 8_788_810.0 / 73_733_382.0, 70_074_185.0 / 73_733_382.0],
];
/// Its inverse.
const FROM_XYZ: [[f64; 3]; 3] = [
    [3.241_003_275, -1.537_398_934, -0.498_615_861],
    [-0.969_224_334, 1.875_930_071, 0.041_554_224],
    [0.055_639_423, -0.204_011_202, 1.057_148_933],
];
const LIGHTNESS: (f64, f64) = (1.0, 0.0047);
const RED_GREEN: (f64, f64) = (1.0, 0.0053);
const BLUE_YELLOW: [(f64, f64); 2] = [(34.1, 0.04), (13.5, 0.025)];
/// Exponent of the distance, and the point (0.4 of the largest, 0.95) of its redistribution.
const EXPONENT: f64 = 0.7;
const BEND: (f64, f64) = (0.4, 0.95);

/// Y, Cx, Cz of a stored sRGB colour.
pub fn opponent(stored: [f64; 3]) -> [f64; 3] {
    let [x, y, z] = to_relative_xyz(stored.map(srgb::decode));
    [116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)]
}

fn times(matrix: &[[f64; 3]; 3], v: [f64; 3]) -> [f64; 3] {
    std::array::from_fn(|i| matrix[i][0] * v[0] + matrix[i][1] * v[1] + matrix[i][2] * v[2])
}

/// XYZ over that of white.
fn to_relative_xyz(linear: [f64; 3]) -> [f64; 3] {
    let xyz = times(&TO_XYZ, linear);
    std::array::from_fn(|i| xyz[i] / WHITE[i])
}

/// Redistributed colour distance of every pixel, in [0, 1].
pub fn differences(truth: &Opponent, picture: &Opponent, pixels_per_degree: f64) -> Vec<f64> {
    let [a, b] = [truth, picture].map(|planes| seen(planes, pixels_per_degree));
    let largest = largest();
    a.iter().zip(&b).map(|(a, b)| redistributed(libm::pow(distance(*a, *b), EXPONENT), largest)).collect()
}

/// Hunt-adjusted CIELAB of every pixel as the eye resolves it.
fn seen([y, cx, cz]: &Opponent, pixels_per_degree: f64) -> Vec<[f64; 3]> {
    let radius = libm::ceil(3.0 * (BLUE_YELLOW[0].1 / (2.0 * PI * PI)).sqrt() * pixels_per_degree);
    let kernel = |(_, b): (f64, f64)| {
        #[allow(clippy::cast_possible_truncation, reason = "a radius of some pixels")]
        let raw = Kernel::new(radius as i32, |i| {
            let x = i / pixels_per_degree;
            libm::exp(-PI * PI * x * x / b)
        });
        let sum = raw.sum();
        (raw.normalised(), sum)
    };
    let [(lightness, _), (red_green, _)] = [LIGHTNESS, RED_GREEN].map(kernel);
    let y = y.filtered(&lightness, &lightness);
    let cx = cx.filtered(&red_green, &red_green);
    let parts = BLUE_YELLOW.map(|(a, b)| {
        let (kernel, sum) = kernel((a, b));
        (cz.filtered(&kernel, &kernel), a * (PI / b).sqrt() * sum * sum)
    });
    let whole = parts[0].1 + parts[1].1;
    let cz = parts[0].0.values().iter().zip(parts[1].0.values());
    let cz = cz.map(|(first, second)| (first * parts[0].1 + second * parts[1].1) / whole);
    y.values().iter().zip(cx.values()).zip(cz).map(|((y, cx), cz)| hunt(lab_of([*y, *cx, cz]))).collect()
}

/// CIELAB of a filtered colour, brought into the display's gamut first.
fn lab_of([y, cx, cz]: [f64; 3]) -> [f64; 3] {
    let y = (y + 16.0) / 116.0;
    let relative = [y + cx / 500.0, y, y - cz / 200.0];
    let linear = times(&FROM_XYZ, std::array::from_fn(|i| relative[i] * WHITE[i]));
    lab(linear.map(|channel| channel.clamp(0.0, 1.0)))
}

fn lab(linear: [f64; 3]) -> [f64; 3] {
    const DELTA: f64 = 6.0 / 29.0;
    let root = |t: f64| {
        if t > DELTA * DELTA * DELTA { libm::cbrt(t) } else { t / (3.0 * DELTA * DELTA) + 4.0 / 29.0 }
    };
    let [x, y, z] = to_relative_xyz(linear).map(root);
    [116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)]
}

fn hunt([l, a, b]: [f64; 3]) -> [f64; 3] {
    [l, 0.01 * l * a, 0.01 * l * b]
}

/// HyAB.
fn distance(p: [f64; 3], q: [f64; 3]) -> f64 {
    let [dl, da, db] = std::array::from_fn(|i| p[i] - q[i]);
    dl.abs() + (da * da + db * db).sqrt()
}

/// That of green and blue, the largest of the gamut.
fn largest() -> f64 {
    let [green, blue] = [[0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(|colour| hunt(lab(colour)));
    libm::pow(distance(green, blue), EXPONENT)
}

fn redistributed(distance: f64, largest: f64) -> f64 {
    let (share, value) = BEND;
    let bend = share * largest;
    if distance < bend {
        value / bend * distance
    } else {
        value + (distance - bend) / (largest - bend) * (1.0 - value)
    }
}
