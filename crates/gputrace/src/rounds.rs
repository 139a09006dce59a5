//! Which photons wait in the queue, and which of them belong to which batch: as the CPU's rounds have it.

use std::ops::Range;

/// Groups of photons whose scatter among each other gives covariances.
pub(crate) const BATCHES: u64 = 256;
/// Photons of a full round.
const ROUND: u64 = 1 << 20;
/// Photons of the longest queue. With those still in flight from the last one, no 32-bit counter can overflow before it is read:
/// 2³⁰ + 2¹⁷ < 2³².
const LONGEST: u64 = 1 << 30;

/// Photons in a row: full rounds and a last one, which may be shorter.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Queue {
    pub first: u64,
    pub count: u32,
}

impl Queue {
    /// Queues for `photons`, which begin with a round.
    pub fn all(photons: Range<u64>) -> impl Iterator<Item = Self> {
        let end = photons.end;
        let starts = (0..).map(move |k| photons.start + k * LONGEST).take_while(move |first| *first < end);
        starts.map(move |first| Self { first, count: (end - first).min(LONGEST) as u32 })
    }

    pub fn end(&self) -> u64 {
        self.first + u64::from(self.count)
    }

    pub fn last_round(&self) -> u32 {
        ((u64::from(self.count) - 1) / ROUND) as u32
    }

    /// Photons of the last round.
    pub fn last_length(&self) -> u32 {
        self.count - self.last_round() * ROUND as u32
    }

    /// Photons of `batch`.
    pub fn share(&self, batch: u64) -> u64 {
        let share = |length: u64| length * (batch + 1) / BATCHES - length * batch / BATCHES;
        u64::from(self.last_round()) * share(ROUND) + share(self.last_length().into())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn queues_hold_every_photon_once() {
        for photons in [0..2, 0..ROUND, 5..5 + ROUND + 1, 0..3 * LONGEST + 700, 7..7 + 255] {
            let queues: Vec<_> = Queue::all(photons.clone()).collect();
            let mut next = photons.start;
            for queue in &queues {
                assert_eq!(queue.first, next);
                assert!((1..=ROUND).contains(&u64::from(queue.last_length())));
                assert_eq!((0..BATCHES).map(|batch| queue.share(batch)).sum::<u64>(), u64::from(queue.count));
                next += u64::from(queue.count);
            }
            assert_eq!(next, photons.end);
        }
    }
}
