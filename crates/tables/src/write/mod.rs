//! Containers: CSV, JSON, npz, EXR, KTX2. Each writer is a pure function to bytes; the same set gives the same bytes.
//!
//! | container | numbers | layout of phase functions |
//! | --- | --- | --- |
//! | CSV | f64 | a line per texel: index, coordinate, theta_deg, then a column `function_channel` each; metadata in `#` lines |
//! | JSON | f64 | schema `stratiform/phase-table/1` |
//! | npz | f64 | `p[function, channel, texel]`, theta_deg, coordinate, names, metadata |
//! | EXR | f32 | width = texels, height = functions, a channel per wavelength or R, G, B; scan lines, ZIP |
//! | KTX2 | f32, f16 | width = texels, height = functions × groups of 4 channels, RGBA |
//!
//! Parameter tables ([`ParameterTexels`](crate::parameters::ParameterTexels)) have a column (EXR, KTX2) or line (CSV) per
//! angle. EXR: height 1, channels named as [`COLUMNS`](crate::parameters::COLUMNS). KTX2: row 0 is (b, 1/c, t, μ_l), row 1 is
//! (1/κ_c, 1/r, 0, μ_l).
//!
//! Texel i of N stands at u = i/(N-1) of the angle map: a texture is looked up at s = (u(N-1) + ½)/N, filtered
//! linearly along the texels and not across rows. Units: Θ in degrees, P without unit, mean 1 over the sphere.

mod csv;
mod exr;
mod json;
mod ktx2;
mod metadata;
mod npy;
mod npz;
mod parameters;
mod precision;
mod zip;

pub use csv::phase_csv;
pub use exr::phase_exr;
pub use json::{PhaseDocument, phase_json};
pub use ktx2::phase_ktx2;
pub(crate) use ktx2::texels_ktx2;
pub use metadata::{AngleMap, Metadata, RowMetadata};
pub use npz::phase_npz;
pub use parameters::{
    parameters_csv, parameters_exr, parameters_json, parameters_ktx2, parameters_npz, rounding,
};
pub use precision::Precision;
