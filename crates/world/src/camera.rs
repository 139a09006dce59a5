//! Where a picture is seen from.

use glam::DVec3;

/// A pinhole with square pixels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    /// Where it is, m.
    pub position: DVec3,
    /// Where it looks, to its right, and its up: orthonormal.
    pub forward: DVec3,
    /// To the right of the picture.
    pub right: DVec3,
    /// To the top of the picture.
    pub up: DVec3,
    /// Tangent of half the vertical field of view.
    pub tan_half: f64,
    /// Columns.
    pub width: usize,
    /// Rows.
    pub height: usize,
}

impl Camera {
    /// Direction of the ray through `(x, y)` in pixels from the top left; a pixel's centre is at + 1/2.
    pub fn ray(&self, x: f64, y: f64) -> DVec3 {
        let scale = 2.0 * self.tan_half / self.height as f64;
        let across = (x - 0.5 * self.width as f64) * scale;
        let upwards = (0.5 * self.height as f64 - y) * scale;
        (self.forward + across * self.right + upwards * self.up).normalize()
    }
}
