//! Where a ray enters the cloud, cell by cell: what wgsl/march.wgsl finds by its pyramid.

use super::field::{Field, between};

/// A ray in the slab between base and greatest thickness, as in march.wgsl.
#[derive(Debug)]
pub struct Ray {
    pub texel: [f32; 2],
    pub slope: [f32; 2],
    pub height: f32,
    pub rise: f32,
    pub reach: f32,
}

#[derive(Debug)]
pub struct March {
    /// Way to the first point in the cloud, m.
    pub entry: Option<f32>,
    /// Way in the cloud, m, if it was asked for.
    pub chord: f32,
}

/// To the first point in the cloud, or with `whole` to the ray's end.
pub fn march(field: &Field, ray: &Ray, whole: bool) -> March {
    let speed = ray.slope[0].abs().max(ray.slope[1].abs()).max(1e-30);
    let mut found = March { entry: None, chord: 0.0 };
    let mut way = 0.0;
    while way < ray.reach {
        let cell = [0, 1].map(|i| libm::floorf(ray.texel[i] + way * ray.slope[i]));
        let end = leaving(ray, cell).min(ray.reach).max(way);
        for [a, b] in positive_parts(parabola(field, ray, cell, way, end - way)) {
            let entry = found.entry.get_or_insert(way + a * (end - way));
            if !whole {
                return March { entry: Some(*entry), chord: 0.0 };
            }
            found.chord += (b - a) * (end - way);
        }
        way = end + (1e-3 / speed).max(4e-7 * end);
    }
    found
}

/// Way to where the ray leaves a cell.
fn leaving(ray: &Ray, cell: [f32; 2]) -> f32 {
    let way = |i: usize| {
        let edge = if ray.slope[i] > 0.0 { cell[i] + 1.0 } else { cell[i] };
        if ray.slope[i].abs() < 1e-30 { f32::MAX } else { (edge - ray.texel[i]) / ray.slope[i] }
    };
    way(0).min(way(1))
}

/// Thickness minus height from way `start` over `length`: c0 + c1 t + c2 t² of the share t.
fn parabola(field: &Field, ray: &Ray, cell: [f32; 2], start: f32, length: f32) -> [f32; 3] {
    let c = field.corners(cell);
    let at = [0, 1].map(|i| ray.texel[i] + start * ray.slope[i] - cell[i]);
    let along = ray.slope.map(|slope| slope * length);
    let twist = c[0] - c[1] - c[2] + c[3];
    let slope = (c[1] - c[0] + twist * at[1]) * along[0] + (c[2] - c[0] + twist * at[0]) * along[1];
    let height = ray.height + start * ray.rise;
    [between(c, at) - height, slope - ray.rise * length, twist * along[0] * along[1]]
}

/// The parts of [0, 1] where a parabola is positive, by its roots.
fn positive_parts([c0, c1, c2]: [f32; 3]) -> impl Iterator<Item = [f32; 2]> {
    let discriminant = c1 * c1 - 4.0 * c2 * c0;
    let mut edges = [0.0, 1.0, 1.0, 1.0];
    if discriminant > 0.0 {
        let q = -0.5 * (c1 + discriminant.sqrt().copysign(c1));
        let near = if q.abs() > c0.abs() { c0 / q } else { 1.0 };
        let far = if c2.abs() > q.abs() { q / c2 } else { 1.0 };
        edges[1] = near.min(far).clamp(0.0, 1.0);
        edges[2] = near.max(far).clamp(0.0, 1.0);
    }
    (0..3).map(move |i| [edges[i], edges[i + 1]]).filter(move |[a, b]| {
        let middle = 0.5 * (a + b);
        b > a && c0 + middle * (c1 + middle * c2) > 0.0
    })
}
