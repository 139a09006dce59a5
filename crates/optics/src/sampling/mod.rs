//! Fast samplers of scattering angles.

mod table;
#[cfg(test)]
mod tests;

pub use table::SamplingTable;
