//! Phase functions and parameter tables as others load them, and what is wrong with somebody else's table.
//!
//! [`set::PhaseSet`] (full, modified, squared; a channel per wavelength, or linear sRGB by [`colour`]) is sampled on the angle map
//! of `stratiform_quantities` ([`sampled`]), judged ([`card`]) and put into a container ([`mod@write`]) or another program's own
//! file ([`peer`]). [`parameters`] does the same for the fitted table. [`read`] takes in other people's tables as they
//! stand, [`diagnosis`] says what is wrong with them, [`nearest`] finds analytic functions near them.
//!
//! | file | numbers | what it holds |
//! | --- | --- | --- |
//! | CSV, JSON, npz | f64 | all functions and channels, with the map and where they come from |
//! | EXR | f32 | a row per function, a channel per wavelength (R, G, B for colour) |
//! | KTX2 | f32 or f16 | the same, four channels |
//! | Mitsuba, Eradiate, MCX, DISORT, Bevy | as they want | P of the full medium by that program's convention |
//!
//! Nothing here touches the disk but [`read`]: writers return bytes.

pub mod card;
pub mod colour;
pub mod diagnosis;
mod error;
pub mod nearest;
pub mod parameters;
pub mod peer;
pub mod read;
pub mod sampled;
pub mod set;
mod tridiagonal;
pub mod write;

pub use error::TablesError;
