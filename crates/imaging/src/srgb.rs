//! sRGB as a display takes it (IEC 61966-2-1:1999): D65 white, primaries of ITU-R BT.709, and a transfer curve that is linear at its foot.
//!
//! `encode` goes from linear light to the stored value, `decode` back; both map [0, 1] onto itself and are meant for it.

/// Luminance of linear sRGB: the middle row of the matrix to XYZ, to four digits as the standard prints it.
pub fn luminance(linear: [f64; 3]) -> f64 {
    0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]
}

/// The stored value of linear light.
pub fn encode(linear: f64) -> f64 {
    if linear <= 0.003_130_8 { 12.92 * linear } else { 1.055 * libm::pow(linear, 1.0 / 2.4) - 0.055 }
}

/// The linear light of a stored value.
pub fn decode(stored: f64) -> f64 {
    if stored <= 0.040_45 { stored / 12.92 } else { libm::pow((stored + 0.055) / 1.055, 2.4) }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The ends are exact by the formula; the two pieces meet where the standard says, to the digits of its constants.
    #[test]
    fn the_curve_is_the_standards() {
        assert_eq!((encode(0.0), decode(0.0)), (0.0, 0.0));
        assert!((encode(1.0) - 1.0).abs() < 1e-15 && (decode(1.0) - 1.0).abs() < 1e-15);
        assert!((encode(0.003_130_8 + 1e-12) - encode(0.003_130_8)).abs() < 1e-7);
        assert!((decode(0.040_45 + 1e-12) - decode(0.040_45)).abs() < 1e-7);
        // Middle grey: 18 % reflectance is stored as 118 of 255 (117.6).
        assert!((255.0 * encode(0.18) - 117.6).abs() < 0.1, "{}", 255.0 * encode(0.18));
    }

    #[test]
    fn each_undoes_the_other() {
        for i in 0..=1000 {
            let value = f64::from(i) / 1000.0;
            assert!((decode(encode(value)) - value).abs() < 1e-7, "{value}");
        }
    }

    #[test]
    fn white_has_luminance_one() {
        assert!((luminance([1.0; 3]) - 1.0).abs() < 1e-12);
    }
}
