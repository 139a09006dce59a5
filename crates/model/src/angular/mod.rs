//! Radiance of a slab: the angular model of Bouthors, Neyret & Lefebvre 2006, section 4, corrected.
//!
//! Every function returns the reflectance factor πL/(μ_l F0), finite at grazing light; L/F0 (1/sr), which shaders
//! multiply by the sun's irradiance, is factor·μ_l/π. With x = κ_S H the optical thickness of the modified medium,
//! p = x/μ_l, q = x/μ_v, X = p + q, m = min(p, q) and d = |p - q|:
//!
//! ```text
//! I1 (4.3)   reflected    P_S/4 (1 - e^-X)/(μ_l+μ_v)
//!            transmitted  P_S/4 x/(μ_l μ_v) e^-m φ1(d)               φ1 = (1-e^-d)/d
//! I2 (4.4)   reflected    P_S²/8 (1 - (1+X) e^-X)/(μ_l+μ_v)
//!            transmitted  P_S²/8 x/(μ_l μ_v) e^-m (m φ1(d) + φ2(d))   φ2 = (1-(1+d)e^-d)/d
//! I3+ (4.5)  either       R_3+ or T_3+ times 1/(2μ_v), 1 or K(μ_v): see Emission
//! I0  (4.2)  transmitted  see [`halo`]
//! ```
//!
//! P_S² is the convolution on the sphere, moments χ_l². [`as_printed`] keeps the paper's own forms.
//!
//! * **Media.** I1, I2 and I3+ belong to the modified medium; [`halo`] (I0) to the full one.
//! * **Accuracy.** Nothing cancels and nothing overflows for x from 0 to 1e4 and μ from 1e-4 to 1, in f32 and f64:
//!   relative error of the weights below (4 + 2m) ε (m only where light goes through), until they underflow to 0. At μ_l = 0 the limit is taken.
//! * **What it is worth** against exact radiance: I1 exact in the modified medium; I2 and I3+ as the module of energy
//!   books in the tests says.

pub mod as_printed;
mod emission;
pub mod halo;
mod orders;
mod path;
mod sight;

pub use emission::Emission;
pub use orders::{Angular, Orders};
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
