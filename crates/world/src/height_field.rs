//! How thick the cloud is where.

use crate::{Map, WorldError};
use glam::DVec3;
use stratiform_quantities::Range;

/// Thickness H in metres over the plane, bilinear and periodic; the top of the cloud is `base + H`. Where H = 0 there is no cloud.
#[derive(Clone, Debug, PartialEq)]
pub struct HeightField {
    map: Map<f64>,
    most: f64,
}

impl HeightField {
    /// Of thicknesses in metres.
    ///
    /// # Errors
    /// [`WorldError::Domain`] names a texel that is negative or not finite.
    pub fn new(map: Map<f64>) -> Result<Self, WorldError> {
        let domain = Range::closed(0.0, 1e5);
        if let Some((i, value)) = map.values().iter().enumerate().find(|(_, value)| !domain.contains(**value))
        {
            let (x, y) = (i % map.side(), i / map.side());
            domain.check(&format!("thickness_m of texel ({x}, {y}), east and north,"), *value)?;
        }
        let most = map.values().iter().copied().fold(0.0, f64::max);
        Ok(Self { map, most })
    }

    /// The same thickness everywhere.
    ///
    /// # Errors
    /// Those of [`new`](Self::new).
    pub fn flat(thickness_m: f64, extent_m: f64) -> Result<Self, WorldError> {
        Self::new(Map::new(1, extent_m, vec![thickness_m])?)
    }

    /// The thickness at a point, m.
    pub fn thickness(&self, x: f64, y: f64) -> f64 {
        self.map.value(x, y)
    }

    /// The greatest thickness, m.
    pub fn most(&self) -> f64 {
        self.most
    }

    /// The texels.
    pub fn map(&self) -> &Map<f64> {
        &self.map
    }

    /// Unit normal of the top, upwards: differences of thickness over one texel each way.
    pub fn normal(&self, x: f64, y: f64) -> DVec3 {
        let step = self.map.extent_m() / self.map.side() as f64;
        let half = 0.5 * step;
        let east = (self.thickness(x + half, y) - self.thickness(x - half, y)) / step;
        let north = (self.thickness(x, y + half) - self.thickness(x, y - half)) / step;
        DVec3::new(-east, -north, 1.0).normalize()
    }
}
