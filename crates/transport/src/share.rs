//! One of several equal shares of a trace's photons: K/N, K from 1 to N.
//!
//! Share K of P photons is the range from ⌊P(K-1)/N⌋ up to ⌊PK/N⌋: the shares cover all photons, none twice.

use crate::TransportError;
use std::fmt;
use std::ops::Range;
use std::str::FromStr;

/// The `number`th of `of` shares, counted from 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Share {
    number: u64,
    of: u64,
}

impl Share {
    /// All photons.
    pub const WHOLE: Self = Self { number: 1, of: 1 };

    /// Share `number` of `of`.
    ///
    /// # Errors
    /// [`TransportError::Share`] unless 1 ≤ `number` ≤ `of` ≤ 2³².
    pub fn new(number: u64, of: u64) -> Result<Self, TransportError> {
        if number >= 1 && number <= of && of <= 1 << 32 {
            Ok(Self { number, of })
        } else {
            Err(TransportError::Share { text: format!("{number}/{of}") })
        }
    }

    /// K, from 1.
    pub fn number(self) -> u64 {
        self.number
    }

    /// N.
    pub fn of(self) -> u64 {
        self.of
    }

    /// Its photons out of `max`; none if there are fewer photons than shares.
    pub fn photons(self, max: u64) -> Range<u64> {
        let bound = |number: u64| (u128::from(max) * u128::from(number) / u128::from(self.of)) as u64;
        bound(self.number - 1)..bound(self.number)
    }
}

impl fmt::Display for Share {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}/{}", self.number, self.of)
    }
}

impl FromStr for Share {
    type Err = TransportError;

    fn from_str(text: &str) -> Result<Self, TransportError> {
        let numbers = text.split_once('/').and_then(|(k, n)| Some((k.parse().ok()?, n.parse().ok()?)));
        let refuse = || TransportError::Share { text: text.to_owned() };
        let (number, of) = numbers.ok_or_else(refuse)?;
        Self::new(number, of).map_err(|_| refuse())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shares_cover_all_photons_once() {
        for max in [2, 7, 1_000_003, 1 << 48] {
            for of in [1, 2, 3, 7, 1 << 32] {
                let share = |number| Share::new(number, of).unwrap().photons(max);
                assert_eq!((share(1).start, share(of).end), (0, max));
                for number in 2..=of.min(50) {
                    assert_eq!(share(number - 1).end, share(number).start);
                }
            }
        }
    }

    #[test]
    fn what_is_no_share_is_refused_by_name() {
        for text in ["0/4", "5/4", "0/0", "1/0", "1", "a/b", "-1/4", "1/4294967297", "1/4/2", ""] {
            let error = text.parse::<Share>().unwrap_err().to_string();
            assert!(error.contains(&format!("`{text}`")) && error.contains("1 <= K <= N"), "{error}");
        }
        assert_eq!("3/4".parse::<Share>().unwrap().to_string(), "3/4");
    }
}
