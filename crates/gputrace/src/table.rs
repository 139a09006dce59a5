//! The phase function's inversion table as the device reads it.

use stratiform_optics::sampling::SamplingTable;

/// Intervals of equal probability: start, slope, curve of a parabola, and nothing.
pub(crate) fn intervals(table: &SamplingTable) -> Vec<[f32; 4]> {
    let interval = |index: u32| {
        let at = |offset: u32| table.sample((index << 20) + offset);
        let (start, middle, end) = (at(0), at(1 << 19), at((1 << 20) - 1));
        let curve = 2.0 * (start + end) - 4.0 * middle;
        [start as f32, (end - start - curve) as f32, curve as f32, 0.0]
    };
    (0..4096).map(interval).collect()
}
