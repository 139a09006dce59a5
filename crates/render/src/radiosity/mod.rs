//! Light between ground and cloud: Bouthors, Neyret & Lefebvre 2006, section 5, corrected.
//!
//! Two facing planes at distance h, the cloud's base and the ground; lengths in metres, radiosity and irradiance in units of the sun's
//! irradiance normal to its beam. Per texel, ρ the albedos, K the [`Weights`] from plane to plane:
//!
//! ```text
//! S_G(p) = μ_l F_0 T_{0+1+2}(θ_l, H(p + h tanθ_l))    direct light of the ground, at the height field's resolution
//! S_C    = T_3+(θ_l) μ_l F_0 + T_ms(diffuse) E_sky    what the base gives out by itself, the sky in gaps among it
//! G_0 = K S_C        C_1 = K ρ_G (S_G + G_0)        G_i = K ρ_C C_i        C_{i+1} = K ρ_G G_i
//! R_G = Σ G_i        R_C = Σ C_i                    irradiance of the ground beside S_G, and of the base
//! ```
//!
//! ρ_C = R_ms in diffuse light. The planes are those of the printed method: the cloud's own thickness above its base throws no shadow.

mod error;
mod exchange;
pub mod form_factor;
mod least_squares;
mod passes;
mod plan;
mod slab;
mod texels;
mod twin;
mod weights;

pub use error::RadiosityError;
pub use exchange::{Buffers, Exchange, Step};
pub use passes::{MOST_PASSES, kept, passes_for};
pub use plan::Plan;
pub use slab::Slab;
pub use texels::Texels;
pub use twin::{Light, Planes, Received, ground_direct, planes};
pub use weights::{Weights, side_for};
