//! The two precisions in which lanes can be traced: the same formulas, each with its own kernels and sampling table.

use crate::TraceMedium;
use crate::kernels;
use crate::single;
use std::ops::{Add, Mul};
use stratiform_optics::sampling::{LinearPieces, SamplingTable};

/// f32 or f64 as the tracer uses them.
pub(crate) trait Real: Copy + PartialOrd + Add<Output = Self> + Mul<Output = Self> {
    type Table;
    const ZERO: Self;
    /// Depth of a lane without a photon: no flight leads out of it.
    const PARKED: Self;
    const INFINITY: Self;

    fn table(medium: &TraceMedium) -> &Self::Table;
    fn rounded(value: f64) -> Self;
    /// -ln ξ of a word.
    fn optical_path(bits: u32) -> Self;
    /// The path of a flight between two collisions, whose azimuth is of the same word.
    fn flight_path(bits: u32) -> Self;
    /// The cosine of a uniform azimuth.
    fn azimuth_cosine(bits: u32) -> Self;
    /// √ξ of a word.
    fn diffuse_cosine(bits: u32) -> Self;
    /// μ after scattering by 1 - cosΘ = `v`.
    fn scattered(self, v: Self, azimuth: Self) -> Self;
    /// Whether a photon at this depth is above the top or not above `bottom`: bits of a sign are above all others. No sum of depths is -0.
    fn is_out(self, bottom: Self) -> bool;
    /// 1 - cosΘ of every word.
    fn sample<const N: usize>(table: &Self::Table, words: &[u32; N]) -> [Self; N];
}

impl Real for f32 {
    type Table = LinearPieces;
    const ZERO: Self = 0.0;
    const PARKED: Self = 1e30;
    const INFINITY: Self = f32::INFINITY;

    fn table(medium: &TraceMedium) -> &LinearPieces {
        medium.pieces()
    }

    #[inline(always)]
    fn rounded(value: f64) -> Self {
        value as f32
    }

    #[inline(always)]
    fn optical_path(bits: u32) -> Self {
        single::optical_path(bits)
    }

    #[inline(always)]
    fn flight_path(bits: u32) -> Self {
        single::flight_path(bits)
    }

    #[inline(always)]
    fn azimuth_cosine(bits: u32) -> Self {
        single::azimuth_cosine(bits)
    }

    #[inline(always)]
    fn diffuse_cosine(bits: u32) -> Self {
        single::diffuse_cosine(bits)
    }

    #[inline(always)]
    fn scattered(self, v: Self, azimuth: Self) -> Self {
        single::scattered(self, v, azimuth)
    }

    #[inline(always)]
    fn is_out(self, bottom: Self) -> bool {
        self.to_bits() >= bottom.to_bits()
    }

    #[inline(always)]
    fn sample<const N: usize>(table: &LinearPieces, words: &[u32; N]) -> [Self; N] {
        table.sample_all(words)
    }
}

impl Real for f64 {
    type Table = SamplingTable;
    const ZERO: Self = 0.0;
    const PARKED: Self = 1e300;
    const INFINITY: Self = f64::INFINITY;

    fn table(medium: &TraceMedium) -> &SamplingTable {
        medium.table()
    }

    #[inline(always)]
    fn rounded(value: f64) -> Self {
        value
    }

    #[inline(always)]
    fn optical_path(bits: u32) -> Self {
        kernels::optical_path(bits)
    }

    #[inline(always)]
    fn flight_path(bits: u32) -> Self {
        kernels::flight_path(bits)
    }

    #[inline(always)]
    fn azimuth_cosine(bits: u32) -> Self {
        kernels::azimuth_cosine(bits)
    }

    #[inline(always)]
    fn diffuse_cosine(bits: u32) -> Self {
        kernels::uniform(bits).sqrt()
    }

    #[inline(always)]
    fn scattered(self, v: Self, azimuth: Self) -> Self {
        let sine = ((1.0 - self * self).max(0.0) * v * (2.0 - v)).sqrt();
        self * (1.0 - v) + sine * azimuth
    }

    #[inline(always)]
    fn is_out(self, bottom: Self) -> bool {
        self.to_bits() >= bottom.to_bits()
    }

    #[inline(always)]
    fn sample<const N: usize>(table: &SamplingTable, words: &[u32; N]) -> [Self; N] {
        table.sample_all(words)
    }
}
