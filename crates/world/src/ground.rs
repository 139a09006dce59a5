//! What lies below the cloud.

use crate::Map;

/// The plane z = 0, which gives light back the same in all directions.
#[derive(Clone, Debug, PartialEq)]
pub struct Ground {
    /// Albedo in linear sRGB, each in [0, 1].
    pub albedo: Map<[f64; 3]>,
}
