//! What each wavelength adds to linear sRGB: D65 seen by the CIE 1931 2° observer, by IEC 61966-2-1's matrix.
//!
//! Colour matching functions in steps of 1 nm, D65 linear between its 5 nm rows (CIE 015:2018, section 7.1 and table 1).
//! Each channel's weights are divided by their sum: D65 itself, reflected by P = 1, is white.

const MATCHING: &str = include_str!("../../../../reference-data/cie-1931/colour-matching-functions.csv");
const D65: &str = include_str!("../../../../reference-data/cie-1931/d65.csv");

/// CIE XYZ to linear sRGB, IEC 61966-2-1:1999.
const SRGB_OF_XYZ: [[f64; 3]; 3] =
    [[3.2406, -1.5372, -0.4986], [-0.9689, 1.8758, 0.0415], [0.0557, -0.2040, 1.0570]];

/// A nanometre of the spectrum and its weight in each channel.
#[derive(Clone, Copy, Debug)]
pub(super) struct Band {
    pub(super) wavelength_um: f64,
    pub(super) weight: [f64; 3],
}

/// The bands from 0.36 to 0.83 µm; the weights of a channel add up to 1.
pub(super) fn bands() -> Vec<Band> {
    let mut bands: Vec<Band> = stimuli().map(|(nm, xyz)| band(nm, xyz)).collect();
    let white = bands.iter().fold([0.0; 3], |sum, band| add(sum, band.weight));
    for band in &mut bands {
        band.weight = std::array::from_fn(|c| band.weight[c] / white[c]);
    }
    bands
}

/// Wavelengths in nm, with the XYZ that D65 has there.
fn stimuli() -> impl Iterator<Item = (f64, [f64; 3])> {
    let light: Vec<[f64; 2]> = rows(D65).collect();
    rows::<4>(MATCHING).map(move |[nm, x, y, z]| {
        let power = interpolate(&light, nm);
        (nm, [x * power, y * power, z * power])
    })
}

fn band(nm: f64, xyz: [f64; 3]) -> Band {
    let channel = |row: [f64; 3]| row[0] * xyz[0] + row[1] * xyz[1] + row[2] * xyz[2];
    Band { wavelength_um: nm / 1000.0, weight: SRGB_OF_XYZ.map(channel) }
}

fn add(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    std::array::from_fn(|c| a[c] + b[c])
}

fn interpolate(table: &[[f64; 2]], x: f64) -> f64 {
    let right = table.partition_point(|row| row[0] < x).clamp(1, table.len() - 1);
    let ([x0, y0], [x1, y1]) = (table[right - 1], table[right]);
    y0 + (x - x0) / (x1 - x0) * (y1 - y0)
}

/// The rows of `N` numbers; the header is none.
fn rows<const N: usize>(text: &str) -> impl Iterator<Item = [f64; N]> {
    text.lines().filter_map(|line| {
        let fields: Vec<f64> = line.split(',').filter_map(|field| field.parse().ok()).collect();
        fields.try_into().ok()
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The library carries the tables, and they are the ones of record.
    #[test]
    fn the_built_in_tables_are_the_transcribed_ones() {
        let of_record = |file| stratiform_reference_data::read("cie-1931", file).unwrap();
        assert_eq!(MATCHING, of_record("colour-matching-functions.csv"));
        assert_eq!(D65, of_record("d65.csv"));
        assert_eq!(rows::<4>(MATCHING).count(), 471);
        assert_eq!(rows::<2>(D65).count(), 95);
    }

    /// CIE 015:2018, table 3: x = 0.31272, y = 0.32903; XYZ = 95.047, 100, 108.883 (ASTM E308, 1 nm). A table shifted by
    /// one row misses by more than twenty times the tolerance.
    #[test]
    fn d65_has_its_published_white_point() {
        let white = |shift: usize| {
            let light: Vec<f64> =
                (0..471).map(|i| interpolate(&rows(D65).collect::<Vec<_>>(), 360.0 + f64::from(i))).collect();
            rows::<4>(MATCHING)
                .skip(shift)
                .zip(light)
                .fold([0.0; 3], |sum, ([_, x, y, z], s)| add(sum, [x * s, y * s, z * s]))
        };
        let chromaticity = |xyz: [f64; 3]| xyz.map(|v| v / (xyz[0] + xyz[1] + xyz[2]));
        let xyz = white(0);
        let [x, y, _] = chromaticity(xyz);
        assert!((x - 0.31272).abs() < 1.5e-5 && (y - 0.32903).abs() < 1.5e-5, "{x} {y}");
        assert!((100.0 * xyz[0] / xyz[1] - 95.047).abs() < 1e-3, "{xyz:?}");
        assert!((100.0 * xyz[2] / xyz[1] - 108.883).abs() < 1e-3, "{xyz:?}");
        let [x, y, _] = chromaticity(white(5));
        assert!((x - 0.31272).abs() > 3e-4 || (y - 0.32903).abs() > 3e-4, "{x} {y}");
    }

    /// By the rounded matrix alone D65 is white to 5e-4: dividing by the sums changes no colour that can be seen.
    #[test]
    fn the_standards_matrix_makes_d65_white() {
        let xyz = stimuli().fold([0.0; 3], |sum, (_, xyz)| add(sum, xyz));
        let white = band(0.0, xyz.map(|v| v / xyz[1])).weight;
        assert!(white.iter().all(|c| (c - 1.0).abs() < 5e-4), "{white:?}");
    }
}
