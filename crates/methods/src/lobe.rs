//! Phase functions as a shader evaluates them, in either precision.

use crate::scalar::Scalar;
use stratiform_tables::nearest::Blend;

/// A phase function of v = 1 - cosΘ, mean 1 over the sphere.
pub trait Lobe<F>: Send + Sync {
    /// P at v.
    fn at(&self, v: F) -> F;
}

/// Henyey and Greenstein's function.
#[derive(Clone, Copy, Debug)]
pub struct Hg<F> {
    /// g.
    pub g: F,
}

/// (1-g²)/((1-g)² + 2gv)^{3/2} (Henyey & Greenstein 1941, eq. 2).
pub(crate) fn henyey_greenstein<F: Scalar>(g: F, v: F) -> F {
    let (one, two) = (F::of(1.0), F::of(2.0));
    let square = (one - g) * (one - g) + two * g * v;
    (one - g) * (one + g) / (square * square.sqrt())
}

impl<F: Scalar> Lobe<F> for Hg<F> {
    fn at(&self, v: F) -> F {
        henyey_greenstein(self.g, v)
    }
}

/// (1-w)·HG(g1) + w·Draine(g2, α): Draine 2003, eq. 20; the blend is that of Jendersie & d'Eon 2023.
#[derive(Clone, Copy, Debug)]
pub struct HgDraine<F> {
    w: F,
    g1: F,
    g2: F,
    alpha: F,
    /// 1/(1 + α(1+2g²)/3).
    norm: F,
}

impl<F: Scalar> HgDraine<F> {
    /// From the parameters of a blend.
    pub fn new(blend: &Blend) -> Self {
        let norm = 1.0 / (1.0 + blend.alpha * (1.0 + 2.0 * blend.g2 * blend.g2) / 3.0);
        let of = F::of;
        Self { w: of(blend.w), g1: of(blend.g1), g2: of(blend.g2), alpha: of(blend.alpha), norm: of(norm) }
    }
}

impl<F: Scalar> Lobe<F> for HgDraine<F> {
    fn at(&self, v: F) -> F {
        let (one, mu) = (F::of(1.0), F::of(1.0) - v);
        let draine = henyey_greenstein(self.g2, v) * (one + self.alpha * mu * mu) * self.norm;
        (one - self.w) * henyey_greenstein(self.g1, v) + self.w * draine
    }
}

/// Rayleigh's function without polarisation, ¾(1 + cos²Θ).
#[derive(Clone, Copy, Debug)]
pub struct Rayleigh;

impl<F: Scalar> Lobe<F> for Rayleigh {
    fn at(&self, v: F) -> F {
        let mu = F::of(1.0) - v;
        F::of(0.75) * (F::of(1.0) + mu * mu)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use stratiform_optics::phase::PhaseFunction;
    use stratiform_tables::nearest::jendersie_deon;

    /// The lobes against the phase functions of `optics` and `tables`, which have their own checks.
    #[test]
    fn lobes_are_the_phase_functions() {
        let blend = jendersie_deon(14.0).unwrap();
        let (expected, lobe) = (blend.phase().unwrap(), HgDraine::<f64>::new(&blend));
        for v in [0.0, 1e-6, 0.01, 0.5, 1.0, 1.7, 2.0] {
            assert!((lobe.at(v) / expected.value(v) - 1.0).abs() < 1e-12, "{v}");
            let single = HgDraine::<f32>::new(&blend).at(v as f32);
            // g_HG = 0.992: the peak's height has the error of 1 - g, 125 times that of g.
            assert!((f64::from(single) / expected.value(v) - 1.0).abs() < 1e-4, "{v}");
        }
    }
}
