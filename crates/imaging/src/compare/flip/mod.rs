//! FLIP: how much of a difference an observer sees who alternates between two pictures on a display (Andersson, Nilsson,
//! Akenine-Möller, Oskarsson, Åström & Fairchild, "FLIP: A Difference Evaluator for Alternating Images", Proc. ACM Comput. Graph.
//! Interact. Tech. 3(2), 2020), for pictures of low dynamic range.
//!
//! Two pipelines, both on stored sRGB. *Colour* (section 4.1): both pictures are filtered by the contrast sensitivity of an eye that sees
//! `pixels_per_degree`, and the distance of their colours is taken (HyAB in Hunt-adjusted CIELAB), redistributed to \[0, 1\].
//! *Features* (4.2): strengths of edges and points from derivatives of a Gaussian on lightness. Together (4.3): ΔE = ΔE_c^(1 - ΔE_f),
//! in \[0, 1\] for every pixel; 0 where nothing differs.
//!
//! Held against the authors' program to 1e-4 per pixel.

mod colour;
mod feature;
mod filter;

use crate::{Grey, Image, ImagingError, Tone};
use filter::Plane;
use stratiform_quantities::Range;

/// A display of 0.7 m width and 3840 columns seen from 0.7 m, as the paper rounds it.
pub const PIXELS_PER_DEGREE: f64 = 67.0;

/// FLIP of every pixel of `picture` against `truth`, both shown by `tone`.
///
/// # Errors
/// [`ImagingError::Unlike`] if they are not of one size, [`ImagingError::NotFinite`] for a pixel, [`ImagingError::Domain`] for pixels
/// per degree outside [1, 1000].
pub fn flip(
    picture: &Image,
    truth: &Image,
    tone: &Tone,
    pixels_per_degree: f64,
) -> Result<Grey, ImagingError> {
    picture.must_be_like(truth)?;
    Range::closed(1.0, 1e3).check("pixels_per_degree", pixels_per_degree)?;
    for image in [picture, truth] {
        image.must_be_finite()?;
    }
    let [a, b] = [truth, picture].map(|image| {
        let stored: Vec<_> = image.pixels().iter().map(|pixel| tone.stored(*pixel)).collect();
        opponent(image.width(), &stored)
    });
    Grey::new(picture.width(), picture.height(), combined(&a, &b, pixels_per_degree))
}

/// Y, Cx, Cz of a picture (linear opponent space of CIELAB's axes).
type Opponent = [Plane; 3];

fn opponent(width: usize, stored: &[[f64; 3]]) -> Opponent {
    let colours: Vec<[f64; 3]> = stored.iter().map(|s| colour::opponent(*s)).collect();
    std::array::from_fn(|c| Plane::new(width, colours.iter().map(|colour| colour[c]).collect()))
}

