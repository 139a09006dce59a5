//! One collision and one flight in single precision, as plain arithmetic: the same bits on every machine.
//!
//! Sums and products only, each rounded by itself (no fused multiply-add, no division), and one square root. A
//! random word u stands for ξ = (u + ½)/2³²; angles are sampled by [`LinearPieces`].
//!
//! | function | value | error |
//! | --- | --- | --- |
//! | [`optical_path`] | -ln ξ | 5·10⁻⁷ of the value, or 10⁻⁷ where that is more (ξ near 1) |
//! | [`flight_path`] | -ln ξ', ξ' = (u mod 2²² + ½)/2²² | the same |
//! | [`azimuth_cosine`] | cos ψ, ψ = πi/2³¹, i the word as a signed number | 9·10⁻⁷ |
//! | [`scattered`] | μ' = μ - μv + √((1-μ²) v (2-v)) cosψ | 3·10⁻⁷ beside that of v |
//!
//! One word serves both azimuth and path of a flight. At a given path its top ten bits leave the azimuth one of 1024 evenly
//! spaced ones, whose moments are those of a uniform azimuth up to degree 1023: the two are as good as independent. The
//! mean path is 1 - 8·10⁻⁸, the mean of its square 2 - 3·10⁻⁶: the midpoint rule of 2²² points. Double precision uses words in the
//! same way.
//!
//! What rounding does to fluxes is measured: [`Kernel::SINGLE_DEPTH`](crate::Kernel::SINGLE_DEPTH).
//!
//! μ' may lie beyond ±1 by rounding; the next collision takes (1-μ)(1+μ) < 0 as 0.

use crate::kernels::horner;
use stratiform_optics::sampling::LinearPieces;

/// The bits of √½.
const HALF_ROOT: u32 = 0x3f35_04f3;
/// ln(1+t)/t on √½ ≤ 1+t < √2 to 1.8·10⁻⁷ of the value, minimax.
const LOGARITHM: [f32; 8] =
    [1.0, -0.500_003_2, 0.333_347_14, -0.249_712_29, 0.199_068_83, -0.172_432_24, 0.161_805, -0.100_823_775];
/// sin(πy)/y in y², |y| ≤ ½, to 6·10⁻⁷ of the sine, minimax.
const SINE: [f32; 4] = [3.141_582, -5.167_143, 2.541_898_5, -0.554_634_5];
/// The bits of a word that give the path of a flight.
const PATH_BITS: u32 = 22;

/// -ln ξ of a word, an optical path of mean 1; in \[0, 22.9\].
#[inline(always)]
pub fn optical_path(bits: u32) -> f32 {
    minus_logarithm::<32>(bits as f32 + 0.5)
}

/// -ln ξ' of a word's lower bits, the path between two collisions; in \[0, 16\].
#[inline(always)]
pub fn flight_path(bits: u32) -> f32 {
    let low = bits & ((1 << PATH_BITS) - 1);
    minus_logarithm::<PATH_BITS>(low as i32 as f32 + 0.5)
}

/// -ln(x/2ⁿ), 0 < x ≤ 2ⁿ, n = `BITS`.
///
/// x = 2ᵏm with m ∈ \[√½, √2), so it is (n-k) ln 2 - ln m.
#[inline(always)]
fn minus_logarithm<const BITS: u32>(x: f32) -> f32 {
    // The exponent field counts from √½, and from 2ⁿ instead of 1.
    let shifted = x.to_bits().wrapping_sub(HALF_ROOT + (BITS << 23));
    let exponent = (shifted as i32 >> 23) as f32;
    let t = f32::from_bits((shifted & 0x007f_ffff) + HALF_ROOT) - 1.0;
    exponent * -std::f32::consts::LN_2 - t * polynomial(t, LOGARITHM)
}

/// cosψ of a word, ψ uniform: sin πy with y = ½ - |ψ/π|.
#[inline(always)]
pub fn azimuth_cosine(bits: u32) -> f32 {
    let y = 0.5 - (bits as i32 as f32 * (1.0 / 2_147_483_648.0)).abs();
    y * horner(y * y, SINE)
}

/// √ξ of a word: the direction cosine of diffuse light on entering.
#[inline(always)]
pub fn diffuse_cosine(bits: u32) -> f32 {
    ((bits as f32 + 0.5) * (1.0 / 4_294_967_296.0)).sqrt()
}

/// The direction cosine after scattering by 1 - cosΘ = `v` with azimuth cosine `azimuth`.
#[inline(always)]
pub fn scattered(mu: f32, v: f32, azimuth: f32) -> f32 {
    let sine = ((1.0 - mu) * (1.0 + mu) * (v * (2.0 - v))).max(0.0).sqrt();
    mu - mu * v + sine * azimuth
}

/// One collision and the flight after it, from two words (angle; azimuth and path): the new μ and depth.
#[inline(always)]
pub fn collide_and_fly(table: &LinearPieces, mu: f32, depth: f32, words: [u32; 2]) -> (f32, f32) {
    let mu = scattered(mu, table.sample(words[0]), azimuth_cosine(words[1]));
    (mu, depth + mu * flight_path(words[1]))
}

