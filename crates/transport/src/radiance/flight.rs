//! Photons side by side in three dimensions, of which only the ends are seen.
//!
//! As [`walk`](crate::walk), with the arithmetic of [`lanes`](crate::lanes): a photon draws from its own stream, one word for each
//! collision that may absorb, one for the angle, one for both azimuth and path, as [`single`](crate::single) tells. Directions turn in
//! the frame of Duff et al. (2017), which has no branch, and are drawn back to length 1 by one Newton step. Nothing is fused: the same
//! bits on every processor. A photon that ends is replaced by the next one.

use crate::TraceMedium;
use crate::kernels::{azimuth_cosine, flight_path};
use crate::lanes::{LANES, Row, Streams};
use crate::launches::Launches;
use crate::walk::{End, sunbeam};
use glam::DVec3;
use std::ops::Range;
use stratiform_optics::sampling::SamplingTable;
use stratiform_quantities::{CosZenith, Incidence, Side};

/// A quarter of a turn in the words of azimuths.
const QUARTER: u32 = 1 << 30;

/// What flies on, and what has ended: through the top, through the bottom, in a collision.
const FLIES: u8 = 0;
const TOP: u8 = 1;
const BOTTOM: u8 = 2;
const ABSORBED: u8 = 3;

/// One slab under one sun.
pub(super) struct Flight<'a> {
    table: &'a SamplingTable,
    /// A collision absorbs where its random word is not below this.
    absorbs_from: u64,
    bottom: f64,
    sun: CosZenith,
    key: u64,
}

/// Photons field by field. A lane without one has no depth (NaN).
struct Lanes {
    streams: Streams,
    direction: [Row<f64>; 3],
    depth: Row<f64>,
    order: Row<u64>,
    state: Row<u8>,
}

impl<'a> Flight<'a> {
    /// Through `medium` down to `bottom`, from the `sun`; `key` is that of the streams.
    pub fn new(medium: &'a TraceMedium, bottom: f64, sun: CosZenith, key: u64) -> Self {
        let absorbs_from = (medium.albedo() * 4_294_967_296.0).round() as u64;
        Self { table: medium.table(), absorbs_from, bottom, sun, key }
    }

    /// Traces `photons` and shows the end of each that met a droplet.
    pub fn trace(&self, photons: Range<u64>, ended: &mut dyn FnMut(&End)) {
        trace(self, &[photons], ended);
    }

    /// Puts the next photon that does not pass the slab in its first flight into `lane`; whether there was one.
    #[inline(always)]
    fn launch(&self, lanes: &mut Lanes, lane: usize, launches: &mut Launches<'_, f64>) -> bool {
        while let Some(from) = launches.next(self.key, Incidence::Beam(self.sun)) {
            if launches.row.0[from] == 0 {
                lanes.streams.state.0[lane] = launches.streams.state.0[from];
                lanes.streams.increment.0[lane] = launches.streams.increment.0[from];
                let sun = sunbeam(self.sun.get()).to_array();
                lanes.direction.iter_mut().zip(sun).for_each(|(row, part)| row.0[lane] = part);
                (lanes.depth.0[lane], lanes.order.0[lane]) = (launches.depth.0[from], 0);
                return true;
            }
        }
        lanes.depth.0[lane] = f64::NAN;
        false
    }
}

#[multiversion::multiversion(targets("x86_64+avx512f+avx512dq+avx512vl", "x86_64+avx2"))]
fn trace(flight: &Flight<'_>, photons: &[Range<u64>], ended: &mut dyn FnMut(&End)) {
    let mut launches = Launches::new(photons, vec![flight.bottom]);
    let mut lanes = Lanes::parked();
    let mut alive = (0..LANES).filter(|lane| flight.launch(&mut lanes, *lane, &mut launches)).count();
    while alive > 0 {
        step(&mut lanes, flight);
        for lane in 0..LANES {
            if lanes.state.0[lane] != FLIES {
                ended(&lanes.end(lane));
                alive -= usize::from(!flight.launch(&mut lanes, lane, &mut launches));
            }
        }
    }
}

impl Lanes {
    fn parked() -> Self {
        Self {
            streams: Streams::default(),
            direction: [0.0, 0.0, 1.0].map(|part| Row([part; LANES])),
            depth: Row([f64::NAN; LANES]),
            order: Row([0; LANES]),
            state: Row([FLIES; LANES]),
        }
    }

