//! The deterministic solver: fluxes of a plane-parallel slab without noise, with an estimated error.
//!
//! **Method.** Discrete ordinates. Against adding–doubling: one eigenproblem serves every thickness (doubling starts again
//! for each), nothing is lost at τ = 1e-6 or 1e4, and a lossless medium needs no special case. Two things differ from DISORT:
//! - *One diffusely lit problem* replaces one beam problem for each μ0. By reciprocity its emergent radiance towards μ0 is the plane
//!   albedo and transmittance for light from μ0 ([`slab`]). μ0 = 0 and μ0 on a stream are ordinary values.
//! - *Every moment counts with any number of streams*: the phase function is projected on half-range polynomials
//!   ([`kernel`]) instead of sampled. δ-M is the limit of this for a peak narrower than all streams, so no truncation is chosen.
//!
//! Fluxes need the azimuthal mean only. Units: reflectance and transmittance per incident flux; τ of the full medium.

mod grid;
mod jacobi;
mod kernel;
mod matrix;
mod medium;
mod modes;
mod orders;
mod quadrature;
mod slab;
mod solved;
mod solver;

pub use medium::SolveMedium;
pub use solved::Solved;
pub use solver::Solver;
