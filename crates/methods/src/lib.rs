//! Every way to get the radiance or the fluxes of a cloud layer, behind one trait.
//!
//! A [`Method`] says what it is ([`Card`]) and prepares itself for a [`Cloud`]; what comes out, [`Ready`], answers lists of
//! [`Point`]s in double precision and, where it is code for a shader, single ones in f32 ([`Single`]). Whatever is asked outside of
//! the declared [`Domain`] is refused with a [`MethodError`]; no value is clamped.

mod card;
mod cloud;
mod error;
mod grid;
mod lobe;
mod lookup;
mod method;
mod point;
mod registry;
mod rivals;
mod scalar;
mod shade;
mod simple;

pub use card::{Card, Class, Domain};
pub use cloud::Cloud;
pub use error::MethodError;
pub use lookup::{EMITTED_TEXELS, Exact, Texels};
pub use method::{Method, Ready, Single};
pub use point::{FluxPair, FluxPoint, Point};
pub use registry::{Knob, all, by_name, knobs};
pub use scalar::Scalar;
