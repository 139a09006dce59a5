//! The one-dimensional model of a stratiform layer's fluxes: pure functions that know no solver.
//!
//! Bouthors, Neyret & Lefebvre, *Real-time realistic illumination and shading of stratiform clouds*
//! (Eurographics Workshop on Natural Phenomena 2006), appendix A. With thickness H and x = κ_c H:
//!
//! ```text
//! T_ms = (b + (1-b) e^(-cH)) β / (H - (H-1)β)      R_ms = 1 - T_ms
//! T_0  = e^(-κ_S H/μ_l), or 2 E_3(κ_S H) in diffuse light
//! T_1  = t x e^-x                                  R_1  = r/2 (1 - e^-2x)
//! T_2  = (tx)²/2 e^-x + r²/4 e^-x (2x-1+e^-2x)     R_2  = rt/2 (1 - (1+2x) e^-2x)
//! T_3+ = T_ms - T_0 - T_1 - T_2                    R_3+ = R_ms - R_1 - R_2
//! ```
//!
//! * **Unit of thickness.** The parameters' own: metres, or optical thickness of the full medium. c, κ_c and
//!   κ_S are per that unit, and β is T_ms at thickness 1.
//! * **Medium.** κ_S belongs to the modified medium, in which the orders are counted.
//! * **Printed and corrected.** [`Form::AsPrinted`] keeps the paper's slip in T_2b, [`Form::Corrected`] mends it.
//! * **Accuracy.** Nothing cancels from optical thickness 1e-8 to 1e4: relative error below (6 + 4 X) ε, with ε the
//!   machine epsilon of f32 or f64 and X the longest path κ_S H/μ_l or κ_c H whose exponential is taken; for T_3+,
//!   R_3+ (and R_ms where b > 1) relative to the largest term of the difference.
//! * **Domain.** [`Parameters`] and [`Thickness`] refuse what lies outside. Results are never clamped: a value
//!   that no flux can have is found by [`problems`].

pub mod angular;
pub mod asymptotic;
mod brackets;
pub mod derivatives;
mod error;
mod exponential_integral;
pub mod family;
mod fluxes;
mod parameters;
mod problems;
pub mod radiance;
mod real;
pub mod table;

pub use error::ModelError;
pub use exponential_integral::exponential_integral_e3;
pub use fluxes::{Fluxes, Form};
pub use parameters::{Parameters, Thickness, Values};
pub use problems::{Problem, problems};
pub use real::Real;
