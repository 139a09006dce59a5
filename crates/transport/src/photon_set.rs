//! Which photons of a trace: a set of their numbers as ranges.
//!
//! Ranges ascend and do not touch, so that equal sets are equal. A trace in progress has as many as there are
//! unfinished cells, however many photons there are.

use serde::{Deserialize, Serialize};
use std::ops::Range;

/// Ranges of photon numbers, ascending, apart from each other.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub(crate) struct PhotonSet(Vec<Range<u64>>);

impl PhotonSet {
    /// Whether the ranges are what this type promises: false for damaged ones.
    pub fn is_sound(&self) -> bool {
        let filled = self.0.iter().all(|range| range.start < range.end);
        filled && self.0.windows(2).all(|pair| pair[0].end < pair[1].start)
    }

    /// The ranges.
    pub fn ranges(&self) -> &[Range<u64>] {
        &self.0
    }

    /// Number of photons.
    pub fn len(&self) -> u64 {
        self.0.iter().map(|range| range.end - range.start).sum()
    }

    /// The first photons that `range` and the set share.
    pub fn common(&self, range: &Range<u64>) -> Option<Range<u64>> {
        let at = self.0.partition_point(|held| held.end <= range.start);
        let common = self.0.get(at)?.start.max(range.start)..self.0[at].end.min(range.end);
        (common.start < common.end).then_some(common)
    }

    /// Adds `range`, of which the set may hold nothing: see [`common`](Self::common).
    pub fn insert(&mut self, range: Range<u64>) {
        if range.is_empty() {
            return;
        }
        let from = self.0.partition_point(|held| held.end < range.start);
        let to = self.0.partition_point(|held| held.start <= range.end);
        let touching = &self.0[from..to];
        let start = touching.first().map_or(range.start, |held| held.start.min(range.start));
        let end = touching.last().map_or(range.end, |held| held.end.max(range.end));
        self.0.splice(from..to, std::iter::once(start..end));
    }

    /// What of `within` the set lacks.
    pub fn gaps(&self, within: &Range<u64>) -> Vec<Range<u64>> {
        let first = self.0.partition_point(|held| held.end <= within.start);
        let held = self.0[first..].iter().take_while(|held| held.start < within.end);
        let mut gaps = Vec::new();
        let mut from = within.start;
        for range in held {
            gaps.push(from..range.start.max(from));
            from = range.end;
        }
        gaps.push(from..within.end.max(from));
        gaps.retain(|gap| !gap.is_empty());
        gaps
    }

    /// The first photon of `within` that the set lacks.
    pub fn first_gap(&self, within: &Range<u64>) -> Option<u64> {
        let at = self.0.partition_point(|held| held.end <= within.start);
        let held = self.0.get(at).filter(|held| held.start <= within.start);
        let first = held.map_or(within.start, |held| held.end);
        (first < within.end).then_some(first)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Against a plain list of members.
    #[test]
    fn a_set_is_what_was_put_in() {
        let mut set = PhotonSet::default();
        let mut members = [false; 40];
        for range in [10..15, 0..3, 20..30, 3..10, 5..5, 31..40, 15..16] {
            assert_eq!(set.common(&range), None);
            range.clone().for_each(|photon| members[photon as usize] = true);
            set.insert(range);
            assert!(set.is_sound());
            assert_eq!(set.len(), members.iter().filter(|member| **member).count() as u64);
            for start in 0..40 {
                for end in start..40 {
                    let missing: Vec<u64> =
                        (start..end).filter(|photon| !members[*photon as usize]).collect();
                    assert_eq!(set.gaps(&(start..end)).into_iter().flatten().collect::<Vec<_>>(), missing);
                    assert_eq!(set.first_gap(&(start..end)), missing.first().copied());
                    let held = (start..end).find(|photon| members[*photon as usize]);
                    assert_eq!(set.common(&(start..end)).map(|common| common.start), held);
                }
            }
        }
        assert_eq!(set.ranges(), [0..16, 20..30, 31..40]);
    }

    #[test]
    fn damaged_sets_are_seen() {
        let backwards = Range { start: 2, end: 1 };
        for ranges in [vec![3..3, 5..6], vec![0..5, 5..6], vec![4..6, 0..2], vec![backwards, 5..6]] {
            assert!(!PhotonSet(ranges).is_sound());
        }
    }
}
