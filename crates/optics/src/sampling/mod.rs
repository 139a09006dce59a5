//! Fast samplers of scattering angles.

mod table;

pub use table::SamplingTable;
