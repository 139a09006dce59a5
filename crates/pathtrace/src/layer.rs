//! The cloud as rays see it: exact lengths of straight lines within `base <= z <= base + H(x, y)`.
//!
//! Up to the least thickness a ray is inside, above the greatest outside. Between them it is followed through blocks of texels, each with
//! its least and greatest thickness, and texel by texel where these do not tell (Amanatides & Woo 1987). Over one texel H is bilinear,
//! z - base - H a parabola along the ray, and its roots are closed forms. No majorant, no null collisions.

mod patch;
mod stepper;

use glam::DVec3;
use patch::Patch;
use stepper::Stepper;
use stratiform_world::HeightField;

/// Largest number of texels along a block.
const BLOCK: usize = 8;

/// A half-line that is not horizontal.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Ray {
    pub(crate) origin: DVec3,
    /// Of length 1.
    pub(crate) direction: DVec3,
}

impl Ray {
    pub(crate) fn at(&self, t: f64) -> DVec3 {
        self.origin + self.direction * t
    }
}

/// Where a length within the cloud ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum End {
    /// At this distance along the ray.
    Inside(f64),
    /// Nowhere: the ray has left for good, after so many metres within the cloud.
    Left(f64),
}

/// The periodic layer.
pub(crate) struct Layer {
    base: f64,
    side: usize,
    texels_per_m: f64,
    heights: Vec<f64>,
    /// Least and greatest thickness.
    all: [f64; 2],
    /// Texels along a block, blocks along the map, and of each block the least and the greatest thickness.
    block: usize,
    blocks: usize,
    bounds: Vec<[f64; 2]>,
    /// Least thickness within `reach` metres of anywhere over a texel.
    clear: Vec<f32>,
    reach: f64,
}

impl Layer {
    /// `reach` is how far rays commonly go.
    pub(crate) fn new(field: &HeightField, base: f64, reach: f64) -> Self {
        let (map, side) = (field.map(), field.map().side());
        let block = (1..=BLOCK.min(side)).rev().find(|k| side.is_multiple_of(*k)).unwrap_or(1);
        let heights = map.values().to_vec();
        let blocks = side / block;
        let bounds = (0..blocks * blocks).map(|i| {
            // Patches reach to the next texel.
            let (x, y) = (i % blocks * block, i / blocks * block);
            let texels = (0..=block).flat_map(|dy| (0..=block).map(move |dx| (dx, dy)));
            span(texels.map(|(dx, dy)| heights[(y + dy) % side * side + (x + dx) % side]))
        });
        let bounds = bounds.collect();
        let all = span(heights.iter().copied());
        let texels_per_m = side as f64 / map.extent_m();
        let clear = clear(&heights, side, reach * texels_per_m);
        Self { base, side, texels_per_m, heights, all, block, blocks, bounds, clear, reach }
    }

    /// Follows `ray` until it has run `length` metres within the cloud.
    #[inline]
    pub(crate) fn follow(&self, ray: &Ray, length: f64) -> End {
        let sure = if self.all[0] < self.all[1] { self.sure(ray, length) } else { 0.0 };
        if sure >= length {
            return End::Inside(length);
        }
        match self.trace(&Ray { origin: ray.at(sure), ..*ray }, length - sure) {
            End::Inside(t) => End::Inside(sure + t),
            End::Left(inside) => End::Left(sure + inside),
        }
    }

    /// A first part of `length` metres that is inside by what surrounds the ray.
    #[inline]
    fn sure(&self, ray: &Ray, length: f64) -> f64 {
        let mut sure = 0.0;
        while sure < length {
            let step = self.reach.min(length - sure);
            if !self.is_inside(ray.at(sure), ray.direction.z * step) {
                break;
            }
            sure += step;
        }
        sure
    }