fn combined(truth: &Opponent, picture: &Opponent, pixels_per_degree: f64) -> Vec<f32> {
    let colours = colour::differences(truth, picture, pixels_per_degree);
    let features = feature::differences(&truth[0], &picture[0], pixels_per_degree);
    colours.iter().zip(features).map(|(colour, feature)| libm::pow(*colour, 1.0 - feature) as f32).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Hashed bytes, so that pictures hold every frequency.
    fn noise(seed: u32) -> u32 {
        let mut x = seed.wrapping_mul(0x9e37_79b9) ^ 0x85eb_ca6b;
        for shift in [16, 13, 16] {
            x = (x ^ x >> shift).wrapping_mul(0xc2b2_ae35);
        }
        x ^ x >> 16
    }

    type Bytes = Vec<[u8; 3]>;

    /// A gradient; the same with an edge moved; noise of two strengths; a colour cast; black against white.
    fn pairs(width: usize, height: usize) -> Vec<(&'static str, Bytes, Bytes)> {
        let draw = |of: &dyn Fn(usize, usize) -> [u8; 3]| -> Bytes {
            (0..height).flat_map(|y| (0..width).map(move |x| (x, y))).map(|(x, y)| of(x, y)).collect()
        };
        let ramp = |x: usize, y: usize| [(x * 4 % 256) as u8, (y * 5 % 256) as u8, ((x + y) * 2 % 256) as u8];
        let grain = |x: usize, y: usize, strength: u32| {
            let base = ramp(x, y);
            std::array::from_fn(|c| {
                let n = noise((x + 1000 * y + 7_000_000 * c) as u32) % strength;
                base[c].saturating_add(n as u8)
            })
        };
        let edge = |at: usize| move |x: usize, _: usize| if x < at { [30, 60, 90] } else { [200, 190, 150] };
        vec![
            ("grain of 8", draw(&ramp), draw(&|x, y| grain(x, y, 8))),
            ("grain of 120", draw(&ramp), draw(&|x, y| grain(x, y, 120))),
            ("moved edge", draw(&edge(20)), draw(&edge(23))),
            ("cast", draw(&ramp), draw(&|x, y| [ramp(x, y)[0] / 2, ramp(x, y)[1], 255 - ramp(x, y)[2] / 3])),
            ("opposites", draw(&|_, _| [0; 3]), draw(&|_, _| [255; 3])),
            ("green and blue", draw(&|_, _| [0, 255, 0]), draw(&|_, _| [0, 0, 255])),
        ]
    }

    fn ours(width: usize, truth: &Bytes, picture: &Bytes, pixels_per_degree: f64) -> Vec<f32> {
        let [a, b] = [truth, picture].map(|bytes| {
            let stored: Vec<_> = bytes.iter().map(|p| p.map(|b| f64::from(b) / 255.0)).collect();
            opponent(width, &stored)
        });
        combined(&a, &b, pixels_per_degree)
    }

    fn theirs(size: (usize, usize), truth: &Bytes, picture: &Bytes, pixels_per_degree: f64) -> Vec<f32> {
        let [a, b] = [truth, picture].map(|bytes| {
            nv_flip::FlipImageRgb8::with_data(size.0 as u32, size.1 as u32, bytes.as_flattened())
        });
        nv_flip::flip(a, b, pixels_per_degree as f32).to_vec()
    }

    #[test]
    fn every_pixel_is_that_of_the_authors_program() {
        let (width, height) = (61, 43);
        for pixels_per_degree in [PIXELS_PER_DEGREE, 25.0] {
            for (name, truth, picture) in pairs(width, height) {
                let ours = ours(width, &truth, &picture, pixels_per_degree);
                let theirs = theirs((width, height), &truth, &picture, pixels_per_degree);
                let worst = ours.iter().zip(&theirs).map(|(a, b)| (a - b).abs()).fold(0.0, f32::max);
                assert!(worst < 1e-4, "{name} at {pixels_per_degree}: {worst:e}");
                assert!(theirs.iter().any(|v| *v > 0.01), "{name}: guard against comparing nothing");
            }
        }
    }

    #[test]
    fn the_default_distance_is_the_authors() {
        assert_eq!(PIXELS_PER_DEGREE, f64::from(nv_flip::DEFAULT_PIXELS_PER_DEGREE));
    }

    #[test]
    fn equal_pictures_have_none_and_a_planted_difference_some() {
        let grey = |level: f32| Image::new(16, 16, vec![[level; 3]; 256]).unwrap();
        let tone = Tone::default();
        assert_eq!(flip(&grey(0.1), &grey(0.1), &tone, PIXELS_PER_DEGREE).unwrap().mean(), 0.0);
        let faint = flip(&grey(0.1), &grey(0.11), &tone, PIXELS_PER_DEGREE).unwrap().mean();
        let strong = flip(&grey(0.1), &grey(0.2), &tone, PIXELS_PER_DEGREE).unwrap().mean();
        assert!(faint > 0.005 && strong > 3.0 * faint, "{faint} {strong}");
        let small = Image::new(1, 1, vec![[0.1; 3]]).unwrap();
        assert!(matches!(flip(&grey(0.1), &small, &tone, 67.0), Err(ImagingError::Unlike { .. })));
        assert!(matches!(flip(&grey(0.1), &grey(0.1), &tone, f64::NAN), Err(ImagingError::Domain(_))));
    }
}
