//! Radiance of a slab: the angular model of Bouthors, Neyret & Lefebvre 2006, section 4.
//!
//! Every function returns the reflectance factor πL/(μ_l F0), finite at grazing light; L/F0 (1/sr), which shaders
//! multiply by the sun's irradiance, is factor·μ_l/π.

mod sight;

pub use sight::Sight;

/// The phase functions that the model looks up, each at v = 1 - cosΘ ∈ \[0, 2\], with mean 1 over the sphere.
pub trait PhaseLookup<F> {
    /// P of the full medium.
    fn full(&self, v: F) -> F;
    /// P_S of the modified medium: P/(1-P_f) from θ_f on, 0 below.
    fn wide(&self, v: F) -> F;
    /// P_S convolved with itself on the sphere.
    fn wide_squared(&self, v: F) -> F;
}
