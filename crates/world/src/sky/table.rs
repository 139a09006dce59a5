//! A sky as a table, and the map from directions to texels, in square roots alone: every machine finds the same place.
//!
//! Column: u = sin(Δφ/2) = √((1 - cosΔφ)/2), Δφ the azimuth from the sun's; dense at the sun. Row: with z the sine of the
//! elevation v = √(z/2) for z < ½ and 1 - √((1 - z)/2) from there on; dense at horizon and zenith. Texel (i, j) stands at u = i/(width - 1),
//! v = j/(height - 1); between texels the table is bilinear in u and v.

use glam::DVec3;

/// Radiances of the upper hemisphere, symmetric about the sun's meridian.
#[derive(Clone, Debug, PartialEq)]
pub struct SkyTable {
    /// Columns: azimuth from the sun's, 0 to 180°.
    pub width: usize,
    /// Rows: elevation, 0 to 90°.
    pub height: usize,
    /// Row by row from the horizon: linear sRGB.
    pub values: Vec<[f32; 3]>,
    /// Unit vector of the sun's azimuth: east, north.
    pub towards_sun: [f64; 2],
}

impl SkyTable {
    /// One texel.
    pub fn uniform(radiance: [f64; 3]) -> Self {
        let texel = radiance.map(single);
        Self { width: 1, height: 1, values: vec![texel], towards_sun: [0.0, 1.0] }
    }

    /// Of the radiances that `of` gives for (sine of the elevation, cosine of the azimuth from the sun's), row by row.
    pub(super) fn new(
        [width, height]: [usize; 2],
        towards_sun: [f64; 2],
        of: impl Fn(f64, f64) -> [f64; 3] + Sync,
    ) -> Self {
        use rayon::prelude::*;
        let share = |i: usize, count: usize| i as f64 / (count - 1) as f64;
        let texel = |k: usize| {
            let u = share(k % width, width);
            of(sine_of_row(share(k / width, height)), 1.0 - 2.0 * u * u).map(single)
        };
        let values = (0..width * height).into_par_iter().map(texel).collect();
        Self { width, height, values, towards_sun }
    }

    /// The look-up at a direction above the horizon.
    pub fn radiance(&self, direction: DVec3) -> [f64; 3] {
        let across = (direction.x * direction.x + direction.y * direction.y).sqrt();
        let along = direction.x * self.towards_sun[0] + direction.y * self.towards_sun[1];
        // At the zenith all azimuths are one.
        let cosine = if across > 0.0 { (along / across).clamp(-1.0, 1.0) } else { 0.0 };
        self.at(direction.z.clamp(0.0, 1.0), cosine)
    }

    /// The look-up at a sine of the elevation and a cosine of the azimuth from the sun's.
    pub(super) fn at(&self, sine: f64, cosine: f64) -> [f64; 3] {
        let (left, right, s) = place((0.5 * (1.0 - cosine)).sqrt(), self.width);
        let (below, above, t) = place(row_of_sine(sine), self.height);
        let value = |x: usize, y: usize, c: usize| f64::from(self.values[y * self.width + x][c]);
        std::array::from_fn(|c| {
            let low = value(left, below, c) + (value(right, below, c) - value(left, below, c)) * s;
            let high = value(left, above, c) + (value(right, above, c) - value(left, above, c)) * s;
            low + (high - low) * t
        })
    }
}

#[allow(clippy::cast_possible_truncation, reason = "tables are in single precision, as devices are")]
fn single(value: f64) -> f32 {
    value as f32
}

/// Neighbours of a coordinate in \[0, 1\] among `count` texels, and its share of the way.
#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "between 0 and count")]
fn place(coordinate: f64, count: usize) -> (usize, usize, f64) {
    let place = coordinate * (count - 1) as f64;
    let left = (place as usize).min(count - 1);
    (left, (left + 1).min(count - 1), place - left as f64)
}

fn row_of_sine(z: f64) -> f64 {
    if z < 0.5 { (0.5 * z).sqrt() } else { 1.0 - (0.5 * (1.0 - z)).sqrt() }
}

fn sine_of_row(v: f64) -> f64 {
    let back = 1.0 - v;
    if v < 0.5 { 2.0 * v * v } else { 1.0 - 2.0 * back * back }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn direction(sine: f64, azimuth_deg: f64) -> DVec3 {
        let across = (1.0 - sine * sine).sqrt();
        let azimuth = azimuth_deg.to_radians();
        DVec3::new(across * libm::sin(azimuth), across * libm::cos(azimuth), sine)
    }

    #[test]
    fn rows_and_sines_are_inverse() {
        for i in 0..=100 {
            let v = f64::from(i) / 100.0;
            assert!((row_of_sine(sine_of_row(v)) - v).abs() < 1e-12, "{v}");
        }
    }

    #[test]
    fn texels_come_back_and_the_sun_is_in_column_0() {
        let table = SkyTable::new([9, 7], [0.0, 1.0], |sine, cosine| [sine, cosine, 1.0]);
        for (k, texel) in table.values.iter().enumerate().filter(|(k, _)| k / 9 < 6) {
            let [sine, cosine, _] = texel.map(f64::from);
            let found = table.radiance(direction(sine, libm::acos(cosine.clamp(-1.0, 1.0)).to_degrees()));
            assert!((found[0] - sine).abs() < 1e-5 && (found[1] - cosine).abs() < 1e-5, "{k} {found:?}");
        }
        assert!((table.radiance(direction(0.3, 0.0))[1] - 1.0).abs() < 1e-6);
        assert!((table.radiance(direction(0.3, 180.0))[1] + 1.0).abs() < 1e-6);
        assert_eq!(table.radiance(direction(0.3, 77.0)), table.radiance(direction(0.3, -77.0)));
    }

    #[test]
    fn one_texel_is_a_uniform_sky() {
        let table = SkyTable::uniform([0.25, 0.5, 0.125]);
        for direction in [DVec3::Z, direction(0.0, 10.0), direction(0.9, 200.0)] {
            assert_eq!(table.radiance(direction), [0.25, 0.5, 0.125]);
        }
    }
}
