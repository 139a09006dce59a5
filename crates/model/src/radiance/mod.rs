//! Radiance of a lossless slab: single scattering exactly, everything beyond it as one fitted exponential.
//!
//! Reflectance factors πL/(μ_l F0), unscattered light left out, with τ and g of the full medium, τ' = (1-g)τ, u = τ'/(1+τ'),
//! s = μ_l+μ_v, p = μ_l μ_v, c = cosΘ and y = (4/3) τ' s:
//!
//! ```text
//! I  = I1 + M                     I1: single scattering in the modified medium, with P_S (angular::Angular::one)
//! M  = D exp(Σ_k c_k(u) B_k)      D = (y/(p+y))²/s at the top, the same / (1 + 0.7 τ') at the bottom
//! c_k(u) = Σ_j a_kj u^j           B_k = s^a p^b c^e: the 16 of EXPONENTS        j = 0…4, a table a_kj per face
//! ```
//!
//! * **Where it comes from.** I1 apart from the rest: Nakajima & Tanaka 1988 (TMS), Bouthors, Neyret & Lefebvre 2006. D has the
//!   limits of theory: τ² as order 2 has in thin slabs, 1/(μ_l+μ_v) and 1/(1 + 0.7τ') as the escape from thick ones
//!   (van de Hulst 1980). B_k are symmetric in μ_l and μ_v, as reciprocity demands; cosΘ carries the azimuth. The exponential
//!   keeps M positive, and makes the fit of relative errors a linear one.
//! * **Cost.** One look-up (P_S); no P_S², no fluxes, no table over θ_l.
//! * **Medium.** Lossless. The a_kj belong to one phase function; τ' as coordinate carries most of them to another.
//! * **Domain.** τ from 0 to 1e6, μ_l from 0, μ_v above 0; never negative, never NaN. **Error** and the points it was found at
//!   stand with the a_kj, in the file that the fit writes. Inside the sun's aureole (Θ < θ_f in transmission) light that met
//!   only forward events is not in it.

mod basis;
mod coefficients;
mod slab;

pub use basis::{EXPONENTS, TERMS, basis, saturation};
pub use coefficients::{Coefficients, POWERS};
pub use slab::{MU_L, MU_V, Slab, TAU, envelope};
