//! Noise over the unit square that repeats itself, and evolves without a jump.
//!
//! Gradient noise after Perlin (SIGGRAPH 1985 and 2002: quintic weights), whose gradients turn with time as in Perlin & Neyret's flow noise
//! (SIGGRAPH 2001 sketches); sums of its octaves; cells after Worley (SIGGRAPH 1996), whose points walk in circles. `turn` is the share of
//! the time after which all is back where it began; noise of one `turn` is a function of place alone.

use super::hash;
use std::f64::consts::{SQRT_2, TAU};

/// One octave: a gradient at each lattice point.
pub struct Gradients {
    cells: usize,
    gradients: Vec<(f64, f64)>,
}

impl Gradients {
    /// With `cells` of them each way.
    pub fn new(cells: usize, lattice: u64, turn: f64) -> Self {
        let gradient = |i: usize| {
            let (x, y) = (i % cells, i / cells);
            let sense = if hash::share(lattice, x, y, 1) < 0.5 { -1.0 } else { 1.0 };
            let (sine, cosine) = libm::sincos(TAU * (hash::share(lattice, x, y, 0) + sense * turn));
            (cosine, sine)
        };
        Self { cells, gradients: (0..cells * cells).map(gradient).collect() }
    }

    /// From -1 to 1, 0 at the lattice points.
    pub fn value(&self, u: f64, v: f64) -> f64 {
        let (west, x) = split(u, self.cells);
        let (south, y) = split(v, self.cells);
        let (east, north) = ((west + 1) % self.cells, (south + 1) % self.cells);
        let ramp = |column: usize, row: usize, dx: f64, dy: f64| {
            let (gx, gy) = self.gradients[row * self.cells + column];
            gx * dx + gy * dy
        };
        let (sx, sy) = (quintic(x), quintic(y));
        let below = mix(ramp(west, south, x, y), ramp(east, south, x - 1.0, y), sx);
        let above = mix(ramp(west, north, x, y - 1.0), ramp(east, north, x - 1.0, y - 1.0), sx);
        SQRT_2 * mix(below, above, sy)
    }
}

/// Octaves of gradient noise, each of half the size and half the strength.
pub struct Octaves(Vec<Gradients>);

impl Octaves {
    /// From `cells` each way on, as many as asked for, but none of more than `finest` cells.
    pub fn new(cells: usize, count: u32, finest: usize, seed: u64, turn: f64) -> Self {
        let sizes = (0..count).map(|octave| cells << octave).take_while(|size| *size <= finest.max(cells));
        let octave = |(k, size): (u64, usize)| Gradients::new(size, seed.wrapping_add(k), turn);
        Self((0..).zip(sizes).map(octave).collect())
    }

    /// From -2 to 2.
    pub fn value(&self, u: f64, v: f64) -> f64 {
        let sum =
            |(sum, weight): (f64, f64), octave: &Gradients| (sum + weight * octave.value(u, v), 0.5 * weight);
        self.0.iter().fold((0.0, 1.0), sum).0
    }
}

/// One point in each square of a lattice.
pub struct Cells {
    cells: usize,
    points: Vec<(f64, f64)>,
}

/// A point stays this far from the edges of its square, so that the nearest is among the nine round a place.
const MARGIN: f64 = 0.15;
/// Radius of its walk.
const WALK: f64 = 0.15;
/// How sharply the nearest point wins.
const SHARPNESS: f64 = 12.0;

impl Cells {
    /// With `cells` squares each way.
    pub fn new(cells: usize, lattice: u64, turn: f64) -> Self {
        let room = 1.0 - 2.0 * (MARGIN + WALK);
        let point = |i: usize| {
            let share = |which| hash::share(lattice, i % cells, i / cells, which);
            let (sine, cosine) = libm::sincos(TAU * (share(2) + turn));
            let within = |share: f64, walk: f64| MARGIN + WALK + room * share + WALK * walk;
            (within(share(0), cosine), within(share(1), sine))
        };
        Self { cells, points: (0..cells * cells).map(point).collect() }
    }

    /// Square of the distance to the nearest point in widths of a square, from about 0 to 1; rounded where two are as near.
    pub fn value(&self, u: f64, v: f64) -> f64 {
        let (column, x) = split(u, self.cells);
        let (row, y) = split(v, self.cells);
        let n = self.cells;
        let mut sum = 0.0;
        for (j, dy) in [n - 1, 0, 1].into_iter().zip([-1.0, 0.0, 1.0]) {
            for (i, dx) in [n - 1, 0, 1].into_iter().zip([-1.0, 0.0, 1.0]) {
                let (px, py) = self.points[(row + j) % n * n + (column + i) % n];
                let (ax, ay) = (px + dx - x, py + dy - y);
                sum += libm::exp(-SHARPNESS * (ax * ax + ay * ay));
            }
        }
        -libm::log(sum) / SHARPNESS
    }
}

/// The square that a place lies in, and where in it.
fn split(u: f64, cells: usize) -> (usize, f64) {
    let scaled = (u - libm::floor(u)) * cells as f64;
    let whole = libm::floor(scaled);
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "0 or more, cells at most")]
    (whole as usize % cells, scaled - whole)
}

fn quintic(x: f64) -> f64 {
    x * x * x * (x * (6.0 * x - 15.0) + 10.0)
}

fn mix(a: f64, b: f64, share: f64) -> f64 {
    a + (b - a) * share
}

#[cfg(test)]
mod tests {
    use super::*;

    fn places() -> impl Iterator<Item = (f64, f64)> {
        (0..400).map(|i| (hash::share(1, i, 0, 0), hash::share(1, i, 1, 0)))
    }

    fn kinds(turn: f64) -> [Box<dyn Fn(f64, f64) -> f64>; 3] {
        let (gradients, octaves) = (Gradients::new(5, 7, turn), Octaves::new(3, 5, 64, 7, turn));
        let cells = Cells::new(4, 7, turn);
        [
            Box::new(move |u, v| gradients.value(u, v)),
            Box::new(move |u, v| octaves.value(u, v)),
            Box::new(move |u, v| cells.value(u, v)),
        ]
    }

    #[test]
    fn all_repeat_themselves_in_place_and_time() {
        for ((now, later), small) in kinds(0.2).iter().zip(kinds(1.2)).zip([1e-12; 3]) {
            for (u, v) in places() {
                assert!((now(u, v) - now(u + 1.0, v - 2.0)).abs() < small);
                assert!((now(u, v) - later(u, v)).abs() < small);
            }
        }
    }

    #[test]
    fn none_jumps_in_place_or_time() {
        for (now, soon) in kinds(0.2).iter().zip(kinds(0.2 + 1e-6)) {
            for (u, v) in places() {
                assert!((now(u, v) - now(u + 1e-6, v)).abs() < 1e-4);
                assert!((now(u, v) - soon(u, v)).abs() < 1e-4);
            }
        }
    }

    #[test]
    fn gradient_noise_is_nought_at_its_lattice_and_within_its_bounds() {
        let noise = Gradients::new(5, 7, 0.0);
        assert!(noise.value(0.4, 0.8).abs() < 1e-14);
        let most = places().map(|(u, v)| noise.value(u, v).abs()).fold(0.0, f64::max);
        assert!(most > 0.5 && most <= 1.0, "{most}");
    }
}
