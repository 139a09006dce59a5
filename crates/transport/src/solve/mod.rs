//! The deterministic solver: fluxes of a plane-parallel slab without noise, with an estimated error.
//!
//! **Method.** Discrete ordinates for totals (`modes`, `slab`), successive orders for single ones
//! (`orders`, `grid`). Against adding–doubling: one eigenproblem serves every thickness (doubling
//! starts again for each), nothing is lost at τ = 1e-6 or 1e4, and a lossless medium needs no special case.
//! Three things differ from DISORT (Stamnes et al. 1988):
//! - *One diffusely lit problem* replaces a beam problem for each μ0. By reciprocity its emergent radiance
//!   towards μ0 is the plane albedo, or the transmittance, for light from μ0. μ0 = 0 and μ0 on a stream are
//!   ordinary values.
//! - *Every moment counts with any number of streams*: the phase function is projected on half-range
//!   polynomials (`kernel`) instead of sampled. δ-M is the limit of this for a peak narrower than all
//!   streams: no truncation is chosen.
//! - *Streams are Gauss points in the cube root of μ* (`quadrature`), which resolves the singularities at
//!   grazing and, at μ0 = 0, slabs down to τ = 1e-6.
//!
//! Streams are added until the results agree (`solver`); the error reported is the last change. Fluxes
//! need the azimuthal mean only. Units: reflectance and transmittance per incident flux; τ of the full
//! medium. Domain: τ from 0 to 1e6, μ0 from 0 to 1, ω from 0 to 1, orders to 60. Errors:
//! [`TransportError`](crate::TransportError).

mod grid;
mod jacobi;
mod kernel;
mod matrix;
mod medium;
mod modes;
mod orders;
mod panel;
mod product;
mod quadrature;
mod radiance;
mod slab;
mod solved;
mod solver;
mod sweep;

pub use medium::SolveMedium;
pub use radiance::{RadianceOrder, RadianceSolver, Radiances, View};
pub use solved::Solved;
pub use solver::Solver;
