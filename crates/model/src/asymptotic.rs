//! Thick lossless slabs without any fitted parameter.
//!
//! T_ms ≈ K(μ_l) / (¾ (1-g) τ + 1.07), with the escape function K ≈ (3/7)(1 + 2μ_l), and K = 1 in diffuse light
//! (van de Hulst 1980; Kokhanovsky 2006). τ and g are those of the full medium, or both those of the modified
//! one. Valid from τ of about 5 in a cloud: the reduced thickness (1-g) τ must exceed about 0.5; below that
//! T_ms of this form exceeds the truth, and may exceed 1.

use stratiform_quantities::{Asymmetry, CosZenith, Incidence, OpticalThickness};

/// Twice the extrapolation length of a non-absorbing half-space, in units of 4/3 of the transport mean path.
pub const EXTRAPOLATION: f64 = 1.07;

/// K(μ) ≈ (3/7)(1 + 2μ), normalised so that its flux mean 2∫Kμdμ is 1.
pub fn escape_function(mu: CosZenith) -> f64 {
    3.0 / 7.0 * (1.0 + 2.0 * mu.get())
}

/// T_ms of a thick lossless slab.
pub fn t_ms(incidence: Incidence, g: Asymmetry, tau: OpticalThickness) -> f64 {
    let escape = match incidence {
        Incidence::Beam(mu) => escape_function(mu),
        Incidence::Diffuse => 1.0,
    };
    escape / (0.75 * (1.0 - g.get()) * tau.get() + EXTRAPOLATION)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn escape_function_has_unit_flux() {
        let steps = 1000;
        let cell = |i: i32| {
            let mu = (f64::from(i) + 0.5) / f64::from(steps);
            2.0 * mu * escape_function(CosZenith::new(mu).unwrap()) / f64::from(steps)
        };
        assert!(((0..steps).map(cell).sum::<f64>() - 1.0).abs() < 1e-6);
    }
}
