//! Methods that a shader could run: one formula, evaluated in double precision and, as the shader would, in single.

use crate::{Card, FluxPair, FluxPoint, MethodError, Point, Ready, Single};
use rayon::prelude::*;
use stratiform_model::angular::Sight;
use stratiform_stats::Estimate;

/// A formula in the precision of `F`, unchecked.
pub trait Shade<F>: Send + Sync {
    /// Reflectance factor; 0 where the method gives no radiance.
    fn radiance(&self, tau: F, sight: &Sight<F>) -> F;

    /// R and T, unscattered light included; 0 where the method gives no fluxes.
    fn fluxes(&self, tau: F, mu_l: F) -> (F, F);
}

/// A formula in both precisions, with the card that says where it holds.
pub(crate) struct Shaded<D, S> {
    pub(crate) card: Card,
    pub(crate) double: D,
    pub(crate) single: InSingle<S>,
}

/// The same formula in f32.
pub(crate) struct InSingle<S>(pub(crate) S);

impl<S: Shade<f32>> Single for InSingle<S> {
    fn radiance(&self, tau: f32, sight: &Sight<f32>) -> f32 {
        self.0.radiance(tau, sight)
    }

    fn fluxes(&self, tau: f32, mu_l: f32) -> (f32, f32) {
        self.0.fluxes(tau, mu_l)
    }
}

/// A value without error of its own.
pub(crate) fn exact(value: f64) -> Estimate {
    Estimate { value, std_error: 0.0 }
}

impl<D: Shade<f64>, S: Shade<f32>> Ready for Shaded<D, S> {
    fn radiances(&self, points: &[Point]) -> Result<Vec<Estimate>, MethodError> {
        self.card.gives_radiance()?;
        let of = |point: &Point| {
            self.card.domain.check(point)?;
            let sight = Sight::new(point.mu_l, point.mu_v, point.phi_deg, point.side)?;
            Ok(exact(self.double.radiance(point.tau, &sight)))
        };
        points.par_iter().map(of).collect()
    }

    fn fluxes(&self, points: &[FluxPoint]) -> Result<Vec<FluxPair>, MethodError> {
        self.card.gives_flux()?;
        let of = |point: &FluxPoint| {
            self.card.domain.check_flux(point)?;
            let (r, t) = self.double.fluxes(point.tau, point.mu_l);
            Ok(FluxPair { reflectance: exact(r), transmittance: exact(t) })
        };
        points.iter().map(of).collect()
    }

    fn single(&self) -> Option<&dyn Single> {
        Some(&self.single)
    }
}
