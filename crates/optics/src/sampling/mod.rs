//! Fast samplers of scattering angles: [`SamplingTable`] in double precision, [`LinearPieces`] in single.

mod pieces;
mod table;
#[cfg(test)]
mod tests;

pub use pieces::LinearPieces;
pub use table::SamplingTable;
