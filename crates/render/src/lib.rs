//! The picture of a world in real time: compute passes around the committed generated text.
//!
//! A ray a pixel goes to its first point in the cloud, a height field over a flat base. There the cloud is taken for a slab of thickness H,
//! whose radiance the generated text gives, over what lies behind (Bouthors, Neyret & Lefebvre 2006, sections 4 to 6, corrected). With
//! τ_v = e^{-κH/μ_v}, θ_v the angle of the line of sight to the vertical:
//!
//! ```text
//! from below   I^t C_sun + (T_ms(θ_v) - τ_v) L_sky + R_ms(θ_v) L_ground + τ_v L_background
//! from above   I^r C_sun + R_ms(θ_v) L_sky + (T_ms(θ_v) - τ_v) L_ground + τ_v L_background
//! ```
//!
//! L_sky and L_ground are irradiance/π: T_ms and R_ms of θ_v are exact for light that is the same from everywhere. The sun's light is
//! split by its wide events: one and two leave by the face's own normal, more by the vertical; (V·N)(L·N) > 0 tells reflected from transmitted.
//!
//! Radiance is in units of the sun's irradiance normal to its beam, linear sRGB. Lines of sight nearer than 1e-3 rad to the horizontal are
//! followed at 1e-3.

mod check;
mod cloud;
mod error;
mod field;
mod generated;
mod ground_light;
mod outside;
mod parameters;
mod phase_table;
mod pyramid;
pub mod radiosity;
mod readback;
mod renderer;
mod settings;
pub mod twin;
mod view;

pub use error::RenderError;
pub use ground_light::GroundLight;
pub use renderer::{PassTime, Renderer};
pub use settings::{Contributions, Depth, Emissions, Model, Normals, Radiosity, RingRule, Settings};
