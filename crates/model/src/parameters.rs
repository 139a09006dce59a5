//! Parameters and thickness, checked.

use crate::{ModelError, Real};
use stratiform_quantities::{DomainError, Incidence, Range};

/// The numbers of one row of the table, per its unit of thickness, unchecked.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Values<F> {
    /// β, T_ms at thickness 1.
    pub beta: F,
    /// b, the correction of T_ms in thick slabs.
    pub b: F,
    /// c, the rate at which that correction sets in.
    pub c: F,
    /// κ_c, extinction of the one-dimensional column.
    pub kappa_c: F,
    /// t, forward scattering coefficient of the column.
    pub t: F,
    /// r, backward scattering coefficient of the column.
    pub r: F,
    /// κ_S, extinction of the modified medium.
    pub kappa_s: F,
}

impl Values<f64> {
    /// The same numbers in the precision of `F`.
    pub fn cast<F: Real>(&self) -> Values<F> {
        let Values { beta, b, c, kappa_c, t, r, kappa_s } = *self;
        let of = F::of;
        Values {
            beta: of(beta),
            b: of(b),
            c: of(c),
            kappa_c: of(kappa_c),
            t: of(t),
            r: of(r),
            kappa_s: of(kappa_s),
        }
    }
}

/// How the slab is lit, in the precision of `F`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Light<F> {
    /// A beam with this μ_l.
    Beam(F),
    /// Hemispheric light.
    Diffuse,
}

/// Checked [`Values`] and the incidence they hold for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parameters<F> {
    pub(crate) values: Values<F>,
    /// (1-β)/β, so that β/(H-(H-1)β) = 1/(1 + slope H); rounded once, because β is near 1.
    pub(crate) slope: F,
    pub(crate) light: Light<F>,
}

const RATE: Range = Range::closed(0.0, 1e6);
const POSITIVE_RATE: Range = Range { min_included: false, ..RATE };
const UNIT: Range = Range::closed(0.0, 1.0);

fn check(values: &Values<f64>) -> Result<(), DomainError> {
    Range { min_included: false, ..UNIT }.check("beta", values.beta)?;
    Range { min_included: false, ..Range::closed(0.0, 100.0) }.check("b", values.b)?;
    RATE.check("c", values.c)?;
    POSITIVE_RATE.check("kappa_c", values.kappa_c)?;
    UNIT.check("t", values.t)?;
    UNIT.check("r", values.r)?;
    RATE.check("kappa_s", values.kappa_s)?;
    Ok(())
}

impl<F: Real> Parameters<F> {
    /// Checks β ∈ (0, 1\], b ∈ (0, 100\], c, κ_S ∈ \[0, 1e6\], κ_c ∈ (0, 1e6\], t, r ∈ \[0, 1\].
    ///
    /// # Errors
    /// [`ModelError::Domain`] naming the first number that lies outside.
    pub fn new(values: &Values<f64>, incidence: Incidence) -> Result<Self, ModelError> {
        check(values)?;
        let light = match incidence {
            Incidence::Beam(mu) => Light::Beam(F::of(mu.get())),
            Incidence::Diffuse => Light::Diffuse,
        };
        let slope = F::of((1.0 - values.beta) / values.beta);
        Ok(Self { values: values.cast(), slope, light })
    }

    /// Interpolation from `a` (weight 0) to `b` (weight 1): linear in b, t, κ_S, (1-β)/β and in the reciprocals
    /// 1/c, 1/κ_c, 1/r, none of which is infinite.
    pub(crate) fn between(a: &Self, b: &Self, weight: F, light: Light<F>) -> Self {
        let between = |from: F, to: F| from + (to - from) * weight;
        let mix = |of: fn(&Values<F>) -> F| between(of(&a.values), of(&b.values));
        let mix_reciprocal = |of: fn(&Values<F>) -> F| {
            let (from, to) = (of(&a.values), of(&b.values));
            from * to / (to + (from - to) * weight)
        };
        let values = Values {
            b: mix(|v| v.b),
            c: mix_reciprocal(|v| v.c),
            kappa_c: mix_reciprocal(|v| v.kappa_c),
            t: mix(|v| v.t),
            r: mix_reciprocal(|v| v.r),
            kappa_s: mix(|v| v.kappa_s),
            // Linear in 1/β is linear in (1-β)/β.
            beta: mix_reciprocal(|v| v.beta),
        };
        Self { values, slope: between(a.slope, b.slope), light }
    }

    /// The numbers, in the precision of `F`.
    pub fn values(&self) -> &Values<F> {
        &self.values
    }
}

/// A thickness in the parameters' unit, 0 ≤ H ≤ 1e6.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct Thickness<F>(F);

impl<F: Real> Thickness<F> {
    /// The allowed values.
    pub const RANGE: Range = Range::closed(0.0, 1e6);

    /// Checks `value`.
    ///
    /// # Errors
    /// [`ModelError::Domain`] if it is not finite or outside [`Self::RANGE`].
    pub fn new(value: F) -> Result<Self, ModelError> {
        Self::RANGE.check("thickness", value.to_f64())?;
        Ok(Self(value))
    }

    /// The number.
    pub fn get(self) -> F {
        self.0
    }
}
