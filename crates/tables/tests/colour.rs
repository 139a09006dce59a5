//! Phase functions in linear sRGB against what colorimetry demands of them.
#![allow(clippy::unwrap_used, reason = "a test may stop where it fails")]

use stratiform_optics::phase::{HenyeyGreenstein, Norm, PhaseFunction, PhaseTable};
use stratiform_quantities::Asymmetry;
use stratiform_tables::colour::{SrgbPhase, colour_error, srgb_phase};

fn hg(g: f64, nodes: usize) -> PhaseTable {
    let law = HenyeyGreenstein::new(Asymmetry::new(g).unwrap());
    let theta: Vec<f64> = (0..=nodes).map(|i| 180.0 * i as f64 / nodes as f64).collect();
    let p = theta.iter().map(|t| law.value(1.0 - libm::cos(t.to_radians()))).collect();
    PhaseTable::new(theta, p, Norm::Any).unwrap()
}

/// `count` wavelengths from 0.38 to 0.78 µm with g falling by 0.3 between them.
fn rainbow(count: usize) -> Vec<(f64, PhaseTable)> {
    let at = |i: usize| i as f64 / (count - 1) as f64;
    (0..count).map(|i| (0.38 + 0.4 * at(i), hg(0.8 - 0.3 * at(i), 720))).collect()
}

#[test]
fn what_does_not_depend_on_the_wavelength_is_grey_to_the_last_bit() {
    let table = hg(0.7, 360);
    let spectrum: Vec<_> = [0.4, 0.47, 0.55, 0.65].map(|w| (w, table.clone())).into();
    let colour = srgb_phase(&spectrum).unwrap();
    assert_eq!(colour.theta_deg, table.theta_deg());
    for (rgb, p) in colour.rgb.iter().zip(table.values()) {
        assert_eq!(*rgb, [*p; 3]);
    }
}

/// What is scattered forward at 0.45 µm alone is blue, at 0.55 µm green, at 0.65 µm red.
#[test]
fn the_channels_stand_for_their_colours() {
    let forward = |strong: usize| {
        let g = |k: usize| if k == strong { 0.85 } else { 0.6 };
        let spectrum: Vec<_> =
            [0.45, 0.55, 0.65].iter().enumerate().map(|(k, w)| (*w, hg(g(k), 360))).collect();
        srgb_phase(&spectrum).unwrap().rgb[0]
    };
    for (strong, channel) in [(0, 2), (1, 1), (2, 0)] {
        let rgb = forward(strong);
        assert!((0..3).all(|c| c == channel || rgb[c] < rgb[channel]), "{strong}: {rgb:?}");
    }
}

/// Every channel is a mix of normalised functions whose weights add up to 1.
#[test]
fn every_channel_is_normalised() {
    let colour = srgb_phase(&rainbow(9)).unwrap();
    for c in 0..3 {
        let p: Vec<f64> = colour.rgb.iter().map(|rgb| rgb[c]).collect();
        let sum = trapezoid(&colour.theta_deg, &p);
        assert!((sum - 1.0).abs() < 1e-4, "{c}: {sum}");
        assert!((1.02 * sum - 1.0).abs() > 1e-2, "2 % too much are seen");
    }
}

/// ½∫P sinΘ dΘ by the trapezoid rule.
fn trapezoid(theta_deg: &[f64], p: &[f64]) -> f64 {
    let f = |i: usize| 0.5 * p[i] * libm::sin(theta_deg[i].to_radians());
    (1..p.len()).map(|i| 0.5 * (f(i - 1) + f(i)) * (theta_deg[i] - theta_deg[i - 1]).to_radians()).sum()
}

/// A single line of the spectrum is outside sRGB: its negative channels are kept and told.
#[test]
fn colours_outside_the_gamut_keep_their_sign() {
    let g = |w: f64| if w == 0.5 { 0.95 } else { 0.0 };
    let spectrum: Vec<_> = [0.36, 0.48, 0.5, 0.52, 0.83].map(|w| (w, hg(g(w), 1440))).into();
    let colour = srgb_phase(&spectrum).unwrap();
    let (least, theta) = colour.smallest_channel();
    assert!(least < -1.0 && theta == 0.0, "{least} at {theta}");
    assert_eq!(colour.rgb[0][0], least);
}

#[test]
fn nodes_of_all_tables_are_there_and_jumps_stay() {
    let jumping = hg(0.7, 100).modified(5.0).unwrap();
    let spectrum = [(0.45, hg(0.7, 180)), (0.55, jumping.clone()), (0.65, jumping)];
    let colour = srgb_phase(&spectrum).unwrap();
    let at_jump: Vec<usize> = (0..colour.rgb.len()).filter(|i| colour.theta_deg[*i] == 5.0).collect();
    assert_eq!(at_jump.len(), 2);
    assert!(colour.rgb[at_jump[0]][0] < 0.5 * colour.rgb[at_jump[1]][0]);
    assert!(colour.theta_deg.windows(2).all(|pair| pair[0] <= pair[1]));
    assert!(colour.theta_deg.contains(&1.0) && colour.theta_deg.contains(&(180.0 * 3.0 / 100.0)));
}

/// The change from leaving out every second wavelength is above the error, which 257 wavelengths tell.
#[test]
fn the_error_of_few_wavelengths_is_estimated_from_above() {
    let distance = |a: &SrgbPhase, b: &SrgbPhase| {
        let luminance = |rgb: &[f64; 3]| 0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2];
        let of = |(a, b): (&[f64; 3], &[f64; 3])| {
            (0..3).map(|c| (a[c] - b[c]).abs() / luminance(b)).fold(0.0, f64::max)
        };
        a.rgb.iter().zip(&b.rgb).map(of).fold(0.0, f64::max)
    };
    let truth = srgb_phase(&rainbow(257)).unwrap();
    for count in [9, 17, 33] {
        let spectrum = rainbow(count);
        let error = distance(&srgb_phase(&spectrum).unwrap(), &truth);
        let estimate = colour_error(&spectrum).unwrap().unwrap();
        assert_eq!(estimate.kept, count.div_ceil(2));
        assert!(error < estimate.largest && estimate.largest < 8.0 * error, "{count}: {error} {estimate:?}");
    }
    assert!(colour_error(&rainbow(4)).unwrap().is_none());
}

#[test]
fn spectra_without_colour_are_refused_with_value_and_range() {
    let message = |wavelengths: &[f64]| {
        let spectrum: Vec<_> = wavelengths.iter().map(|w| (*w, hg(0.5, 90))).collect();
        srgb_phase(&spectrum).unwrap_err().to_string()
    };
    assert_eq!(message(&[0.45, 0.55]), "wavelengths of a colour = 2 is outside [3, infinity)");
    assert_eq!(message(&[0.45, 0.55, 0.9]), "wavelength_um = 0.9 is outside [0.36, 0.83]");
    assert_eq!(message(&[0.45, f64::NAN, 0.65]), "wavelength_um = NaN is outside [0.36, 0.83]");
    assert_eq!(message(&[0.65, 0.55, 0.45]), "wavelength_um (ascending) = 0.55 is outside (0.65, 0.83]");
    assert_eq!(message(&[0.45, 0.45, 0.65]), "wavelength_um (ascending) = 0.45 is outside (0.45, 0.83]");
}
