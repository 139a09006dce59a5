//! From radiance to what a display shows.
//!
//! 1. Exposure: x = π L 2^EV, so that at EV 0 a white diffuser that faces the sun (L = 1/π) is the display's white.
//! 2. Gamut: a colour with a negative component (bows and glories have some outside sRGB's triangle) is mixed with the grey of its
//!    luminance until that component is 0, which keeps luminance and hue; luminance below 0 becomes black.
//! 3. Curve, on each channel: [`Curve::Clip`] takes 1 for what is brighter; [`Curve::Shoulder`] is x up to s = 0.6 and
//!    s + (1 - s)(1 - exp(-(x - s)/(1 - s))) above: slope 1 where they meet, below 1 always. Bright colours go to white, as on film.
//!
//! The transfer curve of [`srgb`] follows; it is no part of the tone.

use crate::{Image, ImagingError, srgb};
use stratiform_quantities::Range;

/// Where the shoulder begins.
const SHOULDER: f64 = 0.6;

/// How bright light is shown.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Curve {
    /// Nothing is changed below white; all above is white.
    Clip,
    /// Nothing is changed below 0.6; brighter light approaches white.
    #[default]
    Shoulder,
}

impl Curve {
    /// Its name in files and on command lines.
    pub fn name(self) -> &'static str {
        match self {
            Self::Clip => "clip",
            Self::Shoulder => "shoulder",
        }
    }

    fn of(self, x: f64) -> f64 {
        match self {
            Self::Clip => x.min(1.0),
            Self::Shoulder if x > SHOULDER => {
                let rest = 1.0 - SHOULDER;
                SHOULDER + rest * -libm::expm1(-(x - SHOULDER) / rest)
            }
            Self::Shoulder => x,
        }
    }
}

/// Exposure and curve.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Tone {
    /// In stops: at 0 a white diffuser that faces the sun is white.
    pub exposure_ev: f64,
    /// How bright light is shown.
    pub curve: Curve,
}

impl Tone {
    /// With the default curve.
    pub fn at(exposure_ev: f64) -> Self {
        Self { exposure_ev, ..Self::default() }
    }

    /// The exposure at which the image's 95th percentile of luminance is 0.8 of white, by at most 20 stops either way: what is
    /// darker still stays dark. 0 where all is black.
    pub fn fitting(image: &Image) -> Self {
        let mut bright: Vec<f64> =
            image.pixels().iter().map(|p| srgb::luminance(p.map(f64::from))).filter(|y| *y > 0.0).collect();
        bright.sort_by(f64::total_cmp);
        let at = bright.get((bright.len() * 95 / 100).min(bright.len().saturating_sub(1)));
        let exposure = at.map_or(0.0, |y| libm::log2(0.8 / (std::f64::consts::PI * y)));
        Self::at(libm::round(4.0 * exposure.clamp(-20.0, 20.0)) / 4.0)
    }

    /// Display-linear light, each channel in [0, 1], of finite radiance.
    pub fn show(&self, radiance: [f32; 3]) -> [f64; 3] {
        let scale = std::f64::consts::PI * libm::exp2(self.exposure_ev);
        inside(radiance.map(|l| scale * f64::from(l))).map(|x| self.curve.of(x))
    }

    /// The stored sRGB value, each channel in [0, 1], of finite radiance.
    pub fn stored(&self, radiance: [f32; 3]) -> [f64; 3] {
        self.show(radiance).map(srgb::encode)
    }

    /// The stored sRGB value in bytes.
    ///
    /// # Errors
    /// [`ImagingError::Domain`] for an exposure outside [-30, 30], [`ImagingError::NotFinite`] for a pixel.
    pub fn bytes(&self, image: &Image) -> Result<Vec<u8>, ImagingError> {
        Range::closed(-30.0, 30.0).check("exposure_ev", self.exposure_ev)?;
        image.must_be_finite()?;
        Ok(image.pixels().iter().flat_map(|pixel| self.stored(*pixel).map(byte)).collect())
    }
}

