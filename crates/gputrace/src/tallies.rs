//! Counters on the device, and their sums on the host.
//!
//! The device counts events in 32 bits, of which one queue cannot fill any; scatterings, whose sum over photons has no such bound, in
//! two words with a carry. Each [`flush`](Tallies::flush) adds them to 64-bit sums and starts them from zero.

use crate::rounds::BATCHES;
use stratiform_gpu::{Buffer, Gpu, GpuError};

/// Counters in one buffer.
struct Column {
    buffer: Buffer,
    /// Words of one counter.
    words: usize,
    sums: Vec<u64>,
}

impl Column {
    fn new(gpu: &Gpu, counters: usize, words: usize) -> Result<Self, GpuError> {
        Ok(Self { buffer: gpu.zeroed(4 * words * counters)?, words, sums: vec![0; counters] })
    }

    fn flush(&mut self, gpu: &Gpu) -> Result<(), GpuError> {
        let bytes = gpu.download(&self.buffer)?;
        for (sum, counter) in self.sums.iter_mut().zip(bytes.chunks_exact(4 * self.words)) {
            *sum += counter.iter().rev().fold(0_u64, |value, byte| (value << 8) | u64::from(*byte));
        }
        gpu.replace(&self.buffer, &vec![0; bytes.len()])
    }
}

/// All counters of a trace.
pub(crate) struct Tallies {
    thicknesses: usize,
    bins: usize,
    /// Per batch and slab: photons reflected, by order bin; transmitted, by order bin; absorbed.
    counts: Column,
    /// Per batch and slab: of photons that turned or were absorbed, and that passed.
    scatterings: Column,
}

impl Tallies {
    pub fn new(gpu: &Gpu, thicknesses: usize, bins: usize) -> Result<Self, GpuError> {
        let rows = BATCHES as usize * thicknesses;
        let column = |counters, words| Column::new(gpu, counters, words);
        Ok(Self {
            thicknesses,
            bins,
            counts: column(rows * (2 * bins + 1), 1)?,
            scatterings: column(2 * rows, 2)?,
        })
    }

    /// In the order of their bindings.
    pub fn buffers(&self) -> [&Buffer; 2] {
        [&self.counts.buffer, &self.scatterings.buffer]
    }

    pub fn flush(&mut self, gpu: &Gpu) -> Result<(), GpuError> {
        self.counts.flush(gpu)?;
        self.scatterings.flush(gpu)
    }

    /// What `launched` photons of one batch have come to.
    pub fn batch(&self, batch: usize, launched: u64) -> BatchCounts {
        let (bins, slabs) = (self.bins, batch * self.thicknesses..(batch + 1) * self.thicknesses);
        let counts = |from: usize, until: usize| {
            let row = |slab: usize| slab * (2 * bins + 1);
            let cells = slabs.clone().flat_map(|slab| &self.counts.sums[row(slab) + from..row(slab) + until]);
            cells.copied().collect()
        };
        let scatterings = |which: usize| slabs.clone().map(|slab| self.scatterings.sums[2 * slab + which]).collect();
        BatchCounts {
            launched,
            reflected: counts(0, bins),
            transmitted: counts(bins, 2 * bins),
            absorbed: counts(2 * bins, 2 * bins + 1),
            turned: scatterings(0),
            passed: scatterings(1),
        }
    }
}

/// Counts of one batch: per slab in ascending order and, where orders are told apart, per order bin within.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct BatchCounts {
    /// Histories.
    pub launched: u64,
    /// Left through the top before they passed this slab, and not before they passed the last.
    pub reflected: Vec<u64>,
    /// Passed this slab.
    pub transmitted: Vec<u64>,
    /// Absorbed, as `reflected`.
    pub absorbed: Vec<u64>,
    /// Scatterings of the photons in `reflected` and `absorbed`.
    pub turned: Vec<u64>,
    /// Scatterings of the photons in `transmitted`.
    pub passed: Vec<u64>,
}
