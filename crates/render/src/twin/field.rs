//! The thickness of the cloud, as wgsl/field.wgsl.

use glam::Vec3;
use stratiform_world::HeightField;

/// Thicknesses, bilinear and periodic, in coordinates of texels.
#[derive(Debug)]
pub struct Field {
    side: i64,
    step: f32,
    heights: Vec<f32>,
}

impl Field {
    pub fn new(field: &HeightField) -> Self {
        let map = field.map();
        let heights = map.values().iter().map(|thickness| *thickness as f32).collect();
        Self { side: map.side() as i64, step: (map.extent_m() as f32) / map.side() as f32, heights }
    }

    /// South-west, south-east, north-west, north-east of the cell whose south-west corner is given.
    pub fn corners(&self, [x, y]: [f32; 2]) -> [f32; 4] {
        let wrap = |i: i64| i.rem_euclid(self.side);
        let at = |i: i64, j: i64| self.heights[(wrap(j) * self.side + wrap(i)) as usize];
        let (i, j) = (x as i64, y as i64);
        [at(i, j), at(i + 1, j), at(i, j + 1), at(i + 1, j + 1)]
    }

    pub fn thickness(&self, [x, y]: [f32; 2]) -> f32 {
        let cell = [libm::floorf(x), libm::floorf(y)];
        between(self.corners(cell), [x - cell[0], y - cell[1]])
    }

    /// Unit normal of the top, upwards.
    pub fn normal(&self, [x, y]: [f32; 2]) -> Vec3 {
        let east = (self.thickness([x + 0.5, y]) - self.thickness([x - 0.5, y])) / self.step;
        let north = (self.thickness([x, y + 0.5]) - self.thickness([x, y - 0.5])) / self.step;
        Vec3::new(-east, -north, 1.0).normalize()
    }
}

pub fn between([sw, se, nw, ne]: [f32; 4], [u, v]: [f32; 2]) -> f32 {
    let south = sw + (se - sw) * u;
    let north = nw + (ne - nw) * u;
    south + (north - south) * v
}
