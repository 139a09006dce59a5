//! Phase functions in tables: exact, and as texels of a shader.
//!
//! [`Exact`] has the tables themselves in double precision. [`Texels`] has N values at equal steps of
//! `stratiform_quantities::angle_map`, read as emitted shaders read them: acos(1-v) by Abramowitz & Stegun 4.4.46, linear in the
//! map's coordinate; P_S is P/(1-P_f) from θ_f on. The values are those of `stratiform_tables::sampled`, whose look-up keeps the
//! integral. N ∈ \[64, 1024\].

use crate::lobe::Lobe;
use crate::scalar::{Scalar, least, most};
use crate::{Cloud, MethodError};
use std::sync::Arc;
use stratiform_model::angular::PhaseLookup;
use stratiform_optics::phase::{Modified, PhaseFunction, PhaseTable, versine};
use stratiform_tables::sampled::Sampled;

/// Texels of what codegen emits.
pub const EMITTED_TEXELS: usize = 1024;

/// The tables themselves.
#[derive(Clone)]
pub struct Exact {
    full: Arc<PhaseTable>,
    wide: Arc<Modified>,
    squared: Option<Arc<PhaseTable>>,
}

impl Exact {
    /// P and P_S of `cloud`, without P_S * P_S.
    pub fn once(cloud: &Cloud) -> Self {
        Self { full: cloud.phase().clone(), wide: cloud.modified().clone(), squared: None }
    }

    /// P, P_S and P_S * P_S of `cloud`.
    ///
    /// # Errors
    /// [`MethodError::Phase`] if P_S has no square.
    pub fn twice(cloud: &Cloud) -> Result<Self, MethodError> {
        Ok(Self { squared: Some(cloud.squared()?), ..Self::once(cloud) })
    }
}

impl PhaseLookup<f64> for Exact {
    fn full(&self, v: f64) -> f64 {
        self.full.value(v)
    }

    fn wide(&self, v: f64) -> f64 {
        self.wide.value(v)
    }

    /// 0 unless made by [`Exact::twice`].
    fn wide_squared(&self, v: f64) -> f64 {
        self.squared.as_ref().map_or(0.0, |table| table.value(v))
    }
}

impl Lobe<f64> for Exact {
    fn at(&self, v: f64) -> f64 {
        self.full.value(v)
    }
}

/// Texels of a shader.
#[derive(Clone, Debug)]
pub struct Texels<F> {
    full: Vec<F>,
    squared: Vec<F>,
    /// 1 - cosθ_f.
    edge: F,
    /// 1/(1-P_f).
    scale: F,
}

impl<F: Scalar> Texels<F> {
    /// `count` texels of P, from which P_S follows; none of P_S * P_S.
    ///
    /// # Errors
    /// [`MethodError`] unless 64 ≤ `count` ≤ 1024.
    pub fn once(cloud: &Cloud, count: usize) -> Result<Self, MethodError> {
        Ok(Self {
            full: texels(cloud.phase(), count)?,
            squared: vec![F::of(0.0); 2],
            edge: F::of(versine(cloud.theta_f_deg().to_radians())),
            scale: F::of(1.0 / (1.0 - cloud.forward_fraction())),
        })
    }

    /// `count` texels of P and as many of P_S * P_S.
    ///
    /// # Errors
    /// As [`once`](Self::once), and as [`Exact::twice`].
    pub fn twice(cloud: &Cloud, count: usize) -> Result<Self, MethodError> {
        Ok(Self { squared: texels(&*cloud.squared()?, count)?, ..Self::once(cloud, count)? })
    }
}

fn texels<F: Scalar>(table: &PhaseTable, count: usize) -> Result<Vec<F>, MethodError> {
    Ok(Sampled::new(table, count)?.values.into_iter().map(F::of).collect())
}

/// acos(1 - v), error below 1e-7 of π and relative at both ends (Abramowitz & Stegun 1964, 4.4.46).
fn arc<F: Scalar>(v: F) -> F {
    const SERIES: [f64; 8] = [
        -0.001_262_491_1,
        0.006_670_090_1,
        -0.017_088_125_6,
        0.030_891_881_0,
        -0.050_174_304_6,
        0.088_978_987_4,
        -0.214_598_801_6,
        1.570_796_305_0,
    ];
    let nearest = most(least(v, F::of(2.0) - v), F::of(0.0));
    let x = F::of(1.0) - nearest;
    let sum = SERIES.iter().fold(F::of(0.0), |sum, term| sum * x + F::of(*term));
    let arc = nearest.sqrt() * sum;
    if v <= F::of(1.0) { arc } else { F::of(std::f64::consts::PI) - arc }
}

/// The linear look-up of `values` at v.
fn look_up<F: Scalar>(values: &[F], v: F) -> F {
    let turn = F::of(0.5 / std::f64::consts::PI);
    let theta = arc(v);
    let coordinate = if theta < F::of(std::f64::consts::FRAC_PI_2) {
        (theta * turn).sqrt()
    } else {
        F::of(1.0) - (most(F::of(std::f64::consts::PI) - theta, F::of(0.0)) * turn).sqrt()
    };
    let place = coordinate * F::of((values.len() - 1) as f64);
    let cell = (place.to_f64() as usize).min(values.len() - 2);
    values[cell] + (values[cell + 1] - values[cell]) * (place - F::of(cell as f64))
}

impl<F: Scalar> PhaseLookup<F> for Texels<F> {
    fn full(&self, v: F) -> F {
        look_up(&self.full, v)
    }

    fn wide(&self, v: F) -> F {
        if v < self.edge { F::of(0.0) } else { self.scale * look_up(&self.full, v) }
    }

    /// 0 unless made by [`Texels::twice`].
    fn wide_squared(&self, v: F) -> F {
        look_up(&self.squared, v)
    }
}

impl<F: Scalar> Lobe<F> for Texels<F> {
    fn at(&self, v: F) -> F {
        look_up(&self.full, v)
    }
}
