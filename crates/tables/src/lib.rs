//! Phase functions and parameter tables as others load them, and what is wrong with somebody else's table.

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