    /// Whether all within reach of `point` and up to `rise` above it is cloud for certain.
    #[inline]
    fn is_inside(&self, point: DVec3, rise: f64) -> bool {
        let z = point.z - self.base;
        let (low, high) = (z.min(z + rise), z.max(z + rise));
        if !(low >= 0.0 && high <= self.all[1]) {
            return false;
        }
        let cell = |x: f64| wrap(floor(x * self.texels_per_m - 0.5), self.side);
        high <= f64::from(self.clear[cell(point.y) * self.side + cell(point.x)])
    }

    /// The same, piece by piece.
    fn trace(&self, ray: &Ray, length: f64) -> End {
        let z = ray.origin.z - self.base;
        let slope = 1.0 / ray.direction.z;
        let cross = |height: f64| (height - z) * slope;
        let [low, middle, high] = [cross(0.0), cross(self.all[0]), cross(self.all[1])];
        let mut run = Run { left: length, inside: 0.0 };
        let end = if slope > 0.0 {
            run.through(low, middle).or_else(|| self.rough(ray, middle, high, &mut run))
        } else {
            self.rough(ray, high, middle, &mut run).or_else(|| run.through(middle, low))
        };
        end.map_or(End::Left(run.inside), End::Inside)
    }

    /// Length of the whole ray within the cloud.
    pub(crate) fn chord(&self, ray: &Ray) -> f64 {
        match self.follow(ray, f64::INFINITY) {
            End::Left(inside) | End::Inside(inside) => inside,
        }
    }

    /// Between least and greatest thickness: the blocks.
    fn rough(&self, ray: &Ray, from: f64, to: f64, run: &mut Run) -> Option<f64> {
        let from = from.max(0.0);
        if from >= to {
            return None;
        }
        let size = self.block as f64;
        let mut blocks = Stepper::new(self.to_texels(ray), 1.0 / size, from);
        loop {
            let [x, y] = blocks.cell;
            let (start, end) = (blocks.start, blocks.end().min(to));
            let bounds = self.bounds[wrap(y, self.blocks) * self.blocks + wrap(x, self.blocks)];
            let found = match self.tell(ray, start, end, bounds) {
                Some(true) => run.through(start, end),
                Some(false) => None,
                None => self.texels(ray, [x, y].map(|k| k * self.block as i64), start, end, run),
            };
            if found.is_some() || end >= to {
                return found;
            }
            blocks.step();
        }
    }

    /// One block, whose first texel is `corner`, texel by texel.
    fn texels(&self, ray: &Ray, corner: [i64; 2], from: f64, to: f64, run: &mut Run) -> Option<f64> {
        let line = self.to_texels(ray);
        let last = corner.map(|k| k + self.block as i64 - 1);
        let mut texels = Stepper::new(line, 1.0, from).within(corner, last);
        loop {
            let (start, end) = (texels.start, texels.end().min(to));
            let corners = self.corners(texels.cell);
            let found = match self.tell(ray, start, end, span(corners.into_iter())) {
                Some(true) => run.through(start, end),
                Some(false) => None,
                None => self.patch(ray, line, texels.cell, corners, [start, end]).walk(run),
            };
            if found.is_some() || end >= to {
                return found;
            }
            texels.step();
        }
    }

    fn patch(
        &self,
        ray: &Ray,
        line: [[f64; 2]; 2],
        cell: [i64; 2],
        corners: [f64; 4],
        [from, to]: [f64; 2],
    ) -> Patch {
        let place = |axis: usize| line[axis][0] + line[axis][1] * from - cell[axis] as f64;
        let at = [place(0), place(1)];
        let height = ray.origin.z - self.base + ray.direction.z * from;
        Patch::new(corners, at, [line[0][1], line[1][1]], [height, ray.direction.z], [from, to])
    }

    /// Whether a piece of the ray is inside for certain, or outside.
    #[inline]
    fn tell(&self, ray: &Ray, from: f64, to: f64, [least, most]: [f64; 2]) -> Option<bool> {
        let z = |t: f64| ray.origin.z - self.base + ray.direction.z * t;
        let (a, b) = (z(from), z(to));
        if a.max(b) <= least {
            Some(true)
        } else if a.min(b) >= most {
            Some(false)
        } else {
            None
        }
    }

