//! Where the light of three and more scatterings goes.

use crate::Real;

/// The shape of I3+ over the hemisphere. Each gives the whole flux: 2∫ factor μ_v dμ_v = 1.
///
/// The paper's own is [`as_printed::emission`](super::as_printed::emission), which gives half of it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Emission {
    /// L/F0 = μ_l/(2πμ_v): every depth of a thin slab shines evenly. Nearest in thin slabs; infinite at μ_v = 0.
    Isotropic,
    /// L/F0 = μ_l/π. Nearest in thick slabs' reflection.
    Lambertian,
    /// L/F0 = μ_l K(μ_v)/π, K(μ) = (3/7)(1 + 2μ): the light that leaves a thick slab's dark side.
    Escape,
}

impl Emission {
    /// All three.
    pub const ALL: [Self; 3] = [Self::Isotropic, Self::Lambertian, Self::Escape];

    /// Reflectance factor per unit of flux, for μ_v ∈ (0, 1].
    pub fn factor<F: Real>(self, mu_v: F) -> F {
        match self {
            Self::Isotropic => F::of(0.5) / mu_v,
            Self::Lambertian => F::of(1.0),
            Self::Escape => F::of(3.0 / 7.0) * (F::of(1.0) + F::of(2.0) * mu_v),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::asymptotic::escape_function;
    use stratiform_quantities::CosZenith;

    fn flux(factor: impl Fn(f64) -> f64) -> f64 {
        let cells = 1000;
        let cell = |i: i32| {
            let mu = (f64::from(i) + 0.5) / f64::from(cells);
            2.0 * mu * factor(mu) / f64::from(cells)
        };
        (0..cells).map(cell).sum()
    }

    #[test]
    fn every_shape_gives_the_whole_flux_and_the_printed_one_half() {
        for emission in Emission::ALL {
            assert!((flux(|mu| emission.factor(mu)) - 1.0).abs() < 1e-6, "{emission:?}");
        }
        assert!((flux(super::super::as_printed::emission) - 0.5).abs() < 1e-12);
    }

    #[test]
    fn the_escape_function_is_the_thick_slabs() {
        for mu in [0.0, 0.3, 1.0] {
            let one = escape_function(CosZenith::new(mu).unwrap());
            assert!((Emission::Escape.factor(mu) - one).abs() < 1e-15);
        }
    }
}
