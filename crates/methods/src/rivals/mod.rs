//! The methods, a file each.

pub(crate) mod asymptotic;
pub(crate) mod beer_powder;
pub(crate) mod bouthors;
pub(crate) mod fitted;
pub(crate) mod monte_carlo;
pub(crate) mod multiple_forward;
pub(crate) mod octaves;
pub(crate) mod single_scattering;
pub(crate) mod solver;
pub(crate) mod successive;
pub(crate) mod two_stream;
