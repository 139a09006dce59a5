//! Numbers as text.

/// Value ± error, to two digits of the error and at least four and at most nine decimals of the value.
pub fn with_error(value: f64, std_error: Option<f64>) -> String {
    match std_error {
        Some(error) if error > 0.0 && error < 5e-10 => signed(&format!("{value:.9} ± <1e-9")),
        Some(error) if error > 0.0 => {
            let decimals = (1.0 - libm::floor(libm::log10(error))).clamp(4.0, 9.0) as usize;
            signed(&format!("{value:.decimals$} ± {error:.decimals$}"))
        }
        _ => fixed(value, 4),
    }
}

/// A fixed number of decimals.
pub fn fixed(value: f64, decimals: usize) -> String {
    signed(&format!("{value:.decimals$}"))
}

/// A magnitude that may be small, to two digits.
pub fn small(value: f64) -> String {
    if value == 0.0 {
        return "0".to_owned();
    }
    let exponent = libm::floor(libm::log10(value.abs()));
    if exponent < -4.0 {
        return signed(&format!("{value:.1e}"));
    }
    let decimals = (1.0 - exponent).clamp(0.0, 6.0) as usize;
    signed(&format!("{value:.decimals$}"))
}

/// A share in percent, one decimal.
pub fn percent(share: f64) -> String {
    signed(&format!("{:.1} %", 100.0 * share))
}

/// With a real minus sign, and none before zero.
fn signed(text: &str) -> String {
    match text.strip_prefix('-') {
        Some(rest) if rest.chars().all(|c| matches!(c, '0' | '.')) => rest.to_owned(),
        _ => text.replace('-', "−"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn errors_set_the_digits() {
        assert_eq!(with_error(0.83891, Some(0.00123)), "0.8389 ± 0.0012");
        assert_eq!(with_error(0.9961234, Some(2.4e-6)), "0.9961234 ± 0.0000024");
        assert_eq!(with_error(0.25, Some(2e-16)), "0.250000000 ± <1e−9");
        assert_eq!(with_error(-0.5, None), "−0.5000");
        assert_eq!(small(3.4e-7), "3.4e−7");
        assert_eq!(small(0.01234), "0.012");
        assert_eq!(small(12.3), "12");
        assert_eq!(fixed(-0.00001, 3), "0.000");
        assert_eq!(percent(0.455), "45.5 %");
    }
}
