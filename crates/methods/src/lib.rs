//! Every way to get the radiance or the fluxes of a cloud layer, behind one trait.
//!
//! A [`Method`] says what it is ([`Card`]) and prepares itself for a [`Cloud`]; what comes out, [`Ready`], answers lists of
//! [`Point`]s in double precision and, where it is code for a shader, single ones in f32 ([`Single`]). Whatever is asked outside of
//! the declared [`Domain`] is refused with a [`MethodError`]; no value is clamped.

mod card;
mod cloud;
mod error;
mod method;
mod point;

pub use card::{Card, Class, Domain};
pub use cloud::Cloud;
pub use error::MethodError;
pub use method::{Method, Ready, Single};
pub use point::{FluxPair, FluxPoint, Point};
