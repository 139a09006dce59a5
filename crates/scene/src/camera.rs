//! `[camera]`: where a picture is seen from, and which angles it shows.
//!
//! Metres, x to the east, y to the north, z up from the ground; azimuth clockwise from north, elevation above the horizon.

use crate::{Interval, View};
use serde::{Deserialize, Serialize};
use stratiform_quantities::Side;

/// A pinhole with square pixels, upright.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Camera {
    /// East, north, altitude.
    pub position_m: [f64; 3],
    /// Where it looks, clockwise from north.
    pub azimuth_deg: f64,
    /// Above the horizon.
    pub elevation_deg: f64,
    /// From the lower to the upper edge.
    #[serde(default = "field_of_view")]
    pub field_of_view_deg: f64,
    /// Columns.
    #[serde(default = "width")]
    pub width: u32,
    /// Rows.
    #[serde(default = "height")]
    pub height: u32,
}

fn field_of_view() -> f64 {
    50.0
}

fn width() -> u32 {
    480
}

fn height() -> u32 {
    270
}

/// Light that leaves nearer to the horizon is left out of a derived view: no method of slabs holds there.
pub const GRAZING_DEG: f64 = 87.0;

/// Rays across the picture and down it that a view is derived from.
const RAYS: u32 = 33;

/// Unit vector of an azimuth and an elevation.
pub fn direction(azimuth_deg: f64, elevation_deg: f64) -> [f64; 3] {
    let (sin_a, cos_a) = libm::sincos(azimuth_deg.to_radians());
    let (sin_e, cos_e) = libm::sincos(elevation_deg.to_radians());
    [sin_a * cos_e, cos_a * cos_e, sin_e]
}

impl Camera {
    /// Unit vectors forward, to the right, and to the top of the picture.
    pub fn axes(&self) -> [[f64; 3]; 3] {
        let forward = direction(self.azimuth_deg, self.elevation_deg);
        let right = direction(self.azimuth_deg + 90.0, 0.0);
        [forward, right, direction(self.azimuth_deg, self.elevation_deg + 90.0)]
    }

    /// Tangent of half the field of view.
    pub fn tan_half(&self) -> f64 {
        libm::tan(0.5 * self.field_of_view_deg.to_radians())
    }

    /// Angles of the light that reaches it from a layer with this base under a sun of this azimuth; `None` if it sees no cloud.
    pub fn view(&self, base_m: f64, sun_azimuth_deg: f64) -> Option<View> {
        let above = self.position_m[2] >= base_m;
        let sun = direction(sun_azimuth_deg, 0.0);
        let seen: Vec<(f64, f64)> = self
            .rays()
            .filter(|ray| (ray[2] < 0.0) == above)
            .map(|ray| angles(ray, sun))
            .filter(|(theta_deg, _)| *theta_deg <= GRAZING_DEG)
            .collect();
        let range = |of: fn(&(f64, f64)) -> f64| Interval {
            min: seen.iter().map(of).fold(f64::INFINITY, f64::min),
            max: seen.iter().map(of).fold(0.0, f64::max),
        };
        let side = if above { Side::Top } else { Side::Bottom };
        (!seen.is_empty()).then(|| View {
            theta_deg: range(|angles| angles.0),
            azimuth_deg: range(|angles| angles.1),
            sides: vec![side],
        })
    }

    /// Directions of rays in equal steps over the picture, edges included.
    fn rays(&self) -> impl Iterator<Item = [f64; 3]> {
        let [forward, right, up] = self.axes();
        let tan = self.tan_half();
        let across = tan * f64::from(self.width) / f64::from(self.height);
        let step = |i: u32| 2.0 * f64::from(i) / f64::from(RAYS - 1) - 1.0;
        (0..RAYS * RAYS).map(move |i| {
            let (u, v) = (across * step(i % RAYS), tan * step(i / RAYS));
            let ray: [f64; 3] = std::array::from_fn(|k| forward[k] + u * right[k] + v * up[k]);
            let length = ray.iter().map(|x| x * x).sum::<f64>().sqrt();
            ray.map(|x| x / length)
        })
    }
}

/// Angle to the vertical, and azimuth of the light against the sun's: 0 where one looks towards the sun.
fn angles(ray: [f64; 3], sun: [f64; 3]) -> (f64, f64) {
    let theta = libm::acos(ray[2].abs().min(1.0)).to_degrees();
    let along = ray[0] * sun[0] + ray[1] * sun[1];
    let across = ray[0] * sun[1] - ray[1] * sun[0];
    (theta, libm::atan2(across.abs(), along).to_degrees())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn camera(position_m: [f64; 3], azimuth_deg: f64, elevation_deg: f64) -> Camera {
        Camera { position_m, azimuth_deg, elevation_deg, field_of_view_deg: 20.0, width: 32, height: 32 }
    }

    #[test]
    fn axes_are_those_of_a_compass() {
        let [forward, right, up] = camera([0.0; 3], 90.0, 0.0).axes();
        let near = |a: [f64; 3], b: [f64; 3]| (0..3).all(|k| (a[k] - b[k]).abs() < 1e-15);
        assert!(near(forward, [1.0, 0.0, 0.0]) && near(right, [0.0, -1.0, 0.0]) && near(up, [0.0, 0.0, 1.0]));
    }

    #[test]
    fn a_view_is_the_frustums_part_that_meets_the_layer() {
        let down = camera([0.0, 0.0, 5000.0], 180.0, -45.0).view(2000.0, 180.0).unwrap();
        assert_eq!(down.sides, [Side::Top]);
        assert!((down.theta_deg.min - 35.0).abs() < 0.01 && (down.theta_deg.max - 55.0).abs() < 0.6);
        assert!(down.azimuth_deg.min < 1e-9 && (down.azimuth_deg.max - 16.0).abs() < 1.0);
        let up = camera([0.0, 0.0, 2.0], 0.0, 10.0).view(2000.0, 180.0).unwrap();
        assert_eq!(up.sides, [Side::Bottom]);
        assert!(up.theta_deg.max <= GRAZING_DEG && up.azimuth_deg.max == 180.0);
        assert_eq!(camera([0.0, 0.0, 2.0], 0.0, -45.0).view(2000.0, 180.0), None);
    }
}
