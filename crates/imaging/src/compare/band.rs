//! Which number of a pixel is compared.

use crate::srgb;

/// Luminance or one channel. The standard error of a luminance is the weighted sum of the channels': the same paths of light carry all three, so
/// they err together, and the sum is the most that it can be.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Band {
    /// Of linear sRGB.
    Luminance,
    /// R.
    Red,
    /// G.
    Green,
    /// B.
    Blue,
}

impl Band {
    /// All of them.
    pub const ALL: [Self; 4] = [Self::Luminance, Self::Red, Self::Green, Self::Blue];

    /// Its name in files.
    pub fn name(self) -> &'static str {
        match self {
            Self::Luminance => "luminance",
            Self::Red => "red",
            Self::Green => "green",
            Self::Blue => "blue",
        }
    }

    /// The number.
    pub fn of(self, pixel: [f32; 3]) -> f64 {
        match self {
            Self::Luminance => srgb::luminance(pixel.map(f64::from)),
            Self::Red => f64::from(pixel[0]),
            Self::Green => f64::from(pixel[1]),
            Self::Blue => f64::from(pixel[2]),
        }
    }
}