    fn end(&self, lane: usize) -> End {
        let side = match self.state.0[lane] {
            TOP => Some(Side::Top),
            BOTTOM => Some(Side::Bottom),
            _ => None,
        };
        let direction = DVec3::from_array([0, 1, 2].map(|part: usize| self.direction[part].0[lane]));
        End { side, order: self.order.0[lane], direction }
    }
}

/// One collision and the flight after it in every lane.
#[inline(always)]
fn step(lanes: &mut Lanes, flight: &Flight<'_>) {
    let mut absorbed = Row([FLIES; LANES]);
    if flight.absorbs_from < 1 << 32 {
        let words = lanes.streams.draw();
        for k in 0..LANES {
            absorbed.0[k] = if words.0[k] >= flight.absorbs_from as u32 { ABSORBED } else { FLIES };
        }
    }
    let angles = Row(flight.table.sample_all(&lanes.streams.draw().0));
    let words = lanes.streams.draw();
    let [x, y, z] = &mut lanes.direction;
    for k in 0..LANES {
        let azimuth = [azimuth_cosine(words.0[k]), azimuth_cosine(words.0[k].wrapping_sub(QUARTER))];
        [x.0[k], y.0[k], z.0[k]] = turned([x.0[k], y.0[k], z.0[k]], angles.0[k], azimuth);
    }
    for k in 0..LANES {
        lanes.depth.0[k] += z.0[k] * flight_path(words.0[k]);
        lanes.order.0[k] += 1;
    }
    for k in 0..LANES {
        let depth = lanes.depth.0[k];
        let below = if depth >= flight.bottom { BOTTOM } else { FLIES };
        let left = if depth < 0.0 { TOP } else { below };
        let absorbed = if depth.is_nan() { FLIES } else { absorbed.0[k] };
        lanes.state.0[k] = if absorbed == FLIES { left } else { absorbed };
    }
}

/// The direction at 1 - cosΘ = `v` from (x, y, z), at an azimuth of this cosine and sine.
#[inline(always)]
fn turned([x, y, z]: [f64; 3], v: f64, [cosine, sine]: [f64; 2]) -> [f64; 3] {
    let sign = 1.0_f64.copysign(z);
    let a = -1.0 / (sign + z);
    let b = x * y * a;
    let radius = (v * (2.0 - v)).max(0.0).sqrt();
    let (across, up) = (radius * cosine, radius * sine);
    let new = [
        x - v * x + across * (1.0 + sign * x * x * a) + up * b,
        y - v * y + across * sign * b + up * (sign + y * y * a),
        z - v * z - across * sign * x - up * y,
    ];
    let length = 1.5 - 0.5 * (new[0] * new[0] + new[1] * new[1] + new[2] * new[2]);
    new.map(|part| part * length)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Length 1, the angle asked for, and azimuths a quarter of a turn apart, from directions all over the sphere.
    #[test]
    fn directions_turn_by_the_angle() {
        for i in 0..1000_u32 {
            let word = |salt: u32| (3 * i + salt).wrapping_mul(2_654_435_761);
            let (z, turn) =
                (azimuth_cosine(word(0)), [word(1), word(1).wrapping_sub(QUARTER)].map(azimuth_cosine));
            let rim = (1.0 - z * z).max(0.0).sqrt();
            let before = DVec3::new(rim * turn[0], rim * turn[1], z);
            let v = 1.0 - azimuth_cosine(word(2));
            let after = [0, 1, 2].map(|quarters: u32| {
                let bits = word(1).wrapping_add(quarters * QUARTER);
                let azimuth = [azimuth_cosine(bits), azimuth_cosine(bits.wrapping_sub(QUARTER))];
                DVec3::from_array(turned(before.to_array(), v, azimuth))
            });
            for after in after {
                let off = [after.length() - 1.0, before.dot(after) - 1.0 + v];
                assert!(off.iter().all(|off| off.abs() < 1e-12), "{before} {v}: {off:?}");
            }
            let [a, b, c] = after.map(|after| after - before * (1.0 - v));
            assert!(a.dot(b).abs() < 1e-11 && (a + c).length() < 1e-11, "{i}");
        }
    }
}
