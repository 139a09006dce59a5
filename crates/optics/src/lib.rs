//! From droplets to phase functions: water index, droplet distributions, Mie theory, and every
//! phase function the project knows.

pub mod phase;
pub mod sampling;
