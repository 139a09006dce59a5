//! The field's words as types, and the conventions every other crate follows. No formula of
//! scattering lives here.
//!
//! # Conventions
//!
//! * **Scattering angle.** Θ is the angle between the directions of flight before and after:
//!   cosΘ = +1 is forward.
//! * **Phase function.** P(cosΘ) has mean 1 over the sphere: ½∫P dcosΘ = 1. The density per
//!   steradian is P/4π. Legendre moments are χ_l = ½∫P·P_l dcosΘ, so χ_0 = 1 and χ_1 = g; no
//!   factor 2l+1 is included.
//! * **Directions.** Light enters through the top of the slab. μ0 = cosθ_l ∈ \[0, 1\] is the cosine
//!   of the sun's zenith angle; μ0 = 0 is the limit in which the first collision happens at the
//!   surface. φ = 0 means that exiting light keeps the sun's azimuth.
//! * **Fluxes.** Reflectance R and transmittance T are fluxes per unit flux incident on the slab.
//! * **Thickness.** τ is the extinction optical thickness of the *full* medium, measured along the
//!   normal, whichever medium is traced. H is the geometrical thickness in metres, κ the extinction
//!   per metre, τ = κH.
//! * **Medium.** *Full* is the medium as it is. *Modified* moves scattering by less than θ_f into the
//!   unscattered beam: κ_S = (1 - P_f)κ, P_S = P/(1 - P_f) for Θ ≥ θ_f and 0 below (Bouthors, Neyret
//!   & Lefebvre 2006, section 4.1, whose inequality is printed the wrong way round). Orders in the
//!   modified medium count wide events only.
//! * **Refractive index.** m = n + ik with k ≥ 0 absorbing (Bohren & Huffman 1983).

pub mod angle_map;
mod domain;
mod order;
mod side;
mod types;

pub use domain::{DomainError, Range};
pub use order::Order;
pub use side::Side;
pub use types::{
    Asymmetry, CosZenith, ExtinctionConvention, Incidence, Medium, OpticalThickness, SingleScatteringAlbedo,
};
