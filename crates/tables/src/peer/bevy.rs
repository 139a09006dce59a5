//! Bevy's chromatic phase texture (`PhaseFunction::ChromaticTexture` of `bevy_light`'s `ScatteringMedium`).
//!
//! Contract, read in bevy_light, bevy_image and bevy_pbr 0.20: an N×1 texture of `Rgba32Float`, columns at equal steps of
//! μ from -1 (back) to 1 (forward), linear between, each of r, g, b a phase function per steradian (∫p dμ = 1/2π, so
//! P/4π); alpha is not read. The image must load as one-dimensional: KTX2 of height 1 does, EXR does not and is ignored
//! in silence. Bevy then samples the curve into `phase_resolution` texels at μ = ±(1 - (1-|s|)²) for equal steps of s, so
//! set that at least as high as the peak needs. 8192 columns are the most that wgpu promises for such a texture.

use super::PeerFile;
use super::cosine::OverCosine;
use crate::TablesError;
use crate::colour::SrgbPhase;
use std::f64::consts::PI;
use stratiform_optics::phase::{Norm, PhaseTable};
use stratiform_quantities::Range;

/// Numbers of columns that are written.
pub const COLUMNS: Range = Range::closed(2.0, 8192.0);

/// The texels of `columns` columns, back to forward; alpha is 1.
///
/// # Errors
/// [`TablesError::Domain`] unless 2 ≤ `columns` ≤ 8192; [`TablesError::Optics`] for a channel that is negative or not
/// normalised.
pub fn chromatic_texture(colour: &SrgbPhase, columns: usize) -> Result<PeerFile<Vec<[f32; 4]>>, TablesError> {
    COLUMNS.check("columns of the phase texture", columns as f64)?;
    let mut content = vec![[1.0; 4]; columns];
    let mut quality = Vec::with_capacity(3);
    for channel in 0..3 {
        let p = colour.rgb.iter().map(|rgb| rgb[channel]).collect();
        let table = PhaseTable::new(colour.theta_deg.clone(), p, Norm::Strict)?;
        let over = OverCosine::equidistant(&table, columns);
        content.iter_mut().zip(&over.p).for_each(|(texel, p)| texel[channel] = (p / (4.0 * PI)) as f32);
        quality.push(over.reconstruction(&table));
    }
    Ok(PeerFile { content, quality })
}