#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a stored value is in [0, 1]")]
fn byte(stored: f64) -> u8 {
    (255.0 * stored + 0.5) as u8
}

/// The nearest colour towards grey of the same luminance that has no negative component.
fn inside(colour: [f64; 3]) -> [f64; 3] {
    let least = colour.into_iter().fold(f64::INFINITY, f64::min);
    if least >= 0.0 {
        return colour;
    }
    let grey = srgb::luminance(colour);
    if grey <= 0.0 {
        return [0.0; 3];
    }
    let kept = grey / (grey - least);
    // Rounding may leave the least component a hair below 0.
    colour.map(|x| (grey + kept * (x - grey)).max(0.0))
}

#[cfg(test)]
mod tests {
    use super::*;

    const WHITE: f32 = std::f32::consts::FRAC_1_PI;

    #[test]
    fn exposure_is_in_stops_from_a_sunlit_diffuser() {
        let clip = |ev: f64| Tone { exposure_ev: ev, curve: Curve::Clip };
        assert!((clip(0.0).show([WHITE; 3])[0] - 1.0).abs() < 1e-6);
        assert!((clip(-1.0).show([WHITE; 3])[1] - 0.5).abs() < 1e-6);
        assert!((clip(2.0).show([WHITE / 8.0; 3])[2] - 0.5).abs() < 1e-6);
        assert_eq!(clip(3.0).show([WHITE; 3]), [1.0; 3]);
    }

    #[test]
    fn the_shoulder_is_smooth_and_never_clips() {
        let of = |x| Curve::Shoulder.of(x);
        assert_eq!(of(0.5), 0.5);
        let slope = (of(0.6 + 1e-6) - of(0.6)) / 1e-6;
        assert!((slope - 1.0).abs() < 1e-5, "{slope}");
        assert!((1..200).all(|i| of(0.02 * f64::from(i)) > of(0.02 * f64::from(i - 1))));
        assert!(of(4.0) < 1.0);
    }

    #[test]
    fn colours_outside_the_gamut_keep_luminance_and_hue() {
        let colour = [0.5, 0.3, -0.1];
        let [r, g, b] = inside(colour);
        assert!(b == 0.0 && r > g);
        assert!((srgb::luminance([r, g, b]) - srgb::luminance(colour)).abs() < 1e-15);
        // Towards grey: the order and the ratio of the differences stay.
        assert!(((r - g) / (g - b) - 0.2 / 0.4).abs() < 1e-12);
        assert_eq!(inside([0.1, -0.5, 0.1]), [0.0; 3]);
    }

    #[test]
    fn an_exposure_fits_what_is_shown() {
        let image = Image::new(10, 10, (0..100).map(|i| [i as f32 / 100.0; 3]).collect()).unwrap();
        let shown = Tone { curve: Curve::Clip, ..Tone::fitting(&image) }.show([0.95; 3])[0];
        assert!((0.8 / 1.1..0.8 * 1.1).contains(&shown), "{shown}");
        let black = Image::new(1, 1, vec![[0.0; 3]]).unwrap();
        assert_eq!(Tone::fitting(&black).exposure_ev, 0.0);
        let faint = Image::new(1, 1, vec![[1e-30; 3]]).unwrap();
        assert_eq!(Tone::fitting(&faint).bytes(&faint).unwrap(), [0; 3]);
    }

    #[test]
    fn nan_is_not_shown() {
        let bad = Image::new(1, 1, vec![[f32::NAN; 3]]).unwrap();
        assert!(matches!(Tone::default().bytes(&bad), Err(ImagingError::NotFinite { .. })));
        let good = Image::new(1, 1, vec![[0.0; 3]]).unwrap();
        assert!(matches!(Tone::at(f64::NAN).bytes(&good), Err(ImagingError::Domain(_))));
    }
}
