//! A block of photons side by side: the arithmetic of one collision and one flight, as loops over arrays.
//!
//! The number of lanes is fixed and each photon draws from its own stream, so the instruction set that the
//! processor offers changes the speed and nothing else. The generator is PCG-XSH-RR 64/32 (O'Neill 2014). Loops are
//! long enough for the compiler to keep them loops, which it then turns into vectors of any width.

use crate::real::Real;

/// Photons of one block.
pub(crate) const LANES: usize = 128;
const MULTIPLIER: u64 = 6_364_136_223_846_793_005;

/// One value per lane, where vectors can load it whole.
#[repr(C, align(64))]
#[derive(Clone)]
pub(crate) struct Row<T>(pub [T; LANES]);

/// One bit per lane, in the order of [`lane_of`].
pub(crate) type Mask = u128;

/// A photon about to be scattered for the first time: `bottom` is the next depth at which something is counted, in the
/// row `row`.
pub(crate) struct Photon<R> {
    pub state: u64,
    pub increment: u64,
    pub mu: R,
    pub depth: R,
    pub bottom: R,
    pub row: u32,
}

/// Photons field by field.
#[repr(C)]
#[derive(Clone)]
pub(crate) struct Block<R> {
    /// Steps done.
    pub steps: u64,
    pub streams: Streams,
    pub mu: Row<R>,
    pub depth: Row<R>,
    pub bottom: Row<R>,
    pub row: Row<u32>,
    /// Steps done when the photon had no scattering yet.
    born: Row<u64>,
}

/// What a step brought about, one bit per lane.
#[derive(Clone, Copy, Default)]
pub(crate) struct Events {
    pub absorbed: Mask,
    /// The photon passed its bottom or the top and was not absorbed.
    pub left: Mask,
}

impl<R: Real> Block<R> {
    /// No photon anywhere.
    pub fn parked() -> Self {
        Self {
            steps: 0,
            streams: Streams::default(),
            mu: Row([R::ZERO; LANES]),
            depth: Row([R::PARKED; LANES]),
            bottom: Row([R::INFINITY; LANES]),
            row: Row([0; LANES]),
            born: Row([0; LANES]),
        }
    }

    #[inline(always)]
    pub fn place(&mut self, lane: usize, photon: Photon<R>) {
        self.streams.state.0[lane] = photon.state;
        self.streams.increment.0[lane] = photon.increment;
        self.mu.0[lane] = photon.mu;
        self.depth.0[lane] = photon.depth;
        self.bottom.0[lane] = photon.bottom;
        self.row.0[lane] = photon.row;
        self.born.0[lane] = self.steps;
    }

    /// Scatterings of the photon in `lane`.
    #[inline(always)]
    pub fn order(&self, lane: usize) -> u64 {
        self.steps.wrapping_sub(self.born.0[lane])
    }

    /// The photon in `lane`, to go on as if it had had no scattering yet, in the row `row`.
    #[inline(always)]
    pub fn photon(&self, lane: usize, row: u32) -> Photon<R> {
        Photon {
            state: self.streams.state.0[lane],
            increment: self.streams.increment.0[lane],
            mu: self.mu.0[lane],
            depth: self.depth.0[lane],
            bottom: self.bottom.0[lane],
            row,
        }
    }

    pub fn is_parked(&self, lane: usize) -> bool {
        self.bottom.0[lane] == R::INFINITY
    }

    pub fn park(&mut self, lane: usize) {
        self.depth.0[lane] = R::PARKED;
        self.bottom.0[lane] = R::INFINITY;
    }

    /// One collision and the flight after it in every lane. A collision absorbs where its random word is not below
    /// `absorbs_from`.
    #[inline(always)]
    pub fn collide_and_fly(&mut self, table: &R::Table, absorbs_from: u64) -> Events {
        self.steps = self.steps.wrapping_add(1);
        let absorbed = self.absorb(absorbs_from);
        let angles = Row(R::sample(table, &self.streams.draw().0));
        let words = self.streams.draw();
        let mut paths = Row([R::ZERO; LANES]);
        for k in 0..LANES {
            paths.0[k] = R::flight_path(words.0[k]);
        }
        for k in 0..LANES {
            let mu = self.mu.0[k].scattered(angles.0[k], R::azimuth_cosine(words.0[k]));
            self.mu.0[k] = mu;
            self.depth.0[k] = self.depth.0[k] + mu * paths.0[k];
        }
        Events { absorbed, left: self.left() & !absorbed }
    }

    #[inline(always)]
    fn absorb(&mut self, absorbs_from: u64) -> Mask {
        if absorbs_from >= 1 << 32 {
            return 0;
        }
        let words = self.streams.draw();
        gathered(|k| words.0[k] >= absorbs_from as u32)
    }

