//! Sixty-four photons side by side: the arithmetic of one collision and one flight, as loops over arrays.
//!
//! The number of lanes is fixed and each photon draws from its own stream, so the instruction set that the
//! processor offers changes the speed and nothing else. The generator is PCG-XSH-RR 64/32 (O'Neill 2014). Loops are
//! long enough for the compiler to keep them loops, which it then turns into vectors of any width.

use crate::real::Real;

/// Photons of one block.
pub(crate) const LANES: usize = 64;
const MULTIPLIER: u64 = 6_364_136_223_846_793_005;

type Lane<T> = [T; LANES];

/// What a lane holds: `batch` says whose tally counts it, `bottom` is the next depth at which something is counted, `slab` its index, and `born` the step
/// at which the photon had no scattering yet.
pub(crate) struct Photon<R> {
    pub state: u64,
    pub increment: u64,
    pub mu: R,
    pub depth: R,
    pub bottom: R,
    pub batch: u32,
    pub slab: u32,
    pub born: u32,
}

/// Sixty-four photons, field by field.
#[repr(C, align(64))]
#[derive(Clone)]
pub(crate) struct Block<R> {
    pub streams: Streams,
    pub mu: Lane<R>,
    pub depth: Lane<R>,
    pub bottom: Lane<R>,
    pub batch: Lane<u32>,
    pub slab: Lane<u32>,
    pub born: Lane<u32>,
}

/// What a step brought about, one bit per lane.
#[derive(Clone, Copy, Default)]
pub(crate) struct Events {
    /// There is something to count: the photon passed its bottom or the top, or was absorbed.
    pub any: u64,
    pub absorbed: u64,
}

impl<R: Real> Block<R> {
    /// No photon anywhere.
    pub fn parked() -> Self {
        Self {
            streams: Streams::default(),
            mu: [R::ZERO; LANES],
            depth: [R::PARKED; LANES],
            bottom: [R::INFINITY; LANES],
            batch: [0; LANES],
            slab: [0; LANES],
            born: [0; LANES],
        }
    }

    #[inline(always)]
    pub fn place(&mut self, lane: usize, photon: Photon<R>) {
        self.streams.state[lane] = photon.state;
        self.streams.increment[lane] = photon.increment;
        self.mu[lane] = photon.mu;
        self.depth[lane] = photon.depth;
        self.bottom[lane] = photon.bottom;
        self.batch[lane] = photon.batch;
        self.slab[lane] = photon.slab;
        self.born[lane] = photon.born;
    }

    pub fn photon(&self, lane: usize) -> Photon<R> {
        Photon {
            state: self.streams.state[lane],
            increment: self.streams.increment[lane],
            mu: self.mu[lane],
            depth: self.depth[lane],
            bottom: self.bottom[lane],
            batch: self.batch[lane],
            slab: self.slab[lane],
            born: self.born[lane],
        }
    }

    pub fn park(&mut self, lane: usize) {
        self.depth[lane] = R::PARKED;
        self.bottom[lane] = R::INFINITY;
    }

    /// One collision and the flight after it in every lane. A collision absorbs where its random word is not below
    /// `absorbs_from`.
    #[inline(always)]
    pub fn collide_and_fly(&mut self, table: &R::Table, absorbs_from: u64) -> Events {
        let absorbed = self.absorb(absorbs_from);
        let angles = R::sample(table, &self.streams.draw());
        let azimuths = self.streams.draw();
        let paths = self.streams.draw();
        for k in 0..LANES {
            let mu = self.mu[k].scattered(angles[k], R::azimuth_cosine(azimuths[k]));
            self.mu[k] = mu;
            self.depth[k] = self.depth[k] + mu * R::optical_path(paths[k]);
        }
        Events { any: absorbed | self.left(), absorbed }
    }

    #[inline(always)]
    fn absorb(&mut self, absorbs_from: u64) -> u64 {
        if absorbs_from >= 1 << 32 {
            return 0;
        }
        let words = self.streams.draw();
        let mut absorbed = [0; LANES];
        for k in 0..LANES {
            absorbed[k] = u8::from(words[k] >= absorbs_from as u32);
        }
        gathered(&absorbed)
    }

    /// The lanes whose photon is above the top or below its bottom.
    #[inline(always)]
    fn left(&self) -> u64 {
        let mut left = [0; LANES];
        for k in 0..LANES {
            left[k] = u8::from((self.depth[k] < R::ZERO) | (self.depth[k] >= self.bottom[k]));
        }
        gathered(&left)
    }
}

/// One generator per lane.
#[repr(C, align(64))]
#[derive(Clone)]
pub(crate) struct Streams {
    pub state: Lane<u64>,
    /// Odd.
    pub increment: Lane<u64>,
}

impl Default for Streams {
    fn default() -> Self {
        Self { state: [0; LANES], increment: [1; LANES] }
    }
}

impl Streams {
    /// One random word per lane.
    #[inline(always)]
    pub fn draw(&mut self) -> Lane<u32> {
        let halves: &Lane<[u32; 2]> = bytemuck::cast_ref(&self.state);
        let mut words = [0; LANES];
        for k in 0..LANES {
            words[k] = output(halves[k]);
        }
        self.advance();
        words
    }

    #[inline(always)]
    pub fn advance(&mut self) {
        for k in 0..LANES {
            self.state[k] = self.state[k].wrapping_mul(MULTIPLIER).wrapping_add(self.increment[k]);
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

/// Bit k is byte k, each of which is 0 or 1.
#[inline(always)]
fn gathered(bytes: &Lane<u8>) -> u64 {
    let mut bits = 0;
    for (k, eight) in bytes.as_chunks::<8>().0.iter().enumerate() {
        let spread = u64::from_le_bytes(*eight).wrapping_mul(0x0102_0408_1020_4080);
        bits |= (spread >> 56) << (8 * k);
    }
    bits
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
            streams.state[lane] = rng.state();
            streams.increment[lane] = (rng.stream() << 1) | 1;
        }
        for _ in 0..1000 {
            let words = streams.draw();
            assert!(single.iter_mut().zip(words).all(|(rng, word)| rng.next_u32() == word));
        }
    }

    #[test]
    fn bytes_become_bits() {
        for lane in 0..LANES {
            let mut bytes = [0; LANES];
            bytes[lane] = 1;
            assert_eq!(gathered(&bytes), 1 << lane);
        }
        assert_eq!(gathered(&[1; LANES]), u64::MAX);
    }
}
