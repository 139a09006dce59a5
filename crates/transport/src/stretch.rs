//! Photons in a row over any number of rounds, for an engine that takes many at once.

use crate::cells::{BATCHES, LONGEST, cells};
use std::ops::Range;

/// Photons that follow each other. All rounds that they are in are [full](Self::ROUND), except the last one, which may be
/// shorter.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Stretch {
    pub(crate) photons: Range<u64>,
    /// Where the round of the first photon starts.
    pub(crate) first_round: u64,
    pub(crate) last_round: Range<u64>,
}

impl Stretch {
    /// Photons of a full round.
    pub const ROUND: u64 = LONGEST;
    /// Each round is cut into so many batches: photon k of a round of n is in batch ⌊(256 (k+1) - 1)/n⌋.
    pub const BATCHES: usize = BATCHES;

    /// The photons' numbers.
    pub fn photons(&self) -> Range<u64> {
        self.photons.clone()
    }

    /// The number of the first photon of the first round; this stretch may begin later.
    pub fn first_round(&self) -> u64 {
        self.first_round
    }

    /// The last round; this stretch may end earlier.
    pub fn last_round(&self) -> Range<u64> {
        self.last_round.clone()
    }

    /// Photons of each batch.
    pub fn shares(&self) -> [u64; BATCHES] {
        let mut shares = [0; BATCHES];
        let mut round = self.first_round..self.first_round + LONGEST;
        while round.start < self.photons.end {
            if round.start == self.last_round.start {
                round = self.last_round.clone();
            }
            let part = self.photons.start.max(round.start)..self.photons.end.min(round.end);
            for cell in cells(&round, &part, u64::MAX) {
                shares[cell.batch] += cell.photons.end - cell.photons.start;
            }
            round = round.end..round.end + LONGEST;
        }
        shares
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The formula of the batch, photon by photon.
    #[test]
    fn shares_are_those_of_the_formula() {
        let first_round = 3 * LONGEST;
        for (length, from, to) in
            [(700, 5, 2 * LONGEST + 650), (LONGEST, 0, 3 * LONGEST), (2, LONGEST, 2 * LONGEST + 1)]
        {
            let last = first_round + 2 * LONGEST;
            let photons = first_round + from..first_round + to;
            let stretch = Stretch { photons: photons.clone(), first_round, last_round: last..last + length };
            let mut shares = [0; BATCHES];
            for photon in photons {
                let (k, n) =
                    if photon < last { (photon % LONGEST, LONGEST) } else { (photon - last, length) };
                shares[((256 * (k + 1) - 1) / n) as usize] += 1;
            }
            assert_eq!(stretch.shares(), shares);
        }
    }
}
