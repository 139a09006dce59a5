//! Colours of numbers.

use std::f64::consts::TAU;

/// A map from a number to a colour.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Colours {
    /// For [0, 1]: black to white with growing brightness, the cube helix (Green 2011, "A colour scheme for the display of astronomical
    /// intensity images", Bull. Astr. Soc. India 39; start 0.5, rotations -1.5, hue and γ 1).
    Sequential,
    /// For [-1, 1]: blue where negative, white at 0, red where positive.
    Diverging,
}

/// Ends of the diverging map, equally dark; stored sRGB.
const BLUE: [f64; 3] = [0.13, 0.33, 0.70];
const RED: [f64; 3] = [0.73, 0.13, 0.17];

impl Colours {
    /// Stored sRGB in bytes; numbers beyond the ends get the end's colour.
    pub fn of(self, value: f64) -> [u8; 3] {
        let stored = match self {
            Self::Sequential => helix(value.clamp(0.0, 1.0)),
            Self::Diverging => {
                let end = if value < 0.0 { BLUE } else { RED };
                let size = value.abs().min(1.0);
                end.map(|channel| 1.0 + size * (channel - 1.0))
            }
        };
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "in [0, 255]")]
        stored.map(|channel| (255.0 * channel.clamp(0.0, 1.0) + 0.5) as u8)
    }
}

fn helix(value: f64) -> [f64; 3] {
    let angle = TAU * (0.5 / 3.0 + 1.0 - 1.5 * value);
    let amplitude = 0.5 * value * (1.0 - value);
    let (cos, sin) = (libm::cos(angle), libm::sin(angle));
    let channel = |along: f64, across: f64| value + amplitude * (along * cos + across * sin);
    [channel(-0.148_61, 1.782_77), channel(-0.292_27, -0.906_49), channel(1.972_94, 0.0)]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::srgb;

    fn brightness(colour: [u8; 3]) -> f64 {
        srgb::luminance(colour.map(|byte| srgb::decode(f64::from(byte) / 255.0)))
    }

    #[test]
    fn brightness_grows_with_the_number() {
        let all: Vec<f64> =
            (0..=64).map(|i| brightness(Colours::Sequential.of(f64::from(i) / 64.0))).collect();
        assert!(all.windows(2).all(|pair| pair[1] > pair[0]), "{all:?}");
        assert_eq!(Colours::Sequential.of(0.0), [0; 3]);
        assert_eq!(Colours::Sequential.of(7.0), [255; 3]);
    }

    #[test]
    fn both_signs_are_as_dark_and_zero_is_white() {
        assert_eq!(Colours::Diverging.of(0.0), [255; 3]);
        let [less, more] = [-1.0, 1.0].map(|value| brightness(Colours::Diverging.of(value)));
        assert!((less - more).abs() < 0.03, "{less} {more}");
        let [b, r] = [-1.0, 1.0].map(|value| Colours::Diverging.of(value));
        assert!(b[2] > b[0] && r[0] > r[2]);
    }
}
