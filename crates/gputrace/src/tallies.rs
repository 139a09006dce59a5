//! Counters on the device.
//!
//! The device counts events in 32 bits, which no stretch of at most 2³⁰ photons can fill: each photon adds 1 to a counter
//! at most. Scatterings, whose sum has no such bound, are counted in two words with a carry.

use stratiform_gpu::{Buffer, Gpu, GpuError};
use stratiform_transport::{Stretch, Tally};

const BATCHES: usize = Stretch::BATCHES;

/// All counters of a stretch.
pub(crate) struct Tallies {
    thicknesses: usize,
    bins: usize,
    /// Per batch and slab: photons reflected, by order bin; transmitted, by order bin; absorbed.
    pub counts: Buffer,
    /// Per batch and slab: of photons that turned or were absorbed, and that passed.
    pub scatterings: Buffer,
}

impl Tallies {
    pub fn new(gpu: &Gpu, thicknesses: usize, bins: usize) -> Result<Self, GpuError> {
        let rows = BATCHES * thicknesses;
        let counts = gpu.zeroed(4 * rows * (2 * bins + 1))?;
        Ok(Self { thicknesses, bins, counts, scatterings: gpu.zeroed(16 * rows)? })
    }

    /// What each batch has counted; `shares` photons of them were launched. The counters start again from zero.
    pub fn take(
        &self,
        gpu: &Gpu,
        empty: &Tally,
        shares: [u64; BATCHES],
    ) -> Result<Box<[Tally; BATCHES]>, GpuError> {
        let counts: Vec<u32> = taken(gpu, &self.counts)?;
        let scatterings: Vec<[u32; 2]> = taken(gpu, &self.scatterings)?;
        let width = self.bins * 2 + 1;
        Ok(Box::new(std::array::from_fn(|batch| {
            let mut tally = empty.clone();
            tally.launched = shares[batch];
            for slab in 0..self.thicknesses {
                let row = batch * self.thicknesses + slab;
                let (left, absorbed) = counts[row * width..(row + 1) * width].split_at(2 * self.bins);
                let cells = slab * self.bins..(slab + 1) * self.bins;
                copy(&mut tally.reflected[cells.clone()], &left[..self.bins]);
                copy(&mut tally.transmitted[cells], &left[self.bins..]);
                tally.absorbed[slab] = absorbed[0].into();
                (tally.turned[slab], tally.passed[slab]) =
                    (joined(scatterings[2 * row]), joined(scatterings[2 * row + 1]));
            }
            tally
        })))
    }
}

/// What a buffer held; it now holds zeros.
fn taken<T: bytemuck::Pod>(gpu: &Gpu, buffer: &Buffer) -> Result<Vec<T>, GpuError> {
    let bytes = gpu.download(buffer)?;
    gpu.replace(buffer, &vec![0; bytes.len()])?;
    Ok(bytemuck::pod_collect_to_vec(&bytes))
}

fn copy(to: &mut [u64], from: &[u32]) {
    to.iter_mut().zip(from).for_each(|(to, from)| *to = (*from).into());
}

fn joined([low, high]: [u32; 2]) -> u64 {
    u64::from(low) | (u64::from(high) << 32)
}
