//! Phase functions: one trait, and its implementations, one file each.

mod cell;
mod chords;
mod draine;
mod expand;
pub(crate) mod gauss;
mod guide;
mod halo;
mod henyey_greenstein;
mod isotropic;
mod legendre;
mod linear;
mod modified;
mod peak;
mod rayleigh;
mod read;
mod table;

pub use draine::Draine;
pub use gauss::gauss_legendre;
pub use halo::{Halo, HaloTable};
pub use henyey_greenstein::HenyeyGreenstein;
pub use isotropic::Isotropic;
pub use modified::Modified;
pub use rayleigh::Rayleigh;
pub use read::{PhaseRow, read_moments};
pub use table::{NORM, Norm, PhaseTable};

/// A phase function P with mean 1 over the sphere, as a probability law of v = 1 - cosΘ ∈ \[0, 2\].
///
/// v, not cosΘ, is the variable throughout: near the forward direction it keeps the digits that cosΘ loses.
/// The density of v is P/2.
pub trait PhaseFunction: Send + Sync {
    /// P at v = 1 - cosΘ.
    fn value(&self, v: f64) -> f64;

    /// Replaces each v by P(v), equal to [`value`](Self::value) but for rounding and 1e-11 in Θ; many at once may be faster.
    fn values_at(&self, v: &mut [f64]) {
        v.iter_mut().for_each(|v| *v = self.value(*v));
    }

    /// Probability that 1 - cosΘ ≤ v.
    fn cumulative(&self, v: f64) -> f64;

    /// The v at which [`cumulative`](Self::cumulative) equals `xi` ∈ \[0, 1): inversion, the sampler.
    fn invert(&self, xi: f64) -> f64;

    /// Asymmetry parameter g, the mean of cosΘ.
    fn asymmetry(&self) -> f64;

    /// Legendre moments χ_0 … χ_{count-1}, χ_l = ½∫P·P_l dcosΘ.
    fn moments(&self, count: usize) -> Vec<f64>;

    /// What scattering below v = `edge` contributes to the moments: ½∫P·P_l dcosΘ over 1 - cosΘ < `edge`.
    fn peak_moments(&self, edge: f64, count: usize) -> Vec<f64> {
        legendre::below_smooth(|v| self.value(v), angle(edge), count)
    }
}

/// Θ in radians of v = 1 - cosΘ ∈ \[0, 2\]; what rounding puts outside is taken to the end.
pub fn angle(v: f64) -> f64 {
    2.0 * libm::asin((0.5 * v).clamp(0.0, 1.0).sqrt())
}

/// v = 1 - cosΘ of Θ in radians, with all its digits near 0: 2 sin²(Θ/2).
pub fn versine(theta: f64) -> f64 {
    let sine = libm::sin(0.5 * theta);
    2.0 * sine * sine
}