    /// South-west, south-east, north-west, north-east.
    #[inline]
    fn corners(&self, [x, y]: [i64; 2]) -> [f64; 4] {
        let (west, row) = (wrap(x, self.side), wrap(y, self.side));
        let next = |k: usize| if k + 1 == self.side { 0 } else { k + 1 };
        let (east, south, north) = (next(west), row * self.side, next(row) * self.side);
        [
            self.heights[south + west],
            self.heights[south + east],
            self.heights[north + west],
            self.heights[north + east],
        ]
    }

    /// Start and speed along each axis, in texels from the first texel's centre.
    fn to_texels(&self, ray: &Ray) -> [[f64; 2]; 2] {
        let axis = |x: f64, d: f64| [x * self.texels_per_m - 0.5, d * self.texels_per_m];
        [axis(ray.origin.x, ray.direction.x), axis(ray.origin.y, ray.direction.y)]
    }
}

/// The length that is still to run within the cloud.
pub(crate) struct Run {
    left: f64,
    inside: f64,
}

impl Run {
    /// Runs from distance `from` to `to`, all inside; the distance at which nothing is left.
    #[inline]
    fn through(&mut self, from: f64, to: f64) -> Option<f64> {
        let from = from.max(0.0);
        let length = to - from;
        if length <= 0.0 {
            return None;
        }
        if length >= self.left {
            return Some(from + self.left);
        }
        self.left -= length;
        self.inside += length;
        None
    }
}

/// The place of `k` in a period of `n`.
#[inline]
fn wrap(k: i64, n: usize) -> usize {
    let n = n as i64;
    (if n & (n - 1) == 0 { k & (n - 1) } else { k.rem_euclid(n) }) as usize
}

/// The next whole number below, without a call.
#[inline]
fn floor(x: f64) -> i64 {
    let towards_zero = x as i64;
    towards_zero - i64::from((towards_zero as f64) > x)
}

/// Least of the heights within `reach` texels of each cell between texels, along both axes in turn.
fn clear(heights: &[f64], side: usize, reach: f64) -> Vec<f32> {
    let reach = (reach.ceil() as usize).min(side);
    let row = |at: &dyn Fn(usize) -> f64| -> Vec<f64> {
        let around = |k: usize| (k + side - reach..=k + side + reach + 1).map(|k| at(k % side));
        (0..side).map(|k| around(k).fold(f64::INFINITY, f64::min)).collect()
    };
    let rows: Vec<Vec<f64>> = (0..side).map(|y| row(&|x| heights[y * side + x])).collect();
    let columns: Vec<Vec<f64>> = (0..side).map(|x| row(&|y| rows[y][x])).collect();
    // Rounded down.
    (0..side * side).map(|i| (columns[i % side][i / side] as f32).next_down().max(0.0)).collect()
}

fn span(values: impl Iterator<Item = f64>) -> [f64; 2] {
    values.fold([f64::INFINITY, 0.0], |[least, most], h| [least.min(h), most.max(h)])
}

#[cfg(test)]
mod tests {
    use super::*;
    use rand::Rng;
    use stratiform_stats::{Purpose, key, photon_stream};
    use stratiform_world::Map;

    /// Hills of up to 500 m, some texels without cloud, over 2 km.
    fn hills(side: usize) -> HeightField {
        let mut rng = photon_stream(key(3, Purpose::Calibration), side as u64);
        let texels =
            (0..side * side).map(|_| (f64::from(rng.next_u32()) / 4_294_967_296.0 - 0.3).max(0.0) * 700.0);
        HeightField::new(Map::new(side, 2000.0, texels.collect()).unwrap()).unwrap()
    }

