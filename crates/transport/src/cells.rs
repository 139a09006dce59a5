//! Rounds of photons and their cells.
//!
//! Photons are numbered 0, 1, 2 …. A round takes the next of them and gives each of 256 batches an equal share, in
//! order: a cell is what one batch gets of one round. Batches exist for the scatter among them, which gives
//! covariances; where photons are fixed beforehand a round has 2²⁰, the last one what is left.

use std::ops::Range;

/// Groups of photons whose scatter among each other gives covariances.
pub(crate) const BATCHES: usize = 256;
/// Photons of the longest round.
pub(crate) const LONGEST: u64 = 1 << 20;

/// Photons of one cell, or of a part of one.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Cell {
    /// The batch that counts them.
    pub(crate) batch: usize,
    /// Their numbers.
    pub(crate) photons: Range<u64>,
}

impl Cell {
    /// The photons' numbers.
    pub fn photons(&self) -> Range<u64> {
        self.photons.clone()
    }
}

/// The round of a trace of `max` photons in which `photon` is.
pub(crate) fn fixed_round(photon: u64, max: u64) -> Range<u64> {
    let start = photon / LONGEST * LONGEST;
    start..max.min(start + LONGEST)
}

/// The cells of `round`, cut to `gap` and into pieces of at most `longest` photons.
pub(crate) fn cells(round: &Range<u64>, gap: &Range<u64>, longest: u64) -> Vec<Cell> {
    let count = round.end - round.start;
    let bound = |batch: usize| round.start + count * batch as u64 / BATCHES as u64;
    let mut cells = Vec::new();
    for batch in 0..BATCHES {
        let (mut start, end) = (bound(batch).max(gap.start), bound(batch + 1).min(gap.end));
        while start < end {
            let photons = start..end.min(start.saturating_add(longest));
            start = photons.end;
            cells.push(Cell { batch, photons });
        }
    }
    cells
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cells_of_gaps_are_those_of_the_round() {
        for count in [1, 2, 255, 256, 257, 70_001, LONGEST] {
            let round = 1000..1000 + count;
            let whole = cells(&round, &round, u64::MAX);
            let batch_of = |photon| {
                let cell = whole.iter().find(|cell| cell.photons.contains(&photon));
                cell.map(|cell| cell.batch)
            };
            let cut = 1000 + count / 3;
            for gap in [1000..cut, cut..1000 + count] {
                let mut next = gap.start;
                for cell in cells(&round, &gap, 1 + count / 700) {
                    assert_eq!(cell.photons.start, next);
                    assert_eq!(Some(cell.batch), batch_of(next));
                    assert_eq!(Some(cell.batch), batch_of(cell.photons.end - 1));
                    next = cell.photons.end;
                }
                assert_eq!(next, gap.end);
            }
        }
    }

    #[test]
    fn rounds_cover_all_photons() {
        let max = 3 * LONGEST + 5;
        assert_eq!(fixed_round(0, max), 0..LONGEST);
        assert_eq!(fixed_round(LONGEST, max), LONGEST..2 * LONGEST);
        assert_eq!(fixed_round(max - 1, max), 3 * LONGEST..max);
    }
}
