//! The model itself: every flux of one slab.

use crate::parameters::Light;
use crate::{
    Parameters, Real, Thickness,
    brackets::{once_each, rise, twice_back},
    exponential_integral::{diffuse_rise, exponential_integral_e3},
};

/// Which reading of appendix A is evaluated.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Form {
    /// As printed: T_2b = r²/4 (1 + (2x-1) τ_c(2H)) τ_c(3H), which grows like x where two scatterings
    /// must grow like x².
    AsPrinted,
    /// With τ_c(-2H) in its place, as the paper's own integral gives: T_2b = r²/4 e^{-x} (2x - 1 + e^{-2x}).
    Corrected,
}

/// Shares of the flux incident on the slab.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fluxes<F> {
    /// All transmitted light.
    pub t_ms: F,
    /// All reflected light.
    pub r_ms: F,
    /// Unscattered light.
    pub t_0: F,
    /// Transmitted after one scattering.
    pub t_1: F,
    /// Transmitted after two.
    pub t_2: F,
    /// Transmitted after three or more: a difference, negative where the terms do not fit together.
    pub t_3_plus: F,
    /// Reflected after one scattering.
    pub r_1: F,
    /// Reflected after two.
    pub r_2: F,
    /// Reflected after three or more: a difference, negative where the terms do not fit together.
    pub r_3_plus: F,
}

impl<F: Real> Fluxes<F> {
    /// Names and values, in the order of the fields.
    pub fn named(&self) -> [(&'static str, F); 9] {
        [
            ("t_ms", self.t_ms),
            ("r_ms", self.r_ms),
            ("t_0", self.t_0),
            ("t_1", self.t_1),
            ("t_2", self.t_2),
            ("t_3_plus", self.t_3_plus),
            ("r_1", self.r_1),
            ("r_2", self.r_2),
            ("r_3_plus", self.r_3_plus),
        ]
    }
}

impl<F: Real> Parameters<F> {
    /// Every flux of a slab of this thickness.
    pub fn fluxes(&self, form: Form, thickness: Thickness<F>) -> Fluxes<F> {
        let h = thickness.get();
        let (t_ms, r_ms) = (self.t_ms(h), self.r_ms(h));
        let (t_1, t_2) = (self.t_1(h), self.t_2(form, h));
        let (r_1, r_2) = (self.r_1(h), self.r_2(h));
        // 1 - T_0 - R_ms where both are small, T_ms - T_0 elsewhere: the larger terms cancel in neither.
        let scattered = if r_ms < F::of(0.5) { self.extinguished(h) - r_ms } else { t_ms - self.t_0(h) };
        let t_3_plus = scattered - t_1 - t_2;
        Fluxes { t_ms, r_ms, t_0: self.t_0(h), t_1, t_2, t_3_plus, r_1, r_2, r_3_plus: r_ms - r_1 - r_2 }
    }

    fn t_ms(&self, h: F) -> F {
        let one = F::of(1.0);
        (one - (one - self.values.b) * rise(self.values.c * h)) / (one + self.slope * h)
    }

    /// 1 - T_ms = (slope H + (1-b)(1 - e^{-cH})) / (1 + slope H).
    fn r_ms(&self, h: F) -> F {
        let one = F::of(1.0);
        (self.slope * h + (one - self.values.b) * rise(self.values.c * h)) / (one + self.slope * h)
    }

    fn t_0(&self, h: F) -> F {
        let zero = F::of(0.0);
        let depth = self.values.kappa_s * h;
        match self.light {
            Light::Beam(mu) if mu > zero => (-(depth / mu)).exp(),
            Light::Beam(_) if h > zero => zero,
            Light::Beam(_) => F::of(1.0),
            Light::Diffuse => F::of(2.0) * exponential_integral_e3(depth),
        }
    }

    /// 1 - T_0.
    fn extinguished(&self, h: F) -> F {
        let depth = self.values.kappa_s * h;
        match self.light {
            Light::Beam(mu) if mu > F::of(0.0) => rise(depth / mu),
            Light::Beam(_) => F::of(1.0) - self.t_0(h),
            Light::Diffuse => diffuse_rise(depth),
        }
    }

    fn t_1(&self, h: F) -> F {
        let x = self.values.kappa_c * h;
        self.values.t * x * (-x).exp()
    }

    fn r_1(&self, h: F) -> F {
        F::of(0.5) * self.values.r * rise(F::of(2.0) * self.values.kappa_c * h)
    }

    fn t_2(&self, form: Form, h: F) -> F {
        let x = self.values.kappa_c * h;
        let twice_forward = F::of(0.5) * (self.values.t * x) * (self.values.t * x * (-x).exp());
        twice_forward + F::of(0.25) * self.values.r * self.values.r * t_2b(form, x)
    }

    fn r_2(&self, h: F) -> F {
        F::of(0.5) * self.values.r * self.values.t * once_each(F::of(2.0) * self.values.kappa_c * h)
    }
}

/// T_2b without its factor r²/4.
fn t_2b<F: Real>(form: Form, x: F) -> F {
    let y = F::of(2.0) * x;
    match form {
        Form::Corrected => (-x).exp() * twice_back(y),
        Form::AsPrinted => (rise(y) + y * (-y).exp()) * (-(F::of(3.0) * x)).exp(),
    }
}