    fn rays(count: u64) -> impl Iterator<Item = Ray> {
        (0..count).map(|i| {
            let mut rng = photon_stream(key(4, Purpose::Calibration), i);
            let mut number = || f64::from(rng.next_u32()) / 4_294_967_296.0;
            let z = 2.0 * number() - 1.0;
            let (sine, cosine) = libm::sincos(std::f64::consts::TAU * number());
            let across = (1.0 - z * z).sqrt();
            // From beyond the period, from below to above the cloud.
            let origin = DVec3::new(9000.0 * number() - 4000.0, 5000.0 * number(), 900.0 + 700.0 * number());
            Ray { origin, direction: crate::random::level(DVec3::new(across * cosine, across * sine, z)) }
        })
    }

    /// Length inside by midpoints of 0.25 m steps, as far as the ray is within the layer's altitudes.
    fn by_steps(field: &HeightField, ray: &Ray) -> f64 {
        let ends = [1000.0, 1000.0 + field.most()].map(|z| (z - ray.origin.z) / ray.direction.z);
        let (from, to) = (ends[0].min(ends[1]).max(0.0), ends[0].max(ends[1]).min(20_000.0));
        let steps = ((to - from).max(0.0) / 0.25).ceil();
        (0..steps as usize).fold(0.0, |sum, i| {
            let step = (to - from) / steps;
            let p = ray.at(from + (i as f64 + 0.5) * step);
            sum + if p.z - 1000.0 < field.thickness(p.x, p.y) { step } else { 0.0 }
        })
    }

    #[test]
    fn chords_are_those_of_small_steps() {
        for side in [1, 2, 7, 16, 40] {
            let field = hills(side);
            let layer = Layer::new(&field, 1000.0, 60.0);
            let mut inside = 0;
            for ray in rays(400).filter(|ray| ray.direction.z.abs() > 0.03) {
                let (found, expected) = (layer.chord(&ray), by_steps(&field, &ray));
                // Half a step at each surface.
                assert!(
                    (found - expected).abs() < 2.0 + 1e-4 * expected,
                    "{side} {ray:?}: {found} {expected}"
                );
                inside += usize::from(found > 0.0);
            }
            assert!(side == 1 || inside > 100, "guard against checking nothing: {inside}");
        }
    }

    /// What is run up to a place inside is what is asked for, and the place is in the cloud.
    #[test]
    fn a_length_ends_where_the_chord_up_to_it_is_that_long() {
        let field = hills(16);
        let layer = Layer::new(&field, 1000.0, 60.0);
        for ray in rays(2000) {
            let chord = layer.chord(&ray);
            for share in [1e-9, 0.3, 0.999] {
                let End::Inside(t) = layer.follow(&ray, share * chord) else {
                    assert!(chord == 0.0, "{ray:?}");
                    continue;
                };
                let rest = layer.chord(&Ray { origin: ray.at(t), ..ray });
                assert!(
                    (share * chord + rest - chord).abs() < 1e-6 * (1.0 + chord),
                    "{ray:?}: {rest} of {chord}"
                );
            }
            assert_eq!(layer.follow(&ray, chord + 1e-6 * (1.0 + chord)), End::Left(chord));
        }
    }

    #[test]
    fn a_flat_layer_is_a_slab_and_nothing_is_empty() {
        let slab = Layer::new(&HeightField::flat(200.0, 700.0).unwrap(), 1000.0, 60.0);
        let ray = Ray { origin: DVec3::new(3.0, 4.0, 0.0), direction: DVec3::new(0.6, 0.0, 0.8) };
        assert!((slab.chord(&ray) - 250.0).abs() < 1e-9);
        assert_eq!(slab.chord(&Ray { origin: DVec3::new(0.0, 0.0, 1300.0), ..ray }), 0.0);
        let up = Ray { direction: DVec3::Z, ..ray };
        assert!((slab.chord(&up) - 200.0).abs() < 1e-9);
        let empty = Layer::new(&HeightField::flat(0.0, 700.0).unwrap(), 1000.0, 60.0);
        assert_eq!((empty.chord(&ray), empty.follow(&up, 1e-300)), (0.0, End::Left(0.0)));
    }
}