    /// The lanes whose photon is above the top or below its bottom.
    #[inline(always)]
    pub fn left(&self) -> Mask {
        gathered(|k| self.depth.0[k].is_out(self.bottom.0[k]))
    }
}

/// One generator per lane.
#[repr(C)]
#[derive(Clone)]
pub(crate) struct Streams {
    pub state: Row<u64>,
    /// Odd.
    pub increment: Row<u64>,
}

impl Default for Streams {
    fn default() -> Self {
        Self { state: Row([0; LANES]), increment: Row([1; LANES]) }
    }
}

impl Streams {
    /// One random word per lane.
    #[inline(always)]
    pub fn draw(&mut self) -> Row<u32> {
        let halves: &[[u32; 2]; LANES] = bytemuck::cast_ref(&self.state.0);
        let mut words = Row([0; LANES]);
        for (word, halves) in words.0.iter_mut().zip(halves) {
            *word = output(*halves);
        }
        self.advance();
        words
    }

    #[inline(always)]
    pub fn advance(&mut self) {
        for k in 0..LANES {
            let next = self.state.0[k].wrapping_mul(MULTIPLIER).wrapping_add(self.increment.0[k]);
            self.state.0[k] = next;
        }
    }
}

/// The permutation of PCG-XSH-RR, of the two halves of a state as they lie in memory.
#[inline(always)]
fn output(halves: [u32; 2]) -> u32 {
    let [low, high] = if cfg!(target_endian = "little") { halves } else { [halves[1], halves[0]] };
    let shifted = ((high << 5) | (low >> 27)) ^ (high >> 13);
    shifted.rotate_right(high >> 27)
}

/// The lane of a mask's bit.
#[inline(always)]
fn lane_of(bit: u32) -> usize {
    ((bit % 8) * 16 + bit / 8) as usize
}

/// The lanes of a mask, one after the other.
pub(crate) struct LanesOf(pub Mask);

impl Iterator for LanesOf {
    type Item = usize;

    #[inline(always)]
    fn next(&mut self) -> Option<usize> {
        if self.0 == 0 {
            return None;
        }
        let bit = self.0.trailing_zeros();
        self.0 &= self.0 - 1;
        Some(lane_of(bit) % LANES)
    }
}

/// Some lanes, each once.
pub(crate) struct LaneList {
    lanes: [u8; LANES],
    count: usize,
}

impl LaneList {
    pub fn all() -> Self {
        Self { lanes: std::array::from_fn(|lane| lane as u8), count: LANES }
    }

    pub fn none() -> Self {
        Self { count: 0, ..Self::all() }
    }

    #[inline(always)]
    pub fn push(&mut self, lane: usize) {
        self.lanes[self.count % LANES] = lane as u8;
        self.count += 1;
    }

    #[inline(always)]
    pub fn pop(&mut self) -> Option<usize> {
        self.count = self.count.checked_sub(1)?;
        Some(usize::from(self.lanes[self.count % LANES]) % LANES)
    }
}

/// The mask of the lanes for which `flag` is true: lane 16i + j is bit i of byte j, so that vectors can add it up.
#[inline(always)]
pub(crate) fn gathered(flag: impl Fn(usize) -> bool) -> Mask {
    let mut flags = [[0_u8; 16]; 8];
    for (lane, one) in flags.as_flattened_mut().iter_mut().enumerate() {
        *one = u8::from(flag(lane));
    }
    let [a, b, c, d, e, f, g, h] = flags;
    let mut bytes = [0; 16];
    for j in 0..16 {
        let low = a[j] | (b[j] << 1) | (c[j] << 2) | (d[j] << 3);
        bytes[j] = low | (e[j] << 4) | (f[j] << 5) | (g[j] << 6) | (h[j] << 7);
    }
    Mask::from_le_bytes(bytes)
}

#[cfg(test)]
mod tests {
    use super::*;
    use rand::Rng;
    use rand_pcg::Pcg32;
    use stratiform_stats::{Purpose, key, photon_stream};

    #[test]
    fn every_lane_continues_its_generator() {
        let mut streams = Streams::default();
        let stream = |lane| photon_stream(key(1, Purpose::Calibration), lane as u64);
        let mut single: Vec<Pcg32> = (0..LANES).map(stream).collect();
        for (lane, rng) in single.iter_mut().enumerate() {
            rng.next_u32();
            streams.state.0[lane] = rng.state();
            streams.increment.0[lane] = (rng.stream() << 1) | 1;
        }
        for _ in 0..1000 {
            let words = streams.draw();
            assert!(single.iter_mut().zip(words.0).all(|(rng, word)| rng.next_u32() == word));
        }
    }

    #[test]
    fn every_lane_has_its_bit() {
        for lane in 0..LANES {
            let mask = gathered(|k| k == lane);
            assert_eq!((mask.count_ones(), lane_of(mask.trailing_zeros())), (1, lane));
        }
        assert_eq!(gathered(|_| true), Mask::MAX);
    }
}
