//! Single-precision fluxes against the f64 model.

use stratiform_codegen::{QUANTITIES, SelfTest};

/// Largest error of a flux. Measured on Mesa 22.3 llvmpipe: 1.9e-7.
pub const ABSOLUTE: f64 = 2e-6;
/// Largest relative error of a flux above [`FAINT`]; of T_3+ and R_3+ relative to the terms of the difference.
pub const RELATIVE: f64 = 2e-5;
/// Below this no relative error is asked for: a rounding of the path x = ln(1/flux) is x roundings of e^{-x}.
pub const FAINT: f64 = 1e-20;

/// Largest errors of one flux over all vectors.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Errors {
    /// Absolute.
    pub absolute: f64,
    /// Relative, of what is not faint.
    pub relative: f64,
}

/// What the error of flux `i` is relative to.
fn scale([t_ms, r_ms, _, t_1, t_2, _, r_1, r_2, _]: [f64; 9], i: usize, exact: f64) -> f64 {
    match i {
        5 => exact.abs() + t_1 + t_2 + r_ms.min(t_ms),
        8 => exact.abs() + r_1 + r_2,
        _ => exact.abs(),
    }
}

/// Largest errors per flux over all vectors; infinite where a value is missing or not finite.
pub fn errors(test: &SelfTest, fluxes: &[f32]) -> [Errors; 9] {
    let mut worst = [Errors::default(); 9];
    for (k, vector) in test.vectors.iter().enumerate() {
        for (i, worst) in worst.iter_mut().enumerate() {
            let exact = vector.fluxes[i];
            let value = fluxes.get(9 * k + i).map_or(f64::NAN, |value| f64::from(*value));
            let error = if value.is_finite() { (value - exact).abs() } else { f64::INFINITY };
            worst.absolute = worst.absolute.max(error);
            if exact.abs() > FAINT || error.is_infinite() {
                worst.relative = worst.relative.max(error / scale(vector.fluxes, i, exact));
            }
        }
    }
    worst
}

/// The fluxes whose errors are out of bounds, each with them; empty if there is none.
pub fn wrong(errors: &[Errors; 9]) -> Vec<(&'static str, Errors)> {
    let pairs = QUANTITIES.into_iter().zip(*errors);
    pairs.filter(|(_, e)| !(e.absolute < ABSOLUTE && e.relative < RELATIVE)).collect()
}

/// Largest absolute and relative error over all fluxes, as one line.
pub fn summary(errors: &[Errors; 9]) -> String {
    let worst = |of: fn(&Errors) -> f64| errors.iter().map(of).fold(0.0, f64::max);
    format!("absolute {:.1e}, relative {:.1e}", worst(|e| e.absolute), worst(|e| e.relative))
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "a test may stop where it fails")]

    use super::*;
    use stratiform_codegen::SelfTestVector;
    use stratiform_quantities::Incidence;

    const FLUXES: [f64; 9] = [0.5, 0.5, 1e-21, 0.125, 0.0625, 0.3125, 0.25, 0.125, 0.125];

    fn test() -> SelfTest {
        let vector = SelfTestVector { mu_l: Incidence::beam(0.5).unwrap(), tau: 3.0, fluxes: FLUXES };
        SelfTest {
            schema: String::new(),
            inputs_hash: String::new(),
            quantities: QUANTITIES.map(str::to_owned).to_vec(),
            vectors: vec![vector.clone(), vector],
        }
    }

    /// The model's own fluxes with flux `i` of the second vector off by `relative` of itself.
    fn off(i: usize, relative: f64) -> Vec<f32> {
        let mut fluxes = [FLUXES, FLUXES].concat();
        fluxes[9 + i] *= 1.0 + relative;
        fluxes.into_iter().map(|value| value as f32).collect()
    }

    #[test]
    fn equal_fluxes_are_accepted() {
        let errors = errors(&test(), &off(0, 0.0));
        assert!(wrong(&errors).is_empty(), "{errors:?}");
    }

    #[test]
    fn a_slip_of_any_flux_is_named() {
        for (i, name) in QUANTITIES.into_iter().enumerate().filter(|(i, _)| *i != 2) {
            let wrong = wrong(&errors(&test(), &off(i, 1e-4)));
            assert_eq!(wrong.len(), 1, "{wrong:?}");
            assert_eq!(wrong[0].0, name);
        }
    }

    #[test]
    fn faint_fluxes_and_differences_get_what_rounding_needs() {
        assert!(wrong(&errors(&test(), &off(2, 1e-3))).is_empty(), "1e-21 has no relative bound");
        assert!(wrong(&errors(&test(), &off(2, 1e16))).len() == 1, "but an absolute one");
        let mut test = test();
        test.vectors[1].fluxes[8] = 1e-7;
        let mut fluxes = off(0, 0.0);
        fluxes[17] = 1.5e-7;
        assert!(wrong(&errors(&test, &fluxes)).is_empty(), "R_3+ is a difference of larger terms");
    }

    #[test]
    fn what_is_missing_or_not_a_number_is_wrong() {
        assert_eq!(wrong(&errors(&test(), &off(0, 0.0)[..9])).len(), 9);
        for bad in [f32::NAN, f32::INFINITY] {
            let mut fluxes = off(0, 0.0);
            fluxes[3] = bad;
            assert_eq!(wrong(&errors(&test(), &fluxes))[0].0, "t_1");
        }
    }
}
