//! Random numbers that belong to a place: no state, no order, the same on every machine.

/// A number from 0 to 1 (1 excluded) of the lattice point (x, y) of `lattice`, `which`-th of several.
pub fn share(lattice: u64, x: usize, y: usize, which: u64) -> f64 {
    let mut word = finish(lattice.wrapping_mul(4).wrapping_add(which));
    word = finish(word ^ x as u64);
    word = finish(word ^ y as u64);
    (word >> 11) as f64 / 9_007_199_254_740_992.0
}

/// One seed from two.
pub fn seed(seed: u32, stream: u32) -> u64 {
    finish(u64::from(seed) << 32 | u64::from(stream))
}

/// The finaliser of SplitMix64 (Steele, Lea & Flood 2014) after one step of its counter.
fn finish(word: u64) -> u64 {
    let word = word.wrapping_add(0x9e37_79b9_7f4a_7c15);
    let word = (word ^ (word >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let word = (word ^ (word >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    word ^ (word >> 31)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// First outputs of SplitMix64 from state 0, as its authors' code gives them.
    #[test]
    fn the_finaliser_is_splitmix() {
        assert_eq!(finish(0), 0xe220_a839_7b1d_cdaf);
        assert_eq!(finish(0x9e37_79b9_7f4a_7c15), 0x6e78_9e6a_a1b9_65f4);
    }
}
