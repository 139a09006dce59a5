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
//! * **Medium.** Lossless. The a_kj belong to one phase function, but in τ' they hardly depend on the droplets.
//! * **Domain.** τ from 0 to 1e6, μ_l from 0, μ_v above 0; never negative, never NaN. Inside the sun's aureole (Θ < θ_f in
//!   transmission) light that met only forward events is not in it.
//! * **Error** relative to the exact radiance, median / 95th percentile / largest, with the a_kj of the paper's cloud (r_e 7 µm) at
//!   28 460 points that were not fitted, τ 1 to 50, θ_l and θ_v to 80°, Θ > 6° below: 0.9 / 3.6 / 15 % (the corrected model of 2006 with
//!   the best shape of I3+: 13 / 76 / 250 %). Thinner (from 0.003) and thicker (to 1e4) slabs: 0.9 / 4 / 6 %. Grazing 80–85°: 1.8 / 10 / 37 %,
//!   85–88°: 4.5 / 23 / 44 %. The same a_kj with g, P_f and P_S of r_e 4, 10, 20 µm: 1.2 / 5 / 22, 1.0 / 4 / 15, 1.6 / 6 / 27 %. Largest errors
//!   sit in the glory's centre, which forward events blur, and in forward grazing light of slabs of τ ≈ 1.

mod basis;
mod coefficients;
mod slab;

pub use basis::{EXPONENTS, TERMS, basis, saturation};
pub use coefficients::{Coefficients, POWERS};
pub use slab::{MU_L, MU_V, Slab, TAU, envelope};
