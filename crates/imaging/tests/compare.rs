//! Each comparator accepts what is equal, rejects a planted error, and ignores what it must.

#![allow(clippy::unwrap_used, reason = "a test may stop where it fails")]

use stratiform_imaging::compare::{Band, Sampled, errors, relative, signed, significance};
use stratiform_imaging::{Image, ImagingError};

const SIDE: usize = 64;
const FLOOR: f64 = 0.01;
/// Of the tests here on significance: false alarms of each.
const FALSE_ALARM: f64 = 1e-4;

/// A smooth truth between 0.1 and 0.4.
fn truth() -> Image {
    let value = |i: usize| 0.1 + 0.3 * ((i % SIDE) as f32 / SIDE as f32);
    Image::new(SIDE, SIDE, (0..SIDE * SIDE).map(|i| [value(i), 0.9 * value(i), 0.8 * value(i)]).collect())
        .unwrap()
}

/// A standard normal number for each pixel: two hashed uniform ones by Box and Muller.
fn normal(seed: u64, i: usize) -> f64 {
    let hash = |n: u64| {
        let mut x = (n + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15).wrapping_add(seed);
        x = (x ^ x >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        x = (x ^ x >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((x ^ x >> 31) >> 11) as f64 / (1_u64 << 53) as f64
    };
    let (u, v) = (hash(2 * i as u64), hash(2 * i as u64 + 1));
    (-2.0 * libm::log(1.0 - u)).sqrt() * libm::cos(std::f64::consts::TAU * v)
}

/// The truth as it would be sampled, all channels erring together, and its standard error of `share` of each value.
fn sampled(seed: u64, share: f32) -> (Image, Image) {
    let truth = truth();
    let noisy =
        truth.pixels().iter().enumerate().map(|(i, p)| p.map(|v| v + share * v * normal(seed, i) as f32));
    (Image::new(SIDE, SIDE, noisy.collect()).unwrap(), truth.map(|p| p.map(|v| share * v)))
}

#[test]
fn an_equal_picture_has_no_error() {
    let (zero, truth) = (truth().map(|_| [0.0; 3]), truth());
    let exact = Sampled { mean: &truth, std_error: &zero };
    for band in Band::ALL {
        let found = errors(&truth, &exact, band, FLOOR).unwrap();
        assert_eq!((found.bias, found.median, found.worst, found.excess_rms), (0.0, 0.0, 0.0, 0.0));
        assert_eq!(significance(&truth, &exact, band, 3.0).unwrap().beyond, 0.0);
    }
}

#[test]
fn a_planted_share_is_found_in_size_and_sign() {
    let (zero, truth) = (truth().map(|_| [0.0; 3]), truth());
    let exact = Sampled { mean: &truth, std_error: &zero };
    let brighter = truth.map(|p| [p[0] * 1.02, p[1], p[2]]);
    let red = errors(&brighter, &exact, Band::Red, FLOOR).unwrap();
    assert!((red.median - 0.02).abs() < 1e-5 && (red.worst - 0.02).abs() < 1e-5, "{red:?}");
    assert!((red.bias / red.mean_truth - 0.02).abs() < 1e-6 && red.bias_error == 0.0);
    assert_eq!(errors(&brighter, &exact, Band::Blue, FLOOR).unwrap().worst, 0.0);
    assert!(signed(&brighter, &exact, Band::Red).unwrap().values().iter().all(|d| *d > 0.0));
    let one = Image::new(
        SIDE,
        SIDE,
        truth.pixels().iter().enumerate().map(|(i, p)| if i == 70 { [9.0; 3] } else { *p }).collect(),
    );
    let map = relative(&one.unwrap(), &exact, Band::Luminance, FLOOR).unwrap();
    let at: Vec<_> = map.values().iter().enumerate().filter(|(_, v)| **v > 0.0).map(|(i, _)| i).collect();
    assert_eq!(at, [70]);
}

/// Darkness below the floor counts by its absolute error.
#[test]
fn the_floor_holds_in_the_dark() {
    let truth = Image::new(2, 1, vec![[1.0; 3], [0.0; 3]]).unwrap();
    let picture = Image::new(2, 1, vec![[1.0; 3], [0.001; 3]]).unwrap();
    let zero = truth.map(|_| [0.0; 3]);
    let found = errors(&picture, &Sampled { mean: &truth, std_error: &zero }, Band::Green, FLOOR).unwrap();
    assert!((found.floor - 0.005).abs() < 1e-12 && (found.worst - 0.2).abs() < 1e-6, "{found:?}");
}

#[test]
fn noise_of_the_truth_is_taken_off_and_no_more() {
    let (mean, std_error) = sampled(1, 0.05);
    let noisy = Sampled { mean: &mean, std_error: &std_error };
    let perfect = errors(&truth(), &noisy, Band::Luminance, FLOOR).unwrap();
    // The variance of 4096 squares of normal numbers: a share of 2.2 % of the noise's square at one sigma, hence 26 % of its root at three.
    assert!(perfect.excess_rms < 0.3 * perfect.noise, "{perfect:?}");
    assert!(perfect.bias.abs() < 4.0 * perfect.bias_error, "{perfect:?}");
    // |normal| has the median 0.6745.
    assert!((perfect.median / perfect.noise_median - 0.6745).abs() < 0.06, "{perfect:?}");
    let wrong = truth().map(|p| p.map(|v| v * 1.05));
    let found = errors(&wrong, &noisy, Band::Luminance, FLOOR).unwrap();
    let planted = 0.05 * (found.mean_truth * found.mean_truth * 1.1).sqrt();
    assert!((found.excess_rms / planted - 1.0).abs() < 0.15, "{found:?} {planted}");
    assert!(found.bias > 10.0 * found.bias_error);
}

/// False alarms: 20 seeds at a rate of 1e-4 each.
#[test]
fn significance_ignores_noise_and_sees_a_planted_error() {
    for seed in 0..20 {
        let (mean, std_error) = sampled(seed, 0.05);
        let found =
            significance(&truth(), &Sampled { mean: &mean, std_error: &std_error }, Band::Luminance, 3.0)
                .unwrap();
        assert!(found.probability > FALSE_ALARM, "seed {seed}: {} of {}", found.beyond, found.expected);
    }
    let (mean, std_error) = sampled(1, 0.05);
    let noisy = Sampled { mean: &mean, std_error: &std_error };
    // A tenth of the pixels off by 4 sigma; all pixels off by half a sigma; a standard error said to be half of what it is.
    let columns = Image::new(
        SIDE,
        SIDE,
        truth()
            .pixels()
            .iter()
            .enumerate()
            .map(|(i, p)| if i % 10 == 0 { p.map(|v| 1.2 * v) } else { *p })
            .collect(),
    );
    let all = truth().map(|p| p.map(|v| 1.025 * v));
    let small = std_error.map(|p| p.map(|v| 0.5 * v));
    for (picture, truth) in
        [(&columns.unwrap(), noisy), (&all, noisy), (&truth(), Sampled { mean: &mean, std_error: &small })]
    {
        let found = significance(picture, &truth, Band::Luminance, 3.0).unwrap();
        assert!(found.probability < FALSE_ALARM, "{} of {}", found.beyond, found.expected);
    }
}

#[test]
fn what_cannot_be_compared_is_refused() {
    let (truth, small) = (truth(), Image::new(1, 1, vec![[0.0; 3]]).unwrap());
    let unlike = errors(&small, &Sampled { mean: &truth, std_error: &truth }, Band::Red, FLOOR);
    assert!(matches!(unlike, Err(ImagingError::Unlike { .. })));
    let nan = truth.map(|_| [f32::NAN; 3]);
    let bad = errors(&nan, &Sampled { mean: &truth, std_error: &truth }, Band::Red, FLOOR);
    assert!(matches!(bad, Err(ImagingError::NotFinite { x: 0, y: 0, .. })));
    let negative = truth.map(|p| p.map(|v| -v));
    let refused = significance(&truth, &Sampled { mean: &truth, std_error: &negative }, Band::Red, 3.0);
    assert!(matches!(refused, Err(ImagingError::Domain(_))));
    let exact = Sampled { mean: &truth, std_error: &truth };
    assert!(matches!(errors(&truth, &exact, Band::Red, 0.0), Err(ImagingError::Domain(_))));
    assert!(matches!(significance(&truth, &exact, Band::Red, f64::NAN), Err(ImagingError::Domain(_))));
}
