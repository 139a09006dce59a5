//! One photon at a time in double precision: the same walk for every estimator, so that their seconds compare.

use rand::Rng;
use rand_pcg::Pcg32;
use std::f64::consts::PI;
use stratiform_optics::sampling::SamplingTable;

const WORD: f64 = 1.0 / 4_294_967_296.0;

/// ξ of a random word, inside (0, 1).
pub fn xi(word: u32) -> f64 {
    (f64::from(word) + 0.5) * WORD
}

/// A photon's random words: those given first, then those of its stream.
pub struct Words<'a> {
    stream: Pcg32,
    first: &'a [u32],
}

impl<'a> Words<'a> {
    pub fn new(stream: Pcg32, first: &'a [u32]) -> Self {
        Self { stream, first }
    }

    #[inline(always)]
    pub fn next(&mut self) -> u32 {
        match self.first.split_first() {
            Some((word, rest)) => {
                self.first = rest;
                *word
            }
            None => self.stream.next_u32(),
        }
    }
}

/// Depth, direction cosine and number of scatterings on the way.
pub struct Photon {
    pub depth: f64,
    pub mu: f64,
    pub order: usize,
}

impl Photon {
    pub fn new(mu: f64) -> Self {
        Self { depth: 0.0, mu, order: 0 }
    }

    /// To the next collision: one word.
    #[inline(always)]
    pub fn fly(&mut self, words: &mut Words<'_>) {
        self.depth += self.mu * -libm::log(xi(words.next()));
    }

    /// μ' = μ cosΘ + √(1-μ²) sinΘ cosψ: two words.
    #[inline(always)]
    pub fn scatter(&mut self, table: &SamplingTable, words: &mut Words<'_>) {
        let v = table.sample(words.next());
        let sine = ((1.0 - self.mu * self.mu).max(0.0) * v * (2.0 - v)).sqrt();
        self.mu = (self.mu * (1.0 - v) + sine * libm::cos(PI * xi(words.next()))).clamp(-1.0, 1.0);
        self.order += 1;
    }
}
