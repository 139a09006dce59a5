//! The methods, a file each.

pub(crate) mod monte_carlo;
pub(crate) mod octaves;
pub(crate) mod single_scattering;
pub(crate) mod solver;
pub(crate) mod two_stream;
