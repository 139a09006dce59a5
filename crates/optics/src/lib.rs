//! From droplets to phase functions: water index, droplet distributions, Mie theory, and every
//! phase function the project knows.
//!
//! [`OpticsConfig`] → [`compute`] (or [`load_or_compute`]) → [`ensemble::Ensemble`] per wavelength → [`write`](fn@write).
//! One sphere is [`mie::scatter`]; phase functions stand in [`phase`].

mod cache;
mod config;
pub mod droplets;
pub mod ensemble;
mod error;
pub mod mie;
pub mod phase;
mod run;
pub mod sampling;
pub mod water;

pub use cache::load_or_compute;
pub use config::OpticsConfig;
pub use error::OpticsError;
pub use run::{compute, write};
