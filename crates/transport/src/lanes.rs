//! Thirty-two photons side by side: the arithmetic of one collision and one flight, as loops over arrays.
//!
//! The number of lanes is fixed and each photon draws from its own stream, so the instruction set that the
//! processor offers changes the speed and nothing else. The generator is PCG-XSH-RR 64/32 (O'Neill 2014),
//! continued from the state of [`Pcg32`].

use crate::kernels::{cos_azimuth, exponential};
use rand_pcg::Pcg32;
use stratiform_optics::sampling::SamplingTable;

/// Photons traced side by side.
pub(crate) const LANES: usize = 32;
/// Depth of a lane without a photon: no flight leads out of it.
const PARKED: f64 = 1e300;
const MULTIPLIER: u64 = 6_364_136_223_846_793_005;

type Lane<T> = [T; LANES];

/// The state of every lane.
pub(crate) struct Lanes {
    state: Lane<u64>,
    increment: Lane<u64>,
    mu: Lane<f64>,
    pub depth: Lane<f64>,
    /// The next depth to be counted; infinite for parked lanes.
    pub bottom: Lane<f64>,
    pub order: Lane<u32>,
    pub absorbed: Lane<bool>,
}

impl Lanes {
    /// No photon anywhere.
    pub fn parked() -> Self {
        Self {
            state: [0; LANES],
            increment: [1; LANES],
            mu: [0.0; LANES],
            depth: [PARKED; LANES],
            bottom: [f64::INFINITY; LANES],
            order: [0; LANES],
            absorbed: [false; LANES],
        }
    }

    /// A photon that has made its first flight.
    pub fn place(&mut self, lane: usize, rng: &Pcg32, mu: f64, depth: f64, bottom: f64) {
        self.state[lane] = rng.state();
        self.increment[lane] = (rng.stream() << 1) | 1;
        self.mu[lane] = mu;
        self.depth[lane] = depth;
        self.bottom[lane] = bottom;
        self.order[lane] = 0;
    }

    pub fn park(&mut self, lane: usize) {
        self.depth[lane] = PARKED;
        self.bottom[lane] = f64::INFINITY;
    }

    pub fn is_parked(&self, lane: usize) -> bool {
        self.bottom[lane] == f64::INFINITY
    }

    /// One random word per lane.
    #[inline(always)]
    fn draw(&mut self) -> Lane<u32> {
        let mut words = [0; LANES];
        for (word, (state, increment)) in words.iter_mut().zip(self.state.iter_mut().zip(&self.increment)) {
            *word = output(*state);
            *state = state.wrapping_mul(MULTIPLIER).wrapping_add(*increment);
        }
        words
    }

    #[inline(always)]
    fn absorb(&mut self, absorbs_from: u64) {
        if absorbs_from < 1 << 32 {
            let words = self.draw();
            for (absorbed, word) in self.absorbed.iter_mut().zip(words) {
                *absorbed = u64::from(word) >= absorbs_from;
            }
        }
    }

    #[inline(always)]
    fn scatter(&mut self, table: &SamplingTable) {
        let angles = table.sample_all(&self.draw());
        let azimuths = self.draw();
        for (mu, (v, azimuth)) in self.mu.iter_mut().zip(angles.iter().zip(azimuths)) {
            let sine = ((1.0 - *mu * *mu).max(0.0) * v * (2.0 - v)).sqrt();
            *mu = *mu * (1.0 - v) + sine * cos_azimuth(azimuth);
        }
        self.order.iter_mut().for_each(|order| *order += 1);
    }

    #[inline(always)]
    fn fly(&mut self) {
        let paths = self.draw();
        for (depth, (mu, path)) in self.depth.iter_mut().zip(self.mu.iter().zip(paths)) {
            *depth += mu * exponential(path);
        }
    }

    /// Bit k is set where lane k left its layer or was absorbed.
    #[inline(always)]
    fn events(&self) -> u32 {
        let mut events = 0;
        for k in 0..LANES {
            let left = (self.depth[k] < 0.0) | (self.depth[k] >= self.bottom[k]) | self.absorbed[k];
            events |= u32::from(left) << k;
        }
        events
    }
}

/// One collision and the flight after it in every lane; returns the lanes in which there is something to count.
/// A collision absorbs where its random word is not below `absorbs_from`.
#[multiversion::multiversion(targets(
    "x86_64+avx512f+avx512bw+avx512cd+avx512dq+avx512vl+avx2+fma",
    "x86_64+avx2"
))]
pub(crate) fn collide_and_fly(lanes: &mut Lanes, table: &SamplingTable, absorbs_from: u64) -> u32 {
    lanes.absorb(absorbs_from);
    lanes.scatter(table);
    lanes.fly();
    lanes.events()
}

/// The permutation of PCG-XSH-RR.
#[inline(always)]
fn output(state: u64) -> u32 {
    let shifted = (((state >> 18) ^ state) >> 27) as u32;
    shifted.rotate_right((state >> 59) as u32)
}

#[cfg(test)]
mod tests {
    use super::*;
    use rand::Rng;
    use stratiform_stats::{Purpose, key, photon_stream};

    #[test]
    fn every_lane_continues_its_generator() {
        let mut lanes = Lanes::parked();
        let stream = |lane| photon_stream(key(1, Purpose::Calibration), lane as u64);
        let mut streams: Vec<Pcg32> = (0..LANES).map(stream).collect();
        for (lane, rng) in streams.iter_mut().enumerate() {
            rng.next_u32();
            lanes.place(lane, rng, 1.0, 0.0, 1.0);
        }
        for _ in 0..1000 {
            let words = lanes.draw();
            assert!(streams.iter_mut().zip(words).all(|(rng, word)| rng.next_u32() == word));
        }
    }
}
