//! What the photons of a [`Flock`](crate::flock::Flock) did, counted for several tallies side by side.
//!
//! Each slab of each tally has one row, and one more row per tally stands for what is below all slabs.
//! Columns of a row: photons that turned, by order bin; that passed, by order bin; that were absorbed; scatterings
//! of those that turned or were absorbed; of those that passed. First flights are counted by the row where they end.

use crate::tally::Tally;

/// See the module's first lines.
pub(crate) struct Ledger {
    bins: usize,
    columns: usize,
    counts: Vec<u64>,
    entered: Vec<u64>,
}

impl Ledger {
    /// Of `rows` rows, with the order bins of `tally`.
    pub fn new(tally: &Tally, rows: usize) -> Self {
        let bins = tally.bins;
        let columns = 2 * bins + 3;
        Self { bins, columns, counts: vec![0; rows * columns], entered: vec![0; rows] }
    }

    /// A photon's first flight ends in `row`, after all slabs above it.
    #[inline(always)]
    pub fn enter(&mut self, row: usize) {
        self.entered[row] += 1;
    }

    /// A photon leaves through the top or the bottom of a slab after `order` scatterings; no branch between them.
    #[inline(always)]
    pub fn leave(&mut self, up: bool, row: usize, order: u64) {
        let (from, side) = (row * self.columns, usize::from(!up));
        self.counts[from + side * self.bins + order.min(self.bins as u64 - 1) as usize] += 1;
        self.counts[from + 2 * self.bins + 1 + side] += order;
    }

    /// A photon is absorbed in a slab after `order` scatterings.
    #[inline(always)]
    pub fn absorb(&mut self, row: usize, order: u64) {
        let absorbed = row * self.columns + 2 * self.bins;
        self.counts[absorbed] += 1;
        self.counts[absorbed + 1] += order;
    }

    /// Adds everything to the tallies.
    pub fn close(&self, tallies: &mut [Tally]) {
        let rows = self.entered.len() / tallies.len();
        let shares = self.counts.chunks_exact(rows * self.columns).zip(self.entered.chunks_exact(rows));
        for (tally, (counts, entered)) in tallies.iter_mut().zip(shares) {
            let mut unscattered = 0;
            for (slab, row) in counts.chunks_exact(self.columns).enumerate().take(rows - 1).rev() {
                unscattered += entered[slab + 1];
                tally.add_slab(slab, row, unscattered);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A photon in a slab of τ = 10⁶ may be scattered that often.
    #[test]
    fn an_order_beyond_32_bits_is_counted_whole() {
        let order = 10_000_000_000;
        let mut tally = Tally::new(1, 4, true);
        let mut ledger = Ledger::new(&tally, 2);
        ledger.leave(true, 0, order);
        ledger.leave(false, 0, order);
        ledger.absorb(0, order);
        ledger.close(std::slice::from_mut(&mut tally));
        assert_eq!((tally.reflected[3], tally.transmitted[3], tally.absorbed[0]), (1, 1, 1));
        assert_eq!((tally.turned[0], tally.passed[0]), (2 * order, order));
    }
}
