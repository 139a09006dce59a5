//! Numbers as people type them.

use std::time::Duration;
use stratiform_transport::Share;

/// A count: `100000`, `2e6`. Whole, from 1 to 2^53.
///
/// # Errors
/// A message naming the value and the range.
pub fn count(text: &str) -> Result<u64, String> {
    let refuse = || format!("`{text}` is not a whole number in [1, 2^53]");
    let value: f64 = text.parse().map_err(|_| refuse())?;
    if value.fract() == 0.0 && (1.0..=9_007_199_254_740_992.0).contains(&value) {
        Ok(value as u64)
    } else {
        Err(refuse())
    }
}

/// A seed: any whole number that fits 64 bits, or one with an exponent such as `1e3`.
///
/// # Errors
/// A message naming the value and the range.
pub fn seed(text: &str) -> Result<u64, String> {
    let whole = text.parse().ok().or_else(|| count(text).ok());
    whole.ok_or_else(|| format!("`{text}` is not a whole number in [0, 2^64 - 1]"))
}

/// A finite number.
///
/// # Errors
/// A message naming the value.
pub fn finite(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(value) if value.is_finite() => Ok(value),
        _ => Err(format!("`{text}` is not a finite number")),
    }
}

/// Two numbers with a comma between, e.g. the index of refraction `1.33,1e-5`.
///
/// # Errors
/// A message naming the value.
pub fn pair(text: &str) -> Result<[f64; 2], String> {
    let (a, b) =
        text.split_once(',').ok_or_else(|| format!("`{text}` is not two numbers with a comma between"))?;
    Ok([finite(a)?, finite(b)?])
}

/// A share K/N.
///
/// # Errors
/// A message naming the text and the range.
pub fn share(text: &str) -> Result<Share, String> {
    text.parse().map_err(|error: stratiform_transport::TransportError| error.to_string())
}

/// A length of time, from 0 to a million seconds.
///
/// # Errors
/// A message naming the value and the range.
pub fn seconds(text: &str) -> Result<Duration, String> {
    match text.parse::<f64>() {
        Ok(value) if (0.0..=1e6).contains(&value) => Ok(Duration::from_secs_f64(value)),
        _ => Err(format!("`{text}` is not a number of seconds in [0, 1000000]")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn counts_may_be_written_with_an_exponent() {
        assert_eq!(count("2e6"), Ok(2_000_000));
        assert_eq!(count("7"), Ok(7));
        for text in ["0", "-1", "1.5", "nan", "inf", "1e300", "", "ten"] {
            assert!(count(text).is_err(), "{text}");
        }
    }

    #[test]
    fn seeds_have_all_64_bits() {
        assert_eq!(seed("0"), Ok(0));
        assert_eq!(seed("1e3"), Ok(1000));
        assert_eq!(seed("18446744073709551615"), Ok(u64::MAX));
        assert!(seed("-1").is_err() && seed("1.5").is_err());
    }

    #[test]
    fn pairs_and_finite_numbers() {
        assert_eq!(pair("1.33,1e-5"), Ok([1.33, 1e-5]));
        assert!(pair("1.33").is_err() && pair("1,nan").is_err() && finite("inf").is_err());
    }
}