/// Σ c_n tⁿ as even plus odd powers, two chains side by side.
#[inline(always)]
fn polynomial(t: f32, c: [f32; 8]) -> f32 {
    let square = t * t;
    horner(square, [c[0], c[2], c[4], c[6]]) + t * horner(square, [c[1], c[3], c[5], c[7]])
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;
    use std::sync::Arc;
    use stratiform_optics::phase::{HenyeyGreenstein, PhaseFunction};
    use stratiform_quantities::Asymmetry;

    const UNIT: f64 = 1.0 / 4_294_967_296.0;

    fn words() -> impl Iterator<Item = u32> {
        let ends = (0..2000).chain((0..2000).map(|k| u32::MAX - k));
        let powers = (1..32).flat_map(|k| (0..3_u32).map(move |d| (1_u32 << k) - 1 + d));
        ends.chain(powers).chain((0..4_000_000_u32).map(|k| k.wrapping_mul(2_654_435_761)))
    }

    #[test]
    fn the_path_is_the_logarithm() {
        for bits in words() {
            let exact = -libm::log((f64::from(bits) + 0.5) * UNIT);
            let got = f64::from(optical_path(bits));
            assert!((got - exact).abs() <= (5e-7 * exact).max(1e-7) && got >= 0.0, "{bits}: {got} {exact}");
        }
        assert_eq!(optical_path(u32::MAX), 0.0);
    }

    #[test]
    fn the_path_of_a_flight_is_the_logarithm_of_the_lower_bits() {
        for bits in words() {
            let exact = -libm::log((f64::from(bits % (1 << PATH_BITS)) + 0.5) / 4_194_304.0);
            let got = f64::from(flight_path(bits));
            assert!((got - exact).abs() <= (5e-7 * exact).max(1e-7) && got >= 0.0, "{bits}: {got} {exact}");
        }
    }

    /// Over all 2²² paths of a flight the mean is 1 and the mean square 2, as well as the module's first lines say, and over the
    /// azimuths of each path of a sample the first four moments are those of a uniform azimuth.
    #[test]
    fn path_and_azimuth_of_one_word_are_as_good_as_independent() {
        let n = 1 << PATH_BITS;
        let (mut first, mut second) = (0.0, 0.0);
        for low in 0..n {
            let path = f64::from(flight_path(low));
            (first, second) = (first + path, second + path * path);
        }
        let [first, second] = [first, second].map(|sum| sum / f64::from(n));
        assert!((first - 1.0).abs() < 2e-7 && (second - 2.0).abs() < 4e-6, "{first} {second}");
        for low in (0..n).step_by(4099) {
            let cosines = (0..1024).map(|high| f64::from(azimuth_cosine((high << PATH_BITS) | low)));
            let moments = cosines.fold([0.0; 4], |[a, b, c, d], cosine| {
                let square = cosine * cosine;
                [a + cosine, b + square, c + cosine * square, d + square * square]
            });
            for (moment, exact) in moments.iter().zip([0.0, 0.5, 0.0, 0.375]) {
                assert!((moment / 1024.0 - exact).abs() < 2e-7, "{low}: {moments:?}");
            }
        }
    }

    /// Mean and second moment of the path over evenly spaced words are those of the exponential law, to 10⁻⁷ and 2·10⁻⁷.
    #[test]
    fn the_path_has_no_bias() {
        let (n, mut first, mut second) = (1 << 22, 0.0, 0.0);
        let (mut exact_first, mut exact_second) = (0.0, 0.0);
        for k in 0..n {
            let bits = (k << 10) + 511;
            let (got, exact) = (f64::from(optical_path(bits)), -libm::log((f64::from(bits) + 0.5) * UNIT));
            (first, second) = (first + got, second + got * got);
            (exact_first, exact_second) = (exact_first + exact, exact_second + exact * exact);
        }
        let [first, second] = [first - exact_first, second - exact_second].map(|sum| sum / f64::from(n));
        assert!(first.abs() < 1e-7 && second.abs() < 2e-7, "{first:e} {second:e}");
    }

    #[test]
    fn the_azimuth_is_the_cosine() {
        for bits in words() {
            let exact = libm::cos(2.0 * PI * f64::from(bits as i32) * UNIT);
            let got = f64::from(azimuth_cosine(bits));
            assert!((got - exact).abs() <= 9e-7, "{bits}: {got} {exact}");
        }
    }

    #[test]
    fn a_scattering_is_the_cosine_rule() {
        for bits in words().take(500_000) {
            let mu = f64::from(azimuth_cosine(bits.wrapping_mul(747_796_405))) as f32;
            let (v, azimuth) = (2.0 * diffuse_cosine(bits), azimuth_cosine(bits.wrapping_mul(277_803_737)));
            let [m, w, a] = [mu, v, azimuth].map(f64::from);
            let exact = m * (1.0 - w) + ((1.0 - m * m).max(0.0) * (w * (2.0 - w)).max(0.0)).sqrt() * a;
            let got = f64::from(scattered(mu, v, azimuth));
            assert!((got - exact).abs() <= 3e-7, "{mu} {v} {azimuth}: {got} {exact}");
        }
        assert!(scattered(1.000_000_1, 2.000_000_2, 1.0).is_finite());
    }

    /// A thousand collisions leave μ within [-1, 1] but for rounding.
    #[test]
    fn a_long_history_stays_in_domain() {
        let phase = HenyeyGreenstein::new(Asymmetry::new(0.85).unwrap());
        let phase: Arc<dyn PhaseFunction> = Arc::new(phase);
        let table = LinearPieces::new(phase.as_ref());
        let (mut mu, mut depth) = (1.0, 0.0);
        for k in 0..100_000_u32 {
            let word = |salt: u32| (2 * k + salt).wrapping_mul(2_654_435_761) ^ (k << 7);
            (mu, depth) = collide_and_fly(&table, mu, depth, [word(0), word(1)]);
            assert!(mu.abs() < 1.000_001 && depth.is_finite());
        }
    }
}
